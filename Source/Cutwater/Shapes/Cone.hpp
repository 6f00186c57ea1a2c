#pragma once

#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater {

/// A cone with its apex at `apex` and a flat base around `base`: a CappedCone with one radius zero.
///
/// Exact. @throws Error unless the points are finite and differ, and 0 < radius < infinity.
template <std::floating_point T>
class Cone final : public ProfiledShape<T, detail::FrustumProfile<T>> {
 public:
  Cone(const Vec3<T>& apex, const Vec3<T>& base, T radius);

 private:
  std::string localName() const override { return "Cone"; }
};

extern template class ProfiledShape<float, detail::FrustumProfile<float>>;
extern template class ProfiledShape<double, detail::FrustumProfile<double>>;
extern template class Cone<float>;
extern template class Cone<double>;

}  // namespace cutwater
