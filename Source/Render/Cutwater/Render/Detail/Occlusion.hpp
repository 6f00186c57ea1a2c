#pragma once

#include <Cutwater/Render/CutPlane.hpp>
#include <Cutwater/Render/Detail/CertainDistance.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Computes how much ambient light reaches points of a surface.
///
/// A. Evans, "Fast approximations for global illumination on dynamic scenes", ACM SIGGRAPH 2006
/// courses: in the open, the distance to the surface grows like the distance along the normal; any
/// shortfall measures the geometry around. Where values are only bounds, the closest points
/// of surfaces that may be near tell how far away these are. Where only signs are known, values
/// still are distances to the facets, if there are such; otherwise only what the normal itself
/// meets counts.
template <std::floating_point T>
class Occlusion {
 public:
  /// A point of the surface, with its unit normal.
  struct Foot {
    Vec3<double> point;
    Vec3<double> normal;
  };

  struct Options {
    double radius = 0;       ///< geometry within it is taken into account
    bool hasFacets = false;  ///< the surface consists of flat pieces
  };

  /// Solid and region must outlive this object.
  Occlusion(const SignedDistanceFunction<T>& solid, const CertainDistance<T>& distance,
            const KeptRegion& region, const Options& options)
      : solid_(solid), distance_(distance), region_(region), options_(options) {}

  /// Returns the openness of each point, from 0, enclosed, to 1, in the open. Most efficient for
  /// points close to each other.
  [[nodiscard]] std::vector<float> openness(std::span<const Foot> feet) const;

 private:
  [[nodiscard]] double freeAbout(T value, const Vec3<T>& p, double height) const;
  void lookCloser(std::span<const Vec3<T>> points, std::span<double> free) const;

  const SignedDistanceFunction<T>& solid_;
  CertainDistance<T> distance_;
  const KeptRegion& region_;
  Options options_;
};

extern template class Occlusion<float>;
extern template class Occlusion<double>;

}  // namespace cutwater::detail
