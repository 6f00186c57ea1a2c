#pragma once

#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater {

/// All points within `radius` of the segment from `a` to `b`: a cylinder with hemispherical ends; a
/// ball if a = b.
///
///     f(p) = |p - nearest point of the segment| - radius        exact
///
/// @throws Error unless the end points are finite and 0 < radius < infinity.
template <std::floating_point T>
class Capsule final : public ProfiledShape<T, detail::CapsuleProfile<T>> {
 public:
  Capsule(const Vec3<T>& a, const Vec3<T>& b, T radius);

 private:
  std::string localName() const override { return "Capsule"; }
};

extern template class ProfiledShape<float, detail::CapsuleProfile<float>>;
extern template class ProfiledShape<double, detail::CapsuleProfile<double>>;
extern template class Capsule<float>;
extern template class Capsule<double>;

}  // namespace cutwater
