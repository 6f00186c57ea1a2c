#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <vector>

namespace cutwater::test {

/// Points of a surface, found by the sign of the values alone: along lines parallel to the axes,
/// each change of sign is bisected until the two ends are neighbours.
template <std::floating_point T>
class SurfaceSamples {
 public:
  /// `lines` x `lines` lines per axis through [-extent, extent]^3.
  SurfaceSamples(const SignedDistanceFunction<T>& f, double extent, int lines, unsigned seed);

  [[nodiscard]] const std::vector<Vec3<double>>& points() const { return points_; }
  /// Distance between neighbouring lines.
  [[nodiscard]] double spacing() const { return spacing_; }
  /// Index and distance of the sample nearest to p. There must be one.
  struct Nearest {
    std::size_t index;
    double distance;
  };
  [[nodiscard]] Nearest nearest(const Vec3<double>& p) const;
  /// Distance to the surface itself: starts at the nearest samples and looks around for directions
  /// in which it is nearer, by the sign alone, until it is `enough`. Never less than the distance
  /// but for rounding.
  [[nodiscard]] double polishedDistance(const Vec3<double>& p, double enough) const;
  [[nodiscard]] bool anyIn(const Box<double>& box) const;

 private:
  [[nodiscard]] bool isInside(const Vec3<double>& p) const;
  /// Distance to the first change of sign from p along the unit direction; infinite if none is seen
  /// within `reach`.
  [[nodiscard]] double firstChange(const Vec3<double>& p, const Vec3<double>& direction,
                                   double reach) const;
  [[nodiscard]] double polishedFrom(const Vec3<double>& p, const Vec3<double>& sample,
                                    double enough) const;

  const SignedDistanceFunction<T>& f_;
  std::vector<Vec3<double>> points_;
  double spacing_;
};

extern template class SurfaceSamples<float>;
extern template class SurfaceSamples<double>;

}  // namespace cutwater::test
