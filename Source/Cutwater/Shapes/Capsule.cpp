#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
Capsule<T>::Capsule(const Vec3<T>& a, const Vec3<T>& b, T radius)
    : ProfiledShape<T, detail::CapsuleProfile<T>>{detail::RotationAxis<T>::between("Capsule", a, b),
                                                  {"Capsule", a, b, radius},
                                                  detail::farther(a, b)} {}

template class Capsule<float>;
template class Capsule<double>;

}  // namespace cutwater
