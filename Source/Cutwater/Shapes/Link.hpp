#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// A chain link: a ring about the local z axis (see Torus), cut in half, with its halves `length`
/// apart along y and straight tubes between them.
///
///     q = (p.x, max(|p.y| - length/2, 0))
///     f(p) = | (|q| - major, p.z) | - minor        exact
///
/// @throws Error unless 0 < minor < major < infinity and 0 <= length < infinity.
template <std::floating_point T>
class Link final : public SignedDistanceFunction<T> {
 public:
  Link(T length, T major, T minor);

 private:
  std::string localName() const override { return "Link"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  std::optional<T> localConcavity(const OrientedBox<T>& box) const override;
  Guarantee<T> localGuarantee() const override;
  Box<T> localBoundingBox() const override;

  T half_;  // of the length
  T major_;
  T minor_;
};

extern template class Link<float>;
extern template class Link<double>;

}  // namespace cutwater
