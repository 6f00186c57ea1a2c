#pragma once

#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater {

/// The convex hull of two balls: a round cone. Where one ball contains the other it is that ball.
///
///     l = |b - a|, s = (radiusA - radiusB) / l, c = sqrt(1 - s^2)
///     t = x c - y s                        x along the axis from a, y from the axis
///     f(p) = |p - a| - radiusA             for t <= 0
///            |p - b| - radiusB             for t >= l c
///            x s + y c - radiusA           between the tangent circles        exact
///
/// @throws Error unless the centres are finite, both radii are finite and not negative, and one of
/// them is positive.
template <std::floating_point T>
class ConeSphere final : public ProfiledShape<T, detail::ConeSphereProfile<T>> {
 public:
  ConeSphere(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);

 private:
  std::string localName() const override { return "Cone-sphere"; }
};

extern template class ProfiledShape<float, detail::ConeSphereProfile<float>>;
extern template class ProfiledShape<double, detail::ConeSphereProfile<double>>;
extern template class ConeSphere<float>;
extern template class ConeSphere<double>;

}  // namespace cutwater
