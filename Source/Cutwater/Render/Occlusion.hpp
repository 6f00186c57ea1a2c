#pragma once

#include <Cutwater/Render/CertainDistance.hpp>
#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

/// How render() works inside; for its parts only.
namespace cutwater::detail {

/// How much light from around comes to points of a surface.
///
/// A. Evans, "Fast approximations for global illumination on dynamic scenes", ACM SIGGRAPH 2006
/// courses: in the open, the distance to the surface grows as one leaves it along the normal; what
/// it lacks tells how much stands around. Where values are mere bounds, this is more than there is;
/// where only signs are known, only what the normal runs into counts.
template <std::floating_point T>
class Occlusion {
 public:
  /// A point of the surface, with its unit normal.
  struct Foot {
    Vec3<double> point;
    Vec3<double> normal;
  };

  /// Looks as far as `radius`. Solid and region must live as long as this.
  Occlusion(const SignedDistanceFunction<T>& solid, const CertainDistance<T>& distance,
            const KeptRegion& region, double radius)
      : solid_(solid), distance_(distance), region_(region), radius_(radius) {}

  /// From 0, enclosed, to 1, in the open; for each of the points, which is best close to the
  /// others.
  [[nodiscard]] std::vector<float> openness(std::span<const Foot> feet) const;

 private:
  [[nodiscard]] double freePart(T value, const Vec3<T>& p, double height) const;

  const SignedDistanceFunction<T>& solid_;
  CertainDistance<T> distance_;
  const KeptRegion& region_;
  double radius_;
};

extern template class Occlusion<float>;
extern template class Occlusion<double>;

}  // namespace cutwater::detail
