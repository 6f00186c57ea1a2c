#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/EdgeSplits.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

/// Finds points of rims on other edges of rims; lengths are in units in which coordinates are about
/// 1.
class JunctionSearch {
 public:
  JunctionSearch(const PolygonSoup& soup, double tolerance)
      : soup_(soup),
        scale_(normalizingScale(soup.points, soup.corners)),
        positions_(normalizedPositions(soup.points, soup.corners)),
        tolerance_(tolerance * scale_) {
    for (const auto& edge : detail::openEdgesOf(soup)) {
      if (edge.multiplicity % 2 == 0) continue;
      edges_.push_back(edge);
      for (const auto end : {edge.lower, edge.upper}) points_.push_back(end);
    }
    std::ranges::sort(points_);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }

  void run(detail::EdgeSplits& splits, Correction& correction) {
    std::vector<Box<double>> boxes;
    for (const auto& edge : edges_) {
      boxes.push_back(Box<double>{}.extend(positions_[edge.lower]).extend(positions_[edge.upper]));
    }
    if (boxes.empty()) return;
    const auto arrays = buildBvh<16, 4>(boxes);
    for (const auto point : points_) {
      const auto around = Box<double>{positions_[point], positions_[point]}.grown(tolerance_);
      arrays.tree().overlapping(OrientedBox<double>::of(around),
                                [&](std::span<const std::uint32_t> slots) {
                                  for (const auto id : slots) {
                                    if (id != kNone && boxes[id].overlaps(around))
                                      join(point, edges_[id], splits, correction);
                                  }
                                  return true;
                                });
    }
  }

 private:
  void join(std::uint32_t point, const OpenEdge& edge, detail::EdgeSplits& splits,
            Correction& correction) const {
    const auto corners = soup_.polygon(edge.triangle);
    if (std::ranges::find(corners, point) != corners.end()) return;
    const Vec3<double> arm = positions_[point] - positions_[edge.lower];
    const Vec3<double> side = positions_[edge.upper] - positions_[edge.lower];
    const double whole = length(side);
    const double fromLower = length(arm);
    const double fromUpper = length(positions_[point] - positions_[edge.upper]);
    if (std::min(fromLower, fromUpper) <= tolerance_) return;
    if (std::max(fromLower, fromUpper) >= whole) return;
    const double distance = length(cross(arm, side)) / whole;
    if (distance > tolerance_) return;
    splits.add(edge.lower, edge.upper, point, dot(arm, side) / whole);
    correction.add(soup_.points[point], distance / scale_);
  }

  const PolygonSoup& soup_;
  double scale_;
  std::vector<Vec3<double>> positions_;
  double tolerance_;
  std::vector<OpenEdge> edges_;
  std::vector<std::uint32_t> points_;
};

}  // namespace

Correction splitJunctions(PolygonSoup& soup, double tolerance) {
  require(tolerance > 0 && std::isfinite(tolerance),
          "splitJunctions: need 0 < tolerance < infinity", Named{"tolerance", tolerance});
  Correction correction;
  PolygonSoup work;
  bool changed = false;
  // The parts of an edge are shorter than the edge and join the same points, so the loop
  // terminates.
  for (;;) {
    const PolygonSoup& current = changed ? work : soup;
    detail::EdgeSplits splits;
    JunctionSearch(current, tolerance).run(splits, correction);
    if (splits.empty()) break;
    work = splits.appliedTo(current, std::vector<bool>(current.polygonCount()));
    changed = true;
  }
  if (changed) soup = std::move(work);
  return correction;
}

}  // namespace cutwater
