#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>
#include <optional>

namespace cutwater::detail {

namespace {

/// The axis to double next: the shortest in space among those worth doubling.
std::optional<std::size_t> shortest(const Offset& shape, const std::array<double, 3>& spacing,
                                    const std::array<std::size_t, 3>& lengths) {
  std::optional<std::size_t> best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (shape[axis] >= lengths[axis] || shape[axis] == TileOrder::kLongest) continue;
    if (!best || shape[axis] * spacing[axis] < shape[*best] * spacing[*best]) best = axis;
  }
  return best;
}

}  // namespace

GridTiles::GridTiles(const IndexBox& indices, const Offset& shape) : shape_(shape) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lengths_[axis] = indices.length(static_cast<int>(axis));
    counts_[axis] = (lengths_[axis] + shape[axis] - 1) / shape[axis];
  }
}

OffsetBox GridTiles::tile(std::size_t number) const {
  OffsetBox tile;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t edge = shape_[axis];
    const auto first = number % counts_[axis] * edge;
    number /= counts_[axis];
    tile.first[axis] = static_cast<std::uint32_t>(first);
    tile.size[axis] = static_cast<std::uint32_t>(std::min(edge, lengths_[axis] - first));
  }
  return tile;
}

TileOrder::TileOrder(const std::array<double, 3>& spacing,
                     const std::array<std::size_t, 3>& lengths, int bits) {
  shapes_[0] = {1, 1, 1};
  std::array<std::size_t, kMostBits> axes{};  // the axis that each bit of a number counts along
  for (; bits_ < bits; ++bits_) {
    const auto level = static_cast<std::size_t>(bits_);
    const auto axis = shortest(shapes_[level], spacing, lengths);
    if (!axis) break;
    axes[level] = *axis;
    shapes_[level + 1] = shapes_[level];
    shapes_[level + 1][*axis] *= 2;
  }
  for (std::uint32_t number = 0; number < kTable; ++number) {
    for (std::size_t bit = 0; bit < static_cast<std::size_t>(bits_); ++bit) {
      auto& table = bit < 6 ? low_ : high_;
      const std::uint32_t isSet = number >> bit % 6 & 1U;
      table[number][axes[bit]] += isSet * shapes_[bit][axes[bit]];
    }
  }
}

}  // namespace cutwater::detail
