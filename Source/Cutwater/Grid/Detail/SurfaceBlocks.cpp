#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/SurfaceBlocks.hpp>

#include <algorithm>
#include <optional>

namespace cutwater::detail {

namespace {

/// Blocks along each side of the cube that a thread classifies in one go, as a power of two.
constexpr int kTileBits = 2;

}  // namespace

template <std::floating_point T>
SurfaceBlocks<T>::SurfaceBlocks(const SurfaceGrid<T>& grid, const ParallelOptions& options) {
  NodeOffset tiles{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts_[axis] = (grid.count(axis) - 2) / SurfaceBlock<T>::kCells + 1;
    tiles[axis] = ((counts_[axis] - 1) >> kTileBits) + 1;
  }
  block_.assign(std::size_t{counts_[0]} * counts_[1] * counts_[2], kOutside);
  const std::size_t tileCount = std::size_t{tiles[0]} * tiles[1] * tiles[2];
  parallelFor(tileCount, {.threads = options.threads}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      const auto place = [&](std::size_t at) {
        return static_cast<std::uint32_t>(at) << static_cast<unsigned>(kTileBits);
      };
      classify(
          grid,
          {place(n % tiles[0]), place(n / tiles[0] % tiles[1]), place(n / tiles[0] / tiles[1])},
          kTileBits, {});
    }
  });

  std::vector<NodeOffset> first;
  for (std::size_t n = 0; n < block_.size(); ++n) {
    if (block_[n] == kOutside || block_[n] == kInside) continue;
    block_[n] = static_cast<std::uint32_t>(first.size());
    const auto node = [](std::size_t at) {
      return static_cast<std::uint32_t>(at) * SurfaceBlock<T>::kCells;
    };
    first.push_back({node(n % counts_[0]), node(n / counts_[0] % counts_[1]),
                     node(n / counts_[0] / counts_[1])});
  }
  std::vector<std::optional<SurfaceBlock<T>>> made(first.size());
  parallelFor(first.size(), options, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) made[n].emplace(grid, first[n]);
  });
  blocks_.reserve(made.size());
  std::size_t points = 0;
  firstPoint_.reserve(made.size() + 1);
  firstPoint_.push_back(0);
  for (auto& block : made) {
    points += block->points().size();
    if (points >= kNone) throw Error(ErrorKind::Limit, "isosurface: more than 2^32 - 2 points");
    firstPoint_.push_back(static_cast<std::uint32_t>(points));
    blocks_.push_back(std::move(*block));
  }
}

template <std::floating_point T>
void SurfaceBlocks<T>::classify(const SurfaceGrid<T>& grid, const NodeOffset& first, int bits,
                                BoxHint hint) {
  NodeOffset last{};  // one past the last block
  NodeOffset lower{};
  NodeOffset upper{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (first[axis] >= counts_[axis]) return;
    last[axis] = std::min(first[axis] + (1U << static_cast<unsigned>(bits)), counts_[axis]);
    lower[axis] = first[axis] * SurfaceBlock<T>::kCells;
    upper[axis] = std::min(last[axis] * SurfaceBlock<T>::kCells, grid.count(axis) - 1);
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
        block_[i + counts_[0] * (j + std::size_t{counts_[1]} * k)] = state;
      }
    }
  }
}

template <std::floating_point T>
void SurfaceBlocks<T>::takePoints(std::vector<Vec3<double>>& points) {
  points.reserve(points.size() + pointCount());
  for (auto& block : blocks_) {
    points.insert(points.end(), block.points().begin(), block.points().end());
    block.releasePoints();
  }
}

template <std::floating_point T>
std::uint32_t SurfaceBlocks<T>::blockOf(const NodeOffset& node) const {
  NodeOffset at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = std::min(node[axis] / SurfaceBlock<T>::kCells, counts_[axis] - 1);
  }
  return block_[at[0] + counts_[0] * (at[1] + std::size_t{counts_[1]} * at[2])];
}

template <std::floating_point T>
bool SurfaceBlocks<T>::isInside(const NodeOffset& node) const {
  const auto block = blockOf(node);
  if (block == kInside || block == kOutside) return block == kInside;
  const auto& first = blocks_[block].first();
  return blocks_[block].isInside({node[0] - first[0], node[1] - first[1], node[2] - first[2]});
}

template <std::floating_point T>
std::uint32_t SurfaceBlocks<T>::edgePoint(const NodeOffset& node, int axis) const {
  const auto block = blockOf(node);
  if (block >= blocks_.size()) {
    throw Error(ErrorKind::Argument, "isosurface: values contradict what the solid guarantees");
  }
  const auto& first = blocks_[block].first();
  return firstPoint_[block] +
         blocks_[block].edgePoint({node[0] - first[0], node[1] - first[1], node[2] - first[2]},
                                  axis);
}

template class SurfaceBlocks<float>;
template class SurfaceBlocks<double>;

}  // namespace cutwater::detail
