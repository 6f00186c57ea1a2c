#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
ConeSphere<T>::ConeSphere(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : ProfiledShape<T, detail::ConeSphereProfile<T>>{
          detail::RotationAxis<T>::between("ConeSphere", a, b),
          {"ConeSphere", a, b, radiusA, radiusB},
          detail::farther(a, b)} {}

template class ConeSphere<float>;
template class ConeSphere<double>;

}  // namespace cutwater
