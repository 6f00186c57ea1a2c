#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

namespace cutwater {

/// What a mesh answers about points, once its index, a MeshIndex or a DcelIndex, has found the
/// nearest triangles. How it finds them does not affect a single bit.
///
/// Points are in the mesh's own frame and units, except for `p`: that is the same point in the
/// surface's scaled units.
template <std::floating_point T, typename Index>
class PointAnswers {
 public:
  using Nearest = typename TriangleSurface<T>::Nearest;
  /// The number of points that are searched together.
  static constexpr std::size_t kBatch = 256;

  explicit PointAnswers(const Index& index) : index_(index) {}

  // See the functions of SignedDistanceFunction that begin with local.
  [[nodiscard]] T signedDistance(const Vec3<T>& point) const {
    const Vec3<T> p = scaled(point);
    return valueAt(point, p, index_.nearest(p));
  }
  [[nodiscard]] T signedDistanceWithin(const Vec3<T>& point, const Interval<T>& wanted) const;
  void signedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const;
  bool signedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                             std::span<T> distances) const;
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point) const;
  [[nodiscard]] SurfacePoint<T> closestPoint(const Vec3<T>& point) const {
    const Vec3<T> p = scaled(point);
    const auto nearest = index_.nearest(p);
    return closestPointAt(p, nearest, valueAt(point, p, nearest));
  }
  void closestPoints(std::span<const Vec3<T>> points, std::span<SurfacePoint<T>> results) const;
  [[nodiscard]] Guarantee<T> guarantee() const;

  /// Converts from the mesh's own units; points for which squares would overflow are pulled in.
  [[nodiscard]] Vec3<T> scaled(const Vec3<T>& point) const {
    const Vec3<T> p = surface().scale * point;
    return maxComponent(abs(p)) <= kFarthest ? p : pulledIn(point);
  }
  /// 1 outside, -1 inside, 0 exactly on the surface.
  [[nodiscard]] int side(const Vec3<T>& p, const Nearest& nearest) const {
    if (signs().scheme == SignScheme::NearestFeature && nearest.distanceSquared != 0) {
      if (const int agreed = nearest.agreedSide(); agreed != 0) return agreed;
    }
    return disputedSide(p, nearest);
  }
  [[nodiscard]] bool isInside(const Vec3<T>& p) const;

 private:
  /// From this distance on, the whole surface, of size 1, is a point within rounding, but squares
  /// do not yet overflow. Points beyond are pulled in along their ray.
  static constexpr T kFarthest = T(0x1p60);

  [[nodiscard]] const TriangleSurface<T>& surface() const { return index_.surface(); }
  /// scaled(), for many points. Returns bounds on the sizes of their coordinates.
  [[nodiscard]] Vec3<T> scale(std::span<const Vec3<T>> points, std::span<Vec3<T>> p) const;
  /// Not inlined: in a loop, g++ would compute these divisions for every point.
  [[nodiscard, gnu::noinline]] static Vec3<T> pulledIn(const Vec3<T>& point);
  /// side(), for all points.
  [[nodiscard]] int disputedSide(const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] const SignReport& signs() const { return index_.signs(); }
  /// The sides of points that follow each other.
  class Sides;
  [[nodiscard]] T valueAt(const Vec3<T>& point, const Vec3<T>& p, const Nearest& nearest) const {
    return valueAt(point, p, nearest, side(p, nearest));
  }
  [[nodiscard]] T valueAt(const Vec3<T>& point, const Vec3<T>& p, const Nearest& nearest,
                          int side) const;
  /// `value`: at the point.
  [[nodiscard]] SurfacePoint<T> closestPointAt(const Vec3<T>& p, const Nearest& nearest,
                                               T value) const;
  /// Calls visit(i, p, nearest, value) for each of the points; searches them in batches.
  template <typename Visit>
  void forNearest(std::span<const Vec3<T>> points, Visit visit) const;
  /// Whether a ball about the point extends beyond the solid's box: if it contains no triangle of a
  /// closed surface, the point is outside.
  [[nodiscard]] bool leavesBox(const Vec3<T>& point, T radius) const;

  const Index& index_;
};

}  // namespace cutwater
