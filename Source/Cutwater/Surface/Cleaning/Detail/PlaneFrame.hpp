#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Cleaning/Openings.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cmath>

namespace cutwater::detail {

/// A plane with a unit normal, and the distance up to which points count as on it. Exact for
/// normals along an axis.
class PlaneFrame {
 public:
  /// @throws Error(Argument) unless the plane is finite, its normal nonzero, 0 <= tolerance < inf.
  PlaneFrame(const char* caller, const SurfacePlane& plane, double tolerance);

  [[nodiscard]] double height(const Vec3<double>& p) const { return dot(p - point_, normal_); }
  [[nodiscard]] bool contains(const Vec3<double>& p) const {
    return std::abs(height(p)) <= tolerance_;
  }
  [[nodiscard]] double tolerance() const { return tolerance_; }
  /// The nearest point of the plane, and the mirror image.
  [[nodiscard]] Vec3<double> foot(const Vec3<double>& p) const;
  [[nodiscard]] Vec3<double> image(const Vec3<double>& p) const;
  /// The axis closest to the normal.
  [[nodiscard]] int axis() const;

 private:
  [[nodiscard]] bool isAlongAxis() const { return std::abs(normal_[axis()]) == 1; }

  Vec3<double> point_;
  Vec3<double> normal_;
  double tolerance_;
};

/// The area of the polygons from `first` on.
[[nodiscard]] double areaFrom(const PolygonSoup& soup, std::size_t first);

}  // namespace cutwater::detail
