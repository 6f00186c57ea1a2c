#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Lattice/Detail/CappedBeam.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T, typename Profile>
Beam<T, Profile>::Beam(const detail::RotationAxis<T>& axis, const Profile& profile,
                       const Vec3<T>& a, const Vec3<T>& b)
    : axis_(axis), profile_(profile), size_(detail::farther(a, b) + profile.largestRadius()) {}

template <std::floating_point T, typename Profile>
T Beam<T, Profile>::distance(const Vec3<T>& p) const {
  return profile_.distance(axis_.profilePoint(p)) + T(0);  // -0 becomes +0
}

template <std::floating_point T, typename Profile>
Vec3<T> Beam<T, Profile>::gradient(const Vec3<T>& p) const {
  const auto split = axis_.split(p);
  return axis_.revolved(split, profile_.gradient({length(split.radial), split.axial}));
}

template <std::floating_point T, typename Profile>
Box<T> Beam<T, Profile>::boundingBox() const {
  return Guarantee<T>::exact(size_).grown(profile_.box(axis_));
}

template <std::floating_point T>
CapsuleBeam<T>::CapsuleBeam(const Vec3<T>& a, const Vec3<T>& b, T radius)
    : Beam<T, detail::CapsuleProfile<T>>(detail::RotationAxis<T>::between("CapsuleBeam", a, b),
                                         {"CapsuleBeam", a, b, radius}, a, b) {}

template <std::floating_point T>
ConeSphereBeam<T>::ConeSphereBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Beam<T, detail::ConeSphereProfile<T>>(
          detail::RotationAxis<T>::between("ConeSphereBeam", a, b),
          {"ConeSphereBeam", a, b, radiusA, radiusB}, a, b) {}

template <std::floating_point T>
CappedConeBeam<T>::CappedConeBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Beam<T, detail::FrustumProfile<T>>({"CappedConeBeam", a, b - a}, {a, b, radiusA, radiusB}, a,
                                         b) {
  detail::requireRadii("CappedConeBeam", radiusA, radiusB);
}

template <std::floating_point T>
CappedBeam<T>::CappedBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB,
                          const std::array<BeamCap, 2>& caps)
    : Beam<T, detail::CappedFrustumProfile<T>>({"CappedBeam", a, b - a},
                                               {{a, b, radiusA, radiusB}, caps}, a, b) {
  detail::requireRadii("CappedBeam", radiusA, radiusB);
}

template class Beam<float, detail::CapsuleProfile<float>>;
template class Beam<double, detail::CapsuleProfile<double>>;
template class CapsuleBeam<float>;
template class CapsuleBeam<double>;
template class Beam<float, detail::ConeSphereProfile<float>>;
template class Beam<double, detail::ConeSphereProfile<double>>;
template class ConeSphereBeam<float>;
template class ConeSphereBeam<double>;
template class Beam<float, detail::FrustumProfile<float>>;
template class Beam<double, detail::FrustumProfile<double>>;
template class CappedConeBeam<float>;
template class CappedConeBeam<double>;
template class Beam<float, detail::CappedFrustumProfile<float>>;
template class Beam<double, detail::CappedFrustumProfile<double>>;
template class CappedBeam<float>;
template class CappedBeam<double>;
template class LinearBVH<float, CapsuleBeam<float>>;
template class LinearBVH<double, CapsuleBeam<double>>;
template class LinearBVH<float, ConeSphereBeam<float>>;
template class LinearBVH<double, ConeSphereBeam<double>>;
template class LinearBVH<float, CappedConeBeam<float>>;
template class LinearBVH<double, CappedConeBeam<double>>;
template class LinearBVH<float, CappedBeam<float>>;
template class LinearBVH<double, CappedBeam<double>>;

}  // namespace cutwater
