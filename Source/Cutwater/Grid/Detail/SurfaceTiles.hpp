#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/Detail/SurfaceTile.hpp>

namespace cutwater::detail {

/// All tiles of a grid that the surface may pass through; tiles that are certainly free of it are
/// not evaluated.
template <std::floating_point T>
class SurfaceTiles {
 public:
  /// @throws Error of kind Limit if there are more than 2^32 - 2 points.
  SurfaceTiles(const SurfaceGrid<T>& grid, const ParallelOptions& options);

  [[nodiscard]] std::span<const SurfaceTile<T>> tiles() const { return tiles_; }
  /// Index of a tile's first point among the points of all tiles.
  [[nodiscard]] std::uint32_t firstPoint(std::size_t tile) const { return firstPoint_[tile]; }
  [[nodiscard]] std::size_t pointCount() const { return firstPoint_.back(); }
  /// Moves the points of all tiles, in order, to the end of `points`.
  void takePoints(std::vector<Vec3<double>>& points);

  [[nodiscard]] bool isInside(const NodeOffset& node) const;
  /// Index of the point on the cut edge that begins at this node.
  /// @throws Error if its tile was classified as free of surface.
  [[nodiscard]] std::uint32_t edgePoint(const NodeOffset& node, int axis) const;

 private:
  static constexpr std::uint32_t kOutside = 0xffffffff;
  static constexpr std::uint32_t kInside = 0xfffffffe;

  /// Classifies a group of 2^bits tiles along each side, from `first` on; divides it where it may
  /// be cut.
  void classify(const SurfaceGrid<T>& grid, const NodeOffset& first, int bits, BoxHint hint);
  /// Number of the tile that a node's edges belong to, or kInside or kOutside.
  [[nodiscard]] std::uint32_t numberAt(const NodeOffset& node) const;

  NodeOffset counts_{};                 // of tiles along each axis
  std::vector<std::uint32_t> numbers_;  // of all tiles, x fastest; or kOutside or kInside
  std::vector<SurfaceTile<T>> tiles_;   // by their numbers
  std::vector<std::uint32_t> firstPoint_;
};

extern template class SurfaceTiles<float>;
extern template class SurfaceTiles<double>;

}  // namespace cutwater::detail
