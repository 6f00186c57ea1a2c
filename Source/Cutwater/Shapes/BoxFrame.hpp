#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// The twelve edges of an axis-aligned box as square bars of side `thickness`; rotate() turns it.
///
/// With q = |p - center|, b the half sizes and c = b - thickness: outside, f is the distance to the
/// nearest of the three bars in the octant; inside, minus that to the nearest point off the bars,
///
///     f(p) = -min( min_i b_i - q_i, min_ij |max((q_i - c_i, q_j - c_j), 0)| )        exact
///
/// where the common formula uses the deepest bar only, and so gives just a bound in the corners.
/// @throws Error unless the corners are finite, lower < upper in every coordinate, and 0 <
/// thickness < half the shortest side.
template <std::floating_point T>
class BoxFrame final : public SignedDistanceFunction<T> {
 public:
  BoxFrame(const Box<T>& box, T thickness);

 private:
  std::string localName() const override { return "Box frame"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  /// For a point q of the first octant, the shortest step to the surface.
  struct Step {
    Vec3<T> toSurface;
    bool isInside;
    bool isUnique;
  };
  [[nodiscard]] Step shortest(const Vec3<T>& q) const;
  // Steps out of the frame: through the face normal to an axis, or into the hollow along the axis.
  [[nodiscard]] Vec3<T> toFace(const Vec3<T>& q, int axis) const;
  [[nodiscard]] Vec3<T> toHollow(const Vec3<T>& q, int axis) const;
  /// The step into the bar along an axis; zero inside the bar.
  [[nodiscard]] Vec3<T> toBar(const Vec3<T>& q, int axis) const;

  Box<T> box_;
  Vec3<T> half_;
  Vec3<T> hollow_;  // half sizes of the hollow
};

extern template class BoxFrame<float>;
extern template class BoxFrame<double>;

}  // namespace cutwater
