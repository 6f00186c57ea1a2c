#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Detail/DistinctCorners.hpp>
#include <Cutwater/Surface/Detail/EarClipping.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {
namespace {

/// Triangulates one polygon at a time; reuses its scratch memory.
class Triangulator {
 public:
  Triangulator(const PolygonSoup& soup, Triangulation& result) : soup_(soup), result_(result) {}

  void add(std::uint32_t polygon) {
    detail::takeDistinct(soup_.polygon(polygon), ids_);
    if (ids_.size() < 3) {
      ++result_.polygonsDropped;
      return;
    }
    local_.clear();
    if (ids_.size() == 3) {
      local_.push_back({0, 1, 2});
    } else {
      ++result_.polygonsSplit;
      takeCorners();
      const Vec3<double> normal = polygonArea(corners_).normal;
      measureWarp(polygon, normal);
      if (ids_.size() == 4) {
        splitQuad(normal);
      } else {
        detail::clipEars(corners_, normal, local_);
      }
    }
    for (const auto& [a, b, c] : local_) {
      result_.triangles.push_back({VertexId{ids_[a]}, VertexId{ids_[b]}, VertexId{ids_[c]}});
      result_.polygons.push_back(polygon);
    }
  }

 private:
  /// Takes the corners at a size near 1, so that no product over- or underflows.
  void takeCorners() {
    corners_.clear();
    for (const std::uint32_t id : ids_) corners_.push_back(soup_.points[id]);
    scale_ = unitScale(corners_);
    for (auto& p : corners_) p *= scale_;
  }

  void measureWarp(std::uint32_t polygon, const Vec3<double>& normal) {
    Vec3<double> mean;  // relative to the first corner
    for (const auto& p : corners_) mean += p - corners_[0];
    mean = mean / static_cast<double>(corners_.size());
    double warp = 0;
    double size = 0;
    for (const auto& p : corners_) {
      const Vec3<double> arm = p - corners_[0] - mean;
      warp = std::max(warp, std::abs(dot(normal, arm)));
      size = std::max(size, length(arm));
    }
    constexpr double kFlat = 1e-6;  // see Triangulation::polygonsWarped
    if (warp > kFlat * size) ++result_.polygonsWarped;
    if (!(warp > result_.relativeWarp * size)) return;
    result_.warp = warp / scale_;
    result_.relativeWarp = warp / size;
    result_.mostWarped = polygon;
  }

  /// Splits along the diagonal whose worse triangle is better; inverted triangles are worst.
  void splitQuad(const Vec3<double>& normal) {
    const std::array<detail::PlaceTriangle, 4> halves{{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};
    std::array<double, 4> quality{};
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3<double>& a = corners_[halves[i][0]];
      const Vec3<double>& b = corners_[halves[i][1]];
      const Vec3<double>& c = corners_[halves[i][2]];
      quality[i] =
          std::copysign(detail::triangleQuality(a, b, c), dot(normal, cross(b - a, c - a)));
    }
    const std::size_t first =
        std::min(quality[0], quality[1]) >= std::min(quality[2], quality[3]) ? 0 : 2;
    local_.assign({halves[first], halves[first + 1]});
  }

  const PolygonSoup& soup_;
  Triangulation& result_;
  std::vector<std::uint32_t> ids_;
  std::vector<Vec3<double>> corners_;
  double scale_ = 1;
  std::vector<detail::PlaceTriangle> local_;
};

}  // namespace

Triangulation triangulate(const PolygonSoup& soup) {
  if (soup.corners.size() >= kNone || soup.polygonCount() >= kNone) {
    throw Error(ErrorKind::Limit, "triangulate: more than 2^32 - 2 polygons or corners");
  }
  Triangulation result;
  // n - 2 triangles per polygon of n corners, at least.
  const std::size_t guess =
      soup.corners.size() - std::min(soup.corners.size() / 3, soup.polygonCount()) * 2;
  result.triangles.reserve(guess);
  result.polygons.reserve(guess);
  Triangulator triangulator(soup, result);
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    triangulator.add(static_cast<std::uint32_t>(i));
  }
  return result;
}

PolygonSoup triangulated(const PolygonSoup& soup) {
  const Triangulation triangulation = triangulate(soup);
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  result.corners.reserve(3 * triangulation.triangles.size());
  result.offsets.reserve(triangulation.triangles.size() + 1);
  result.patches.reserve(triangulation.triangles.size());
  for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
    const auto [a, b, c] = triangulation.triangles[i];
    result.addPolygon(std::array{index(a), index(b), index(c)},
                      soup.patches[triangulation.polygons[i]]);
  }
  return result;
}

}  // namespace cutwater
