#include <Cutwater/Core/AffineMap.hpp>

namespace cutwater {

template <std::floating_point T>
Vec3<T> AffineMap<T>::operator()(const Vec3<T>& point) const {
  return direction(point) + offset;
}

template <std::floating_point T>
Vec3<T> AffineMap<T>::direction(const Vec3<T>& v) const {
  return v.x * columns[0] + v.y * columns[1] + v.z * columns[2];
}

template <std::floating_point T>
Vec3<T> AffineMap<T>::transposed(const Vec3<T>& v) const {
  return {dot(columns[0], v), dot(columns[1], v), dot(columns[2], v)};
}

template <std::floating_point T>
Box<T> AffineMap<T>::operator()(const Box<T>& box) const {
  if (box.empty()) return box;
  Box<T> image;
  for (int row = 0; row < 3; ++row) {
    T lower = offset[row];
    T upper = offset[row];
    T size = std::abs(offset[row]);  // of the finite terms
    const auto added = [&size](T term) {
      if (std::isfinite(term)) size += std::abs(term);
      return term;
    };
    for (int j = 0; j < 3; ++j) {
      const T factor = columns[static_cast<std::size_t>(j)][row];
      if (factor == 0) continue;  // 0 * infinity
      lower += added(factor * (factor > 0 ? box.lower[j] : box.upper[j]));
      upper += added(factor * (factor > 0 ? box.upper[j] : box.lower[j]));
    }
    // Four products and sums each, and the rounding of the matrix itself.
    const T slack = 8 * std::numeric_limits<T>::epsilon() * size;
    image.lower[row] = lower - slack;
    image.upper[row] = upper + slack;
  }
  return image;
}

template struct AffineMap<float>;
template struct AffineMap<double>;

}  // namespace cutwater
