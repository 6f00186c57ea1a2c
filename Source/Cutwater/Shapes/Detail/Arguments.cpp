#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
void requireFinite(const char* shape, const char* argument, const Vec3<T>& point) {
  if (isFinite(point)) return;
  const std::string message = std::string(shape) + ": need a finite " + argument;
  require(false, message.c_str(), Named{argument, point});
}

template <std::floating_point T>
void requireRadii(const char* shape, T radiusA, T radiusB) {
  const T sum = radiusA + radiusB;
  if (radiusA >= 0 && radiusB >= 0 && sum > 0 && std::isfinite(sum)) return;
  const std::string message =
      std::string(shape) + ": need finite radii, none negative and one positive";
  require(false, message.c_str(), Named{"radiusA", radiusA}, Named{"radiusB", radiusB});
}

template <std::floating_point T>
T distanceBetween(const Vec3<T>& a, const Vec3<T>& b) {
  const Vec3<double> d = Vec3<double>(b) - Vec3<double>(a);
  return static_cast<T>(std::hypot(d.x, d.y, d.z));
}

template <std::floating_point T>
T farther(const Vec3<T>& a, const Vec3<T>& b) {
  return std::max(length(a), length(b));
}

template void requireFinite(const char*, const char*, const Vec3<float>&);
template void requireFinite(const char*, const char*, const Vec3<double>&);
template void requireRadii(const char*, float, float);
template void requireRadii(const char*, double, double);
template float distanceBetween(const Vec3<float>&, const Vec3<float>&);
template double distanceBetween(const Vec3<double>&, const Vec3<double>&);
template float farther(const Vec3<float>&, const Vec3<float>&);
template double farther(const Vec3<double>&, const Vec3<double>&);

}  // namespace cutwater::detail
