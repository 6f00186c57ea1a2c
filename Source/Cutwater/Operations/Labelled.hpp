#pragma once

#include <Cutwater/Operations/UnaryOperation.hpp>

namespace cutwater {

/// The operand under a name: a single patch takes the name, several are prefixed with it, as in
/// "mast/shroud". Nothing else changes.
///
/// @throws Error if the name is empty.
template <std::floating_point T>
class Labelled final : public UnaryOperation<T> {
 public:
  Labelled(Solid<T> operand, std::string name);

 private:
  [[nodiscard]] std::string localName() const override { return "Named \"" + name_ + "\""; }
  [[nodiscard]] std::vector<std::string> localPatchNames() const override;

  std::string name_;
};

extern template class Labelled<float>;
extern template class Labelled<double>;

}  // namespace cutwater
