#pragma once

#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Grid/Detail/TileOrder.hpp>

#include <cstddef>

namespace cutwater::detail {

/// A block of neighbouring indices of a patch.
struct GridBlock {
  Offset first{};
  Offset size{};
};

/// A patch divided into numbered blocks of one shape, x fastest; blocks at its ends are truncated.
class PatchBlocks {
 public:
  PatchBlocks(const IndexBox& indices, const Offset& shape);

  [[nodiscard]] std::size_t count() const { return counts_[0] * counts_[1] * counts_[2]; }
  [[nodiscard]] GridBlock block(std::size_t number) const;

 private:
  Offset shape_;
  std::array<std::size_t, 3> lengths_{};  // of the patch
  std::array<std::size_t, 3> counts_{};   // of blocks
};

}  // namespace cutwater::detail
