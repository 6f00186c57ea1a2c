#include <Cutwater/Mesh/Detail/SignedSurface.hpp>

namespace cutwater {

template <std::floating_point T>
void SignedSurface<T>::setSurface(const Surface& surface, double margin) {
  surface_ = surface;
  solidBox_ = surfaceBox().grown(static_cast<T>(margin) / surface.scale);
}

template <std::floating_point T>
void SignedSurface<T>::setSigns(const SignReport& signs, SignScheme wanted) {
  signs_ = signs;
  signs_.scheme = wanted != SignScheme::Automatic ? wanted
                  : signs.isSound()               ? SignScheme::NearestFeature
                                                  : SignScheme::WindingNumber;
  const bool byNearest = signs_.scheme == SignScheme::NearestFeature;
  signJumps_ = byNearest ? !signs_.isSound() : !signs_.isClosed();
  // Behind the nearest triangle is inside, however far away.
  if (byNearest && signJumps_) solidBox_ = Box<T>::everywhere();
}

template <std::floating_point T>
Box<T> SignedSurface<T>::surfaceBox() const {
  // The corners are numbers of type T.
  return {static_cast<Vec3<T>>(surface_.box.lower) / surface_.scale,
          static_cast<Vec3<T>>(surface_.box.upper) / surface_.scale};
}

template <std::floating_point T>
std::array<Vec3<T>, 3> SignedSurface<T>::triangle(std::uint32_t id) const {
  const auto t = surface_.triangle(id);
  return {t.a / surface_.scale, t.b / surface_.scale, t.c / surface_.scale};
}

template class SignedSurface<float>;
template class SignedSurface<double>;

}  // namespace cutwater
