#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlaneFrame.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {
namespace {

/// Returns the points that lie on the plane; throws if there are points on both sides of it.
std::vector<bool> pointsOn(const PolygonSoup& soup, const detail::PlaneFrame& plane) {
  std::vector<bool> on(soup.points.size());
  std::uint32_t above = kNone;
  std::uint32_t below = kNone;
  for (const auto corner : soup.corners) {
    on[corner] = plane.contains(soup.points[corner]);
    if (!on[corner]) (plane.height(soup.points[corner]) > 0 ? above : below) = corner;
  }
  if (above != kNone && below != kNone) {
    throw Error(ErrorKind::Topology, "mirrorAt: there are points on both sides of the plane (" +
                                         detail::toText(Named{"one", soup.points[above]}) + ", " +
                                         detail::toText(Named{"other", soup.points[below]}) + ")");
  }
  return on;
}

class Mirroring {
 public:
  Mirroring(PolygonSoup& soup, const detail::PlaneFrame& plane, OpeningReport& report)
      : soup_(soup), plane_(plane), report_(report), on_(pointsOn(soup, plane)) {}

  void run() {
    removeFacesInPlane();
    for (const auto& edge : detail::openEdgesOf(soup_)) {
      if (on_[edge.lower] && on_[edge.upper]) ++report_.rimEdges;
    }
    movePoints();
    const std::size_t half = soup_.polygonCount();
    addImages();
    report_.facesAdded = soup_.polygonCount() - half;
    report_.areaAdded = detail::areaFrom(soup_, half);
  }

 private:
  void removeFacesInPlane() {
    std::vector<bool> keep(soup_.polygonCount());
    for (std::size_t i = 0; i < keep.size(); ++i) {
      keep[i] = !std::ranges::all_of(soup_.polygon(i), [&](std::uint32_t c) { return on_[c]; });
    }
    report_.facesRemoved = static_cast<std::size_t>(std::ranges::count(keep, false));
    detail::keepPolygons(soup_, keep);
  }

  void movePoints() {
    for (std::size_t i = 0; i < on_.size(); ++i) {
      if (!on_[i]) continue;
      auto& point = soup_.points[i];
      const auto foot = plane_.foot(point);
      if (foot == point) continue;
      ++report_.pointsMoved;
      report_.farthestMove = std::max(report_.farthestMove, length(foot - point));
      point = foot;
    }
  }

  void addImages() {
    std::vector<std::uint32_t> imageOf(soup_.points.size(), kNone);
    const std::size_t half = soup_.polygonCount();
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < half; ++i) {
      corners.clear();
      for (const auto corner : soup_.polygon(i)) corners.push_back(imageOfPoint(corner, imageOf));
      std::reverse(corners.begin() + 1, corners.end());
      soup_.addPolygon(corners, soup_.patches[i]);
    }
  }

  std::uint32_t imageOfPoint(std::uint32_t point, std::vector<std::uint32_t>& imageOf) {
    if (on_[point]) return point;
    if (imageOf[point] == kNone) {
      imageOf[point] = static_cast<std::uint32_t>(soup_.points.size());
      soup_.points.push_back(plane_.image(soup_.points[point]));
    }
    return imageOf[point];
  }

  PolygonSoup& soup_;
  const detail::PlaneFrame& plane_;
  OpeningReport& report_;
  std::vector<bool> on_;
};

}  // namespace

OpeningReport mirrorAt(PolygonSoup& soup, const SurfacePlane& plane, double tolerance) {
  soup.validate();
  const detail::PlaneFrame frame("mirrorAt", plane, tolerance);
  PolygonSoup work = soup;
  OpeningReport report;
  report.before = measure(soup);
  Mirroring(work, frame, report).run();
  if (report.facesRemoved > 0) removeUnusedPoints(work);
  work.validate();  // there may be too many points, or one beyond the largest number
  report.after = measure(work);
  soup = std::move(work);
  return report;
}

}  // namespace cutwater
