#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A regular octahedron about the origin, with corners `radius` away on the axes:
/// |x| + |y| + |z| <= radius.
///
/// Exact: with q = |p|, the step from the nearest point is s_i = min(q_i, t), with t such that the
/// components of q - s sum to `radius` (J. Duchi et al., "Efficient projections onto the l1-ball
/// for learning in high dimensions", ICML 2008).
/// @throws Error unless 0 < radius < infinity.
template <std::floating_point T>
class Octahedron final : public SignedDistanceFunction<T> {
 public:
  explicit Octahedron(T radius);

 private:
  std::string localName() const override { return "Octahedron"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  /// t, for a point of the first octant.
  [[nodiscard]] T reduction(const Vec3<T>& q) const;

  T radius_;
};

extern template class Octahedron<float>;
extern template class Octahedron<double>;

}  // namespace cutwater
