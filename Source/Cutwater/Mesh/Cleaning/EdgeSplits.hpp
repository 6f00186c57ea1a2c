#pragma once

#include <Cutwater/Mesh/PolygonSoup.hpp>

// Private: not installed.

namespace cutwater::detail {

/// Points to be put into edges: into all polygons that have the edge, so that what was closed stays
/// closed.
class EdgeSplits {
 public:
  /// Puts `point` into the edge between two others. `along` tells its place among those put there:
  /// it grows from `from` to `to`.
  void add(std::uint32_t from, std::uint32_t to, std::uint32_t point, double along);

  [[nodiscard]] bool empty() const { return splits_.empty(); }

  /// The soup with the points in the edges. Triangles become several, but for those in `whole` (per
  /// polygon); these and larger polygons get more corners.
  [[nodiscard]] PolygonSoup appliedTo(const PolygonSoup& soup, const std::vector<bool>& whole);

 private:
  struct Split {
    std::uint32_t lower, upper;
    double along;  // from lower to upper
    std::uint32_t point;
  };

  void prepare(std::size_t points);
  [[nodiscard]] std::span<const Split> of(std::uint32_t lower, std::uint32_t upper) const;
  void appendInner(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& chain) const;

  std::vector<Split> splits_;
  std::vector<bool> isLower_;  // per point: whether an edge to be split has it for its lower end
};

}  // namespace cutwater::detail
