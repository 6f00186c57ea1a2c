#pragma once

#include <Cutwater/Operations/Detail/Forwarding.hpp>

namespace cutwater {

/// The operand under a name. If all its patches share one name, they take the new one; otherwise
/// each name is prefixed with it, as in "mast/shroud". Nothing else changes.
///
/// @throws Error if the name is empty.
template <std::floating_point T>
class Labelled final : public Forwarding<T, Labelled<T>> {
 public:
  Labelled(Solid<T> operand, std::string name);

 private:
  std::string localName() const override { return "Named \"" + name_ + "\""; }
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override {
    return this->facetsOf(this->operand(), box, visit);
  }
  Guarantee<T> localGuarantee() const override { return this->operand().guarantee(); }
  Box<T> localBoundingBox() const override { return this->operand().boundingBox(); }
  Box<T> localClearanceBox() const override { return this->operand().clearanceBox(); }
  std::vector<std::string> localPatchNames() const override;

  std::string name_;
};

extern template class Labelled<float>;
extern template class Labelled<double>;

}  // namespace cutwater
