#include <Cutwater/Grid/Detail/PatchBlocks.hpp>

#include <algorithm>

namespace cutwater::detail {

PatchBlocks::PatchBlocks(const IndexBox& indices, const Offset& shape) : shape_(shape) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lengths_[axis] = indices.length(static_cast<int>(axis));
    counts_[axis] = (lengths_[axis] + shape[axis] - 1) / shape[axis];
  }
}

GridBlock PatchBlocks::block(std::size_t number) const {
  GridBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t edge = shape_[axis];
    const auto first = number % counts_[axis] * edge;
    number /= counts_[axis];
    block.first[axis] = static_cast<std::uint32_t>(first);
    block.size[axis] = static_cast<std::uint32_t>(std::min(edge, lengths_[axis] - first));
  }
  return block;
}

}  // namespace cutwater::detail
