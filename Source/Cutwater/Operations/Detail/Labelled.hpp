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
  Labelled(Solid<T> solid, std::string name);

  using UnaryOperation<T>::operand;

 private:
  std::string localName() const override { return "Named \"" + name_ + "\""; }
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override {
    return this->facetsOf(operand(), box, visit);
  }
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override {
    this->surfacesOf(operand(), box, visit);
    return true;
  }
  Guarantee<T> localGuarantee() const override { return operand().guarantee(); }
  Box<T> localBoundingBox() const override { return operand().boundingBox(); }
  Box<T> localClearanceBox() const override { return operand().clearanceBox(); }
  std::vector<std::string> localPatchNames() const override;

  std::string name_;
};

extern template class Labelled<float>;
extern template class Labelled<double>;

}  // namespace cutwater
