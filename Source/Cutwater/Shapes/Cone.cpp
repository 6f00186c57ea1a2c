#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
Cone<T>::Cone(const Vec3<T>& apex, const Vec3<T>& base, T radius)
    : ProfiledShape<T, detail::FrustumProfile<T>>(
          {"Cone", apex, base - apex}, {apex, base, T(0), radius}, detail::farther(apex, base)) {
  require(radius > 0 && std::isfinite(radius), "Cone: need 0 < radius < infinity",
          Named{"radius", radius});
}

template class Cone<float>;
template class Cone<double>;

}  // namespace cutwater
