#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <vector>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// Where a ray meets a facet.
struct FacetHit {
  double along;
  Vec3<double> normal;  ///< unit, out of the solid; zero if undefined
  std::uint32_t patch;
};

/// Where a ray passes a facet.
struct FacetPass {
  double along;
  Vec3<double> point;  ///< of the facet, nearest to the ray
  std::uint32_t patch;
};

/// The flat pieces of a solid's surface in a tree, to find the first that a ray meets, or the
/// nearest that it passes.
///
/// A ray meets a facet of which it passes within 1e-9 of the size, so that none slips through
/// between two that share an edge.
class FacetRays {
 public:
  /// Those in a finite box; nothing if the surface there does not consist of flat pieces, or there
  /// is none. `threads`: see ParallelOptions.
  template <std::floating_point T>
  [[nodiscard]] static std::optional<FacetRays> of(const SignedDistanceFunction<T>& solid,
                                                   const Box<double>& box, int threads);

  /// The first hit between two distances along the ray. Of facets within `samePlace` behind it,
  /// one that faces the viewer is preferred, then the lowest patch.
  [[nodiscard]] std::optional<FacetHit> first(const Ray& ray, double begin, double end,
                                              double samePlace) const;

  /// The facet that a ray which meets none passes most closely, between two distances along the
  /// ray, in units of how far away it may be: `reach` says so for each distance along the ray, and
  /// does not decrease.
  [[nodiscard]] std::optional<FacetPass> nearest(const Ray& ray, double begin, double end,
                                                 FunctionRef<double(double)> reach) const;

 private:
  struct Facet {
    Vec3<double> corner;
    Vec3<double> toNext;
    Vec3<double> toLast;
    Vec3<double> normal;
    std::uint32_t patch;
  };
  class Walk;

  FacetRays() = default;

  /// Calls visit(slots) for the leaves within `reach` of the ray, nearer ones mostly first; it
  /// returns the distance along the ray beyond which no facet counts.
  template <typename Visit>
  void visitAlong(const Ray& ray, double begin, double end, double reach, Visit visit) const;

  std::vector<Facet> facets_;
  BvhArrays<16, 4> tree_;
};

extern template std::optional<FacetRays> FacetRays::of(const SignedDistanceFunction<float>&,
                                                       const Box<double>&, int);
extern template std::optional<FacetRays> FacetRays::of(const SignedDistanceFunction<double>&,
                                                       const Box<double>&, int);

}  // namespace cutwater::detail
