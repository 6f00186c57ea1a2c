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
Vec3<T> Level<T>::at(const Index3& index, double shift) const {
  // Sums of an index and the shift are exact as doubles.
  const auto along = [shift](std::int32_t i) { return static_cast<T>(i + shift); };
  return {origin_.x + along(index.i) * spacing_.x, origin_.y + along(index.j) * spacing_.y,
          origin_.z + along(index.k) * spacing_.z};
}

template <std::floating_point T>
Vec3<T> Level<T>::position(const Index3& index) const {
  return at(index, centering_ == Centering::Cell ? 0.5 : 0);
}

template <std::floating_point T>
Box<T> Level<T>::cell(const Index3& index) const {
  // Computed from the index of each face, so that neighbours agree on their common face to the bit.
  const double shift = centering_ == Centering::Cell ? 0 : -0.5;
  return {at(index, shift), at(index, shift + 1)};
}

template <std::floating_point T>
T Level<T>::smallestSpacing() const {
  return -maxComponent(-spacing_);
}

template class Level<float>;
template class Level<double>;

}  // namespace cutwater
