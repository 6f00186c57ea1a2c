#include <Cutwater/Core/AffineMap.hpp>

#include <algorithm>

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

namespace detail {

template <std::floating_point T>
Box<T> domainUnder(const AffineMap<T>& map, const AffineMap<T>& inverse, const Box<T>& domain) {
  if (domain == Box<T>::everywhere()) return domain;
  const Vec3<T> half = T(0.5) * domain.upper - T(0.5) * domain.lower;
  if (domain.empty() || !isFinite(half)) return {};
  const auto reach = [](const AffineMap<T>& m, const Vec3<T>& v) {
    return v.x * abs(m.columns[0]) + v.y * abs(m.columns[1]) + v.z * abs(m.columns[2]);
  };
  const Vec3<T> around = reach(map, half);
  const Vec3<T> back = reach(inverse, around);
  T shrink = 1;
  for (int i = 0; i < 3; ++i) shrink = std::min(shrink, half[i] / back[i]);
  if (!(shrink >= 0)) return {};
  const Vec3<T> center = map(domain.center());
  return {center - shrink * around, center + shrink * around};
}

template Box<float> domainUnder(const AffineMap<float>&, const AffineMap<float>&,
                                const Box<float>&);
template Box<double> domainUnder(const AffineMap<double>&, const AffineMap<double>&,
                                 const Box<double>&);

}  // namespace detail

}  // namespace cutwater
