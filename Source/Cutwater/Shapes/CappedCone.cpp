#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

template <std::floating_point T>
CappedCone<T>::CappedCone(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : ProfiledShape<T, detail::FrustumProfile<T>>({"CappedCone", a, b - a},
                                                  {a, b, radiusA, radiusB}, detail::farther(a, b)) {
  detail::requireRadii("CappedCone", radiusA, radiusB);
}

template class CappedCone<float>;
template class CappedCone<double>;

}  // namespace cutwater
