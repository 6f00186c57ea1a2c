#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Ellipsoid<T>::Ellipsoid(const Vec3<T>& center, const Vec3<T>& semiAxes)
    : center_(center), semiAxes_(semiAxes) {
  detail::requireFinite("Ellipsoid", "center", center);
  constexpr double kMostSlender = 1e6;
  const T longest = maxComponent(semiAxes);
  const T shortest = -maxComponent(-semiAxes);
  require(shortest > 0 && isFinite(semiAxes), "Ellipsoid: need finite semi-axes above 0",
          Named{"semiAxes", semiAxes});
  require(double{longest} <= kMostSlender * double{shortest},
          "Ellipsoid: need semi-axes that differ by a factor of at most 10^6",
          Named{"semiAxes", semiAxes});
  std::ranges::stable_sort(order_, [&](int a, int b) { return semiAxes[a] > semiAxes[b]; });
  e_ = sorted(semiAxes);
  const double least{shortest};
  for (std::size_t i = 0; i < 3; ++i) {
    const double e{e_[i]};
    ratio_[i] = static_cast<T>((e / least) * (e / least));
    excess_[i] = static_cast<T>(((e - least) / least) * ((e + least) / least));
  }
}

template <std::floating_point T>
auto Ellipsoid<T>::sorted(const Vec3<T>& fromCenter) const -> Sorted {
  return {std::abs(fromCenter[order_[0]]), std::abs(fromCenter[order_[1]]),
          std::abs(fromCenter[order_[2]])};
}

template <std::floating_point T>
T Ellipsoid<T>::root(const Sorted& z, T start) const {
  // At the root no term of the sum exceeds 1, so the root is not below `least`, where the sum is at
  // most 3. Only rounding can make a step pass the root, and the next one go back.
  constexpr int kMostSteps = 40;
  const T least = std::max(start, z[2]);
  T t = least;
  for (std::size_t i = 0; i < 2; ++i) t = std::max(t, ratio_[i] * (z[i] - 1) + 1);
  T before = std::numeric_limits<T>::max();
  for (int step = 0; step < kMostSteps; ++step) {
    T sum = 0;
    T slope = 0;  // -1/2 times that of the sum
    for (std::size_t i = 0; i < 3; ++i) {
      const T pole = t + excess_[i];
      const T w = ratio_[i] * z[i] / pole;
      sum += w * w;
      slope += w * w / pole;
    }
    const T next = std::max(t + sum * (std::sqrt(sum) - 1) / slope, least);
    if (next == t || (next < t && before < t)) break;
    before = t;
    t = next;
  }
  return t;
}

template <std::floating_point T>
auto Ellipsoid<T>::foot(const Sorted& y) const -> Foot {
  Sorted z;
  for (std::size_t i = 0; i < 3; ++i) z[i] = y[i] / e_[i];
  // The sum at t = 0 without its last term. If it is below 1, a point in the plane of the long axes
  // has its nearest points off that plane, one on each side.
  constexpr T kTiny = std::numeric_limits<T>::min() / std::numeric_limits<T>::epsilon();
  if (z[2] <= kTiny) {
    Sorted normal{};
    T rest = 1;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!(y[i] > 0)) continue;
      normal[i] = y[i] / excess_[i];
      const T w = ratio_[i] * z[i] / excess_[i];
      rest -= w * w;
    }
    if (rest > 0) {
      normal[2] = e_[2] * std::sqrt(rest);
      return {0, normal, false};
    }
  }
  const T t = root(z, kTiny);
  return {t, {y[0] / (t + excess_[0]), y[1] / (t + excess_[1]), y[2] / t}, true};
}

template <std::floating_point T>
T Ellipsoid<T>::localSignedDistance(const Vec3<T>& p) const {
  const auto [t, normal, isUnique] = foot(sorted(p - center_));
  return (t - 1) * length(Vec3<T>{normal[0], normal[1], normal[2]});
}

template <std::floating_point T>
Vec3<T> Ellipsoid<T>::localGradient(const Vec3<T>& p) const {
  const Vec3<T> fromCenter = p - center_;
  const auto nearest = foot(sorted(fromCenter));
  if (!nearest.isUnique) return {};
  Vec3<T> normal;
  for (std::size_t i = 0; i < 3; ++i) {
    normal[order_[i]] = fromCenter[order_[i]] < 0 ? -nearest.normal[i] : nearest.normal[i];
  }
  return normalized(normal);
}

template <std::floating_point T>
Guarantee<T> Ellipsoid<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(center_) + e_[0]);
}

template <std::floating_point T>
Box<T> Ellipsoid<T>::localBoundingBox() const {
  return localGuarantee().grown(Box<T>{center_ - semiAxes_, center_ + semiAxes_});
}

template class Ellipsoid<float>;
template class Ellipsoid<double>;

}  // namespace cutwater
