#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// Points to be inserted into edges: into all polygons that have the edge, so what was closed stays
/// closed.
class EdgeSplits {
 public:
  /// Inserts `point` into the edge between two others. `along` orders the points inserted there: it
  /// grows from `from` to `to`.
  void add(std::uint32_t from, std::uint32_t to, std::uint32_t point, double along);

  [[nodiscard]] bool empty() const { return splits_.empty(); }

  /// Returns the soup with the points in the edges. Triangles are split, except those in `whole`
  /// (per polygon); these and larger polygons get more corners.
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
  std::vector<bool> isLower_;  // per point: whether it is the lower end of an edge to be split
};

}  // namespace cutwater::detail
