#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/Profiles.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
FrustumProfile<T>::FrustumProfile(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : length_(distanceBetween(a, b)), radiusA_(radiusA), radiusB_(radiusB) {
  const double widening = static_cast<double>(radiusB) - static_cast<double>(radiusA);
  const double slant = std::hypot(static_cast<double>(length_), widening);
  slant_ = static_cast<T>(slant);
  along_ = {static_cast<T>(widening / slant), static_cast<T>(static_cast<double>(length_) / slant)};
  normal_ = {along_.axial, -along_.radial};
}

template <std::floating_point T>
T FrustumProfile<T>::flankDistance(const ProfilePoint<T>& p) const {
  return (p.radial - radiusA_) * normal_.radial + p.axial * normal_.axial;
}

template <std::floating_point T>
bool FrustumProfile<T>::hasFootOnFlank(const ProfilePoint<T>& p) const {
  const T foot = (p.radial - radiusA_) * along_.radial + p.axial * along_.axial;
  return 0 < foot && foot < slant_;
}

template <std::floating_point T>
ProfilePoint<T> FrustumProfile<T>::fromDiscA(const ProfilePoint<T>& p) const {
  return {std::max(p.radial - radiusA_, T(0)), p.axial};
}

template <std::floating_point T>
ProfilePoint<T> FrustumProfile<T>::fromDiscB(const ProfilePoint<T>& p) const {
  return {std::max(p.radial - radiusB_, T(0)), p.axial - length_};
}

template <std::floating_point T>
T FrustumProfile<T>::distance(const ProfilePoint<T>& p) const {
  const T flank = flankDistance(p);
  const T deepest = std::max({flank, -p.axial, p.axial - length_});
  if (deepest < 0) return deepest;
  if (flank >= 0 && hasFootOnFlank(p)) return flank;
  return std::min(length(fromDiscA(p)), length(fromDiscB(p)));
}

template <std::floating_point T>
ProfilePoint<T> FrustumProfile<T>::gradient(const ProfilePoint<T>& p) const {
  const T flank = flankDistance(p);
  const T deepest = std::max({flank, -p.axial, p.axial - length_});
  if (deepest > 0) {
    if (flank >= 0 && hasFootOnFlank(p)) return normal_;
    const auto fromA = fromDiscA(p);
    const auto fromB = fromDiscB(p);
    return normalized(length(fromA) <= length(fromB) ? fromA : fromB);
  }
  const bool isFlank = flank == deepest;
  const bool isA = -p.axial == deepest;
  const bool isB = p.axial - length_ == deepest;
  if (isFlank + isA + isB != 1) return {};
  return isFlank ? normal_ : ProfilePoint<T>{0, isA ? T(-1) : T(1)};
}

template <std::floating_point T>
Box<T> FrustumProfile<T>::box(const RotationAxis<T>& axis) const {
  return axis.discBox(0, radiusA_).extend(axis.discBox(length_, radiusB_));
}

template class FrustumProfile<float>;
template class FrustumProfile<double>;

}  // namespace cutwater::detail
