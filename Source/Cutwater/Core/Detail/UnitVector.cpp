#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>

namespace cutwater::detail {

template <std::floating_point T>
Vec3<T> unitVector(const char* caller, const char* argument, const Vec3<T>& direction) {
  const T largest = maxComponent(abs(direction));
  if (!isFinite(direction) || !(largest > 0)) {
    const std::string message = std::string(caller) + ": need a finite " + argument + ", not zero";
    require(false, message.c_str(), Named{argument, direction});
  }
  const Vec3<double> scaled = Vec3<double>(direction) / static_cast<double>(largest);
  return Vec3<T>(scaled / length(scaled));
}

template Vec3<float> unitVector(const char*, const char*, const Vec3<float>&);
template Vec3<double> unitVector(const char*, const char*, const Vec3<double>&);

}  // namespace cutwater::detail
