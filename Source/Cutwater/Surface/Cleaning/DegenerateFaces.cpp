#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/EdgeSplits.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Detail/DistinctCorners.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cutwater {
namespace {

using Polygon = std::span<const std::uint32_t>;

bool hasRepeats(std::vector<std::uint32_t> corners) {
  std::ranges::sort(corners);
  return std::ranges::adjacent_find(corners) != corners.end();
}

/// A polygon of distinct corners, which may be collinear.
class CornersInLine {
 public:
  CornersInLine(const PolygonSoup& soup, Polygon corners) : soup_(soup), corners_(corners) {
    const auto& first = soup.points[corners[0]];
    Box<double> box;
    for (const auto corner : corners) box.extend(soup.points[corner]);
    const auto size = box.size();
    axis_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    farthest_ = *std::ranges::max_element(corners, {}, [&](std::uint32_t corner) {
      return maxComponent(abs(soup.points[corner] - first));
    });
  }

  /// Whether all corners are collinear.
  [[nodiscard]] bool isCollinear() const {
    return std::ranges::all_of(corners_, [&](std::uint32_t corner) {
      if (corner == corners_[0] || corner == farthest_) return true;
      const std::array triangle{soup_.points[corners_[0]], soup_.points[farthest_],
                                soup_.points[corner]};
      return polygonArea(triangle).normal == Vec3<double>{};
    });
  }

  /// Splits every edge at the corners in between. Afterwards the polygon passes along each of its
  /// edges equally often in both directions, so that it can be removed.
  void splitEdges(detail::EdgeSplits& splits) const {
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto from = corners_[k];
      const auto to = corners_[(k + 1) % corners_.size()];
      const auto start = placeOf(from);
      const auto end = placeOf(to);
      for (const auto corner : corners_) {
        const auto place = placeOf(corner);
        if (start < place && place < end) splits.add(from, to, corner, place.first);
        if (end < place && place < start) splits.add(to, from, corner, place.first);
      }
    }
  }

 private:
  /// Any order will do, as long as no two places are equal.
  [[nodiscard]] std::pair<double, std::uint32_t> placeOf(std::uint32_t corner) const {
    return {soup_.points[corner][axis_], corner};
  }

  const PolygonSoup& soup_;
  Polygon corners_;
  int axis_ = 0;
  std::uint32_t farthest_ = 0;
};

/// Removes repeated corners, and polygons that have too few corners without them.
class RepeatedCornerRemoval {
 public:
  /// Reports which polygons were changed.
  Correction run(PolygonSoup& soup) {
    Correction correction;
    auto result = detail::rebuilt(soup, [&](std::size_t i, Polygon corners, PolygonSoup& tidied) {
      detail::takeDistinct(corners, corners_);
      const bool tooFew = corners_.size() < 3;
      const bool split = !tooFew && hasRepeats(corners_);
      if (split || corners_.size() < corners.size()) {
        correction.add(detail::middleOf(soup, i), detail::extentOf(soup, i));
      }
      if (split) {
        addTriangles(soup, soup.patches[i], tidied);
      } else if (!tooFew) {
        tidied.addPolygon(corners_, soup.patches[i]);
      }
    });
    if (correction) soup = std::move(result);
    return correction;
  }

 private:
  void addTriangles(const PolygonSoup& soup, std::uint32_t patch, PolygonSoup& result) {
    PolygonSoup one;
    for (std::uint32_t k = 0; k < corners_.size(); ++k)
      one.points.push_back(soup.points[corners_[k]]);
    std::vector<std::uint32_t> places(corners_.size());
    for (std::uint32_t k = 0; k < places.size(); ++k) places[k] = k;
    one.addPolygon(places);
    for (const auto& triangle : triangulate(one).triangles) {
      std::vector<std::uint32_t> ids;
      for (const auto place : triangle) ids.push_back(corners_[index(place)]);
      detail::takeDistinct(ids, places);
      if (places.size() == 3) result.addPolygon(places, patch);
    }
  }

  std::vector<std::uint32_t> corners_;
};

}  // namespace

Correction removeDegenerateFaces(PolygonSoup& soup) {
  PolygonSoup work = soup;
  Correction correction = RepeatedCornerRemoval().run(work);
  // Every round splits edges into shorter ones between the same points, so the loop terminates.
  // Only faces without area leave such faces behind, which are not counted again.
  for (bool first = true;; first = false) {
    detail::EdgeSplits splits;
    std::vector<bool> collinear(work.polygonCount());
    for (std::size_t i = 0; i < collinear.size(); ++i) {
      const CornersInLine line(work, work.polygon(i));
      collinear[i] = line.isCollinear();
      if (!collinear[i]) continue;
      line.splitEdges(splits);
      if (first) correction.add(detail::middleOf(work, i), detail::extentOf(work, i));
    }
    if (splits.empty()) break;
    work = splits.appliedTo(work, collinear);
    RepeatedCornerRemoval().run(work);
  }
  if (correction) soup = std::move(work);
  return correction;
}

}  // namespace cutwater
