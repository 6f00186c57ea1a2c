#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlaneFrame.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

namespace cutwater::detail {

PlaneFrame::PlaneFrame(const char* caller, const SurfacePlane& plane, double tolerance)
    : point_(plane.point), tolerance_(tolerance) {
  const std::string name(caller);
  require(isFinite(plane.point), (name + ": need a finite point").c_str(),
          Named{"point", plane.point});
  require(tolerance >= 0 && std::isfinite(tolerance),
          (name + ": need 0 <= tolerance < infinity").c_str(), Named{"tolerance", tolerance});
  normal_ = unitVector(caller, "normal", plane.normal);
}

int PlaneFrame::axis() const {
  const auto size = abs(normal_);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

Vec3<double> PlaneFrame::foot(const Vec3<double>& p) const {
  Vec3<double> result = p;
  if (isAlongAxis()) {
    result[axis()] = point_[axis()];
  } else {
    result -= height(p) * normal_;
  }
  return result;
}

Vec3<double> PlaneFrame::image(const Vec3<double>& p) const {
  Vec3<double> result = p;
  if (isAlongAxis()) {
    result[axis()] = 2 * point_[axis()] - p[axis()];
  } else {
    result -= 2 * height(p) * normal_;
  }
  return result;
}

double areaFrom(const PolygonSoup& soup, std::size_t first) {
  double sum = 0;
  for (std::size_t i = first; i < soup.polygonCount(); ++i) {
    std::vector<Vec3<double>> corners;
    for (const auto corner : soup.polygon(i)) corners.push_back(soup.points[corner]);
    sum += polygonArea(corners).area;
  }
  return sum;
}

}  // namespace cutwater::detail
