#include <Cutwater/Core/Detail/MixedBits.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/TpmsMap.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using Node = std::array<std::int64_t, 3>;

/// Components in [-1, 1), from 21 bits each.
template <std::floating_point T>
Vec3<T> randomAt(const Node& node, std::uint64_t seed) {
  std::uint64_t hash = detail::mixed(seed + detail::kGoldenIncrement);
  for (const auto index : node) hash = detail::mixed(hash ^ static_cast<std::uint64_t>(index));
  Vec3<T> result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto bits =
        static_cast<std::uint32_t>(hash >> (21U * static_cast<unsigned>(axis))) & 0x1fffffU;
    result[axis] = static_cast<T>(bits) * T(0x1p-20) - 1;
  }
  return result;
}

}  // namespace

template <std::floating_point T>
void DeformationField<T>::check() const {
  bool isRight = amplitude >= 0 && std::isfinite(amplitude) && isFinite(spacing);
  for (int axis = 0; axis < 3; ++axis) {
    isRight = isRight && spacing[axis] > 0 && std::isfinite(amplitude / spacing[axis]);
  }
  require(isRight, "DeformationField: need an amplitude that is not negative and spacings > 0",
          Named{"amplitude", amplitude}, Named{"spacing", spacing});
}

template <std::floating_point T>
Vec3<T> DeformationField<T>::shiftAt(const Vec3<T>& p) const {
  constexpr T kFarthest = T(0x1p60);  // nodes are whole numbers
  Node node{};
  Vec3<T> rest;
  for (int axis = 0; axis < 3; ++axis) {
    const T place = std::clamp(p[axis] / spacing[axis], -kFarthest, kFarthest);
    const T below = std::floor(place);
    rest[axis] = place - below;
    node[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(below);
  }
  Vec3<T> shift;
  for (int corner = 0; corner < 8; ++corner) {
    Node at = node;
    T weight = amplitude;
    for (int axis = 0; axis < 3; ++axis) {
      const bool isUpper = (corner >> axis & 1) != 0;
      at[static_cast<std::size_t>(axis)] += isUpper ? 1 : 0;
      weight *= isUpper ? rest[axis] : 1 - rest[axis];
    }
    shift += weight * randomAt<T>(at, seed);
  }
  return shift;
}

template <std::floating_point T>
T DeformationField<T>::lipschitz() const {
  const Vec3<T> slopes{amplitude / spacing.x, amplitude / spacing.y, amplitude / spacing.z};
  const T steepest = maxComponent(slopes);
  if (steepest == 0) return 0;
  const T squares = lengthSquared(slopes / steepest);  // of slopes alone, they could overflow
  return 2 * steepest * std::sqrt(3 * squares) * (1 + 8 * std::numeric_limits<T>::epsilon());
}

template struct DeformationField<float>;
template struct DeformationField<double>;

}  // namespace cutwater
