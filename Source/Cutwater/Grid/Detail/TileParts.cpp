#include <Cutwater/Grid/Detail/TileParts.hpp>

namespace cutwater::detail {

OffsetBox indicesOf(const TileOrder& order, const OffsetBox& tile, std::uint32_t number, int bits) {
  const auto offset = order.offset(number);
  OffsetBox indices;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (offset[axis] >= tile.size[axis]) return {};
    indices.first[axis] = tile.first[axis] + offset[axis];
    indices.size[axis] = std::min(order.shape(bits)[axis], tile.size[axis] - offset[axis]);
  }
  return indices;
}

}  // namespace cutwater::detail
