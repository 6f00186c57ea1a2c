#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/SurfaceTiles.hpp>

#include <algorithm>
#include <optional>

namespace cutwater::detail {

namespace {

/// Tiles along each side of a group that a thread classifies in one go, as a power of two.
constexpr int kGroupBits = 2;

}  // namespace

template <std::floating_point T>
SurfaceTiles<T>::SurfaceTiles(const SurfaceGrid<T>& grid, const ParallelOptions& options) {
  NodeOffset groups{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts_[axis] = (grid.count(axis) - 2) / SurfaceTile<T>::kCells + 1;
    groups[axis] = ((counts_[axis] - 1) >> kGroupBits) + 1;
  }
  numbers_.assign(std::size_t{counts_[0]} * counts_[1] * counts_[2], kOutside);
  const std::size_t groupCount = std::size_t{groups[0]} * groups[1] * groups[2];
  parallelFor(groupCount, {.threads = options.threads}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto place = [&](std::size_t at) {
        return static_cast<std::uint32_t>(at) << static_cast<unsigned>(kGroupBits);
      };
      classify(grid,
               {place(n % groups[0]), place(n / groups[0] % groups[1]),
                place(n / groups[0] / groups[1])},
               kGroupBits, {});
    }
  });

  std::vector<NodeOffset> first;
  for (std::size_t n = 0; n < numbers_.size(); ++n) {
    if (numbers_[n] == kOutside || numbers_[n] == kInside) continue;
    numbers_[n] = static_cast<std::uint32_t>(first.size());
    const auto node = [](std::size_t at) {
      return static_cast<std::uint32_t>(at) * SurfaceTile<T>::kCells;
    };
    first.push_back({node(n % counts_[0]), node(n / counts_[0] % counts_[1]),
                     node(n / counts_[0] / counts_[1])});
  }
  std::vector<std::optional<SurfaceTile<T>>> made(first.size());
  parallelFor(first.size(), options, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) made[n].emplace(grid, first[n]);
  });
  tiles_.reserve(made.size());
  std::size_t points = 0;
  firstPoint_.reserve(made.size() + 1);
  firstPoint_.push_back(0);
  for (auto& tile : made) {
    points += tile->points().size();
    if (points >= kNone) throw Error(ErrorKind::Limit, "isosurface: more than 2^32 - 2 points");
    firstPoint_.push_back(static_cast<std::uint32_t>(points));
    tiles_.push_back(std::move(*tile));
  }
}

template <std::floating_point T>
void SurfaceTiles<T>::classify(const SurfaceGrid<T>& grid, const NodeOffset& first, int bits,
                               BoxHint hint) {
  NodeOffset last{};  // one past the last tile
  NodeOffset lower{};
  NodeOffset upper{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (first[axis] >= counts_[axis]) return;
    last[axis] = std::min(first[axis] + (1U << static_cast<unsigned>(bits)), counts_[axis]);
    lower[axis] = first[axis] * SurfaceTile<T>::kCells;
    upper[axis] = std::min(last[axis] * SurfaceTile<T>::kCells, grid.count(axis) - 1);
  }
  const auto kind = grid.solid.classify({grid.position(lower), grid.position(upper)}, &hint);
  if (mayBeCut(kind) && bits > 0) {
    const std::uint32_t half = 1U << static_cast<unsigned>(bits - 1);
    for (unsigned part = 0; part < 8; ++part) {
      classify(grid,
               {first[0] + (part & 1U) * half, first[1] + (part >> 1U & 1U) * half,
                first[2] + (part >> 2U) * half},
               bits - 1, hint);
    }
    return;
  }
  const std::uint32_t state = mayBeCut(kind) ? 0 : kind == BoxClass::Inside ? kInside : kOutside;
  for (auto k = first[2]; k < last[2]; ++k) {
    for (auto j = first[1]; j < last[1]; ++j) {
      for (auto i = first[0]; i < last[0]; ++i) {
        numbers_[i + counts_[0] * (j + std::size_t{counts_[1]} * k)] = state;
      }
    }
  }
}

template <std::floating_point T>
void SurfaceTiles<T>::takePoints(std::vector<Vec3<double>>& points) {
  points.reserve(points.size() + pointCount());
  for (auto& tile : tiles_) {
    points.insert(points.end(), tile.points().begin(), tile.points().end());
    tile.releasePoints();
  }
}

template <std::floating_point T>
std::uint32_t SurfaceTiles<T>::numberAt(const NodeOffset& node) const {
  NodeOffset at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = std::min(node[axis] / SurfaceTile<T>::kCells, counts_[axis] - 1);
  }
  return numbers_[at[0] + counts_[0] * (at[1] + std::size_t{counts_[1]} * at[2])];
}

template <std::floating_point T>
bool SurfaceTiles<T>::isInside(const NodeOffset& node) const {
  const auto tile = numberAt(node);
  if (tile == kInside || tile == kOutside) return tile == kInside;
  const auto& first = tiles_[tile].first();
  return tiles_[tile].isInside({node[0] - first[0], node[1] - first[1], node[2] - first[2]});
}

template <std::floating_point T>
std::uint32_t SurfaceTiles<T>::edgePoint(const NodeOffset& node, int axis) const {
  const auto tile = numberAt(node);
  if (tile >= tiles_.size()) {
    throw Error(ErrorKind::Argument, "isosurface: values contradict what the solid guarantees");
  }
  const auto& first = tiles_[tile].first();
  return firstPoint_[tile] +
         tiles_[tile].edgePoint({node[0] - first[0], node[1] - first[1], node[2] - first[2]}, axis);
}

template class SurfaceTiles<float>;
template class SurfaceTiles<double>;

}  // namespace cutwater::detail
