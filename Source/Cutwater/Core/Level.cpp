#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Level.hpp>

namespace cutwater {

template <std::floating_point T>
Level<T>::Level(const Vec3<T>& origin, const Vec3<T>& spacing, Centering centering)
    : origin_(origin), spacing_(spacing), centering_(centering) {
  require(isFinite(origin), "Level: need a finite origin", Named{"origin", origin});
  require(isFinite(spacing) && spacing.x > 0 && spacing.y > 0 && spacing.z > 0,
          "Level: need positive, finite spacings", Named{"spacing", spacing});
}

template <std::floating_point T>
Vec3<T> Level<T>::position(const Index3& index) const {
  const T shift = centering_ == Centering::Cell ? T(0.5) : T(0);
  return {origin_.x + (static_cast<T>(index.i) + shift) * spacing_.x,
          origin_.y + (static_cast<T>(index.j) + shift) * spacing_.y,
          origin_.z + (static_cast<T>(index.k) + shift) * spacing_.z};
}

template <std::floating_point T>
Box<T> Level<T>::cell(const Index3& index) const {
  // Computed from the index of each face, so that neighbours agree on their common face to the bit.
  const T shift = centering_ == Centering::Cell ? T(0) : T(-0.5);
  const auto face = [&](T side) -> Vec3<T> {
    return {origin_.x + (static_cast<T>(index.i) + shift + side) * spacing_.x,
            origin_.y + (static_cast<T>(index.j) + shift + side) * spacing_.y,
            origin_.z + (static_cast<T>(index.k) + shift + side) * spacing_.z};
  };
  return {face(0), face(1)};
}

template <std::floating_point T>
T Level<T>::smallestSpacing() const {
  return -maxComponent(-spacing_);
}

template class Level<float>;
template class Level<double>;

}  // namespace cutwater
