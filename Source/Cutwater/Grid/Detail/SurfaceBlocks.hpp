#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/Detail/SurfaceBlock.hpp>

namespace cutwater::detail {

/// All blocks of a grid that the surface may pass through; blocks that are certainly free of it are
/// not evaluated.
template <std::floating_point T>
class SurfaceBlocks {
 public:
  /// @throws Error of kind Limit if there are more than 2^32 - 2 points.
  SurfaceBlocks(const SurfaceGrid<T>& grid, const ParallelOptions& options);

  [[nodiscard]] std::span<const SurfaceBlock<T>> blocks() const { return blocks_; }
  /// Index of a block's first point among the points of all blocks.
  [[nodiscard]] std::uint32_t firstPoint(std::size_t block) const { return firstPoint_[block]; }
  [[nodiscard]] std::size_t pointCount() const { return firstPoint_.back(); }
  /// Moves the points of all blocks, in order, to the end of `points`.
  void takePoints(std::vector<Vec3<double>>& points);

  [[nodiscard]] bool isInside(const NodeOffset& node) const;
  /// Index of the point on the cut edge that begins at this node.
  /// @throws Error if its block was classified as free of surface.
  [[nodiscard]] std::uint32_t edgePoint(const NodeOffset& node, int axis) const;

 private:
  static constexpr std::uint32_t kOutside = 0xffffffff;
  static constexpr std::uint32_t kInside = 0xfffffffe;

  /// Classifies the blocks in a cube of 2^bits blocks along each side, from `first` on.
  void classify(const SurfaceGrid<T>& grid, const NodeOffset& first, int bits, BoxHint hint);
  /// The block that a node's edges belong to.
  [[nodiscard]] std::uint32_t blockOf(const NodeOffset& node) const;

  NodeOffset counts_{};                  // of blocks
  std::vector<std::uint32_t> block_;     // index, kOutside or kInside; x fastest
  std::vector<SurfaceBlock<T>> blocks_;  // in the same order
  std::vector<std::uint32_t> firstPoint_;
};

extern template class SurfaceBlocks<float>;
extern template class SurfaceBlocks<double>;

}  // namespace cutwater::detail
