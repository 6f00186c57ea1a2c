#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace cutwater {
namespace {

using CornerIds = std::array<std::uint32_t, 3>;

/// The sum of (p[i] - p[0]) x (p[i+1] - p[0]), with coordinates multiplied by `scale`.
template <typename Vector, typename Difference>
Vector crossProducts(std::span<const Vec3<double>> corners, double scale, Difference difference) {
  const Vec3<double> base = scale * corners[0];
  Vector sum{};
  Vector previous{};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vector current = difference(scale * corners[i], base);
    sum = sum + cross(previous, current);
    previous = current;
  }
  return sum;
}

/// The sum of the products of lengths, to which the rounding of the cross products is proportional.
double crossProductsSize(std::span<const Vec3<double>> corners, double scale) {
  double sum = 0;
  double previous = 0;
  for (const auto& p : corners) {
    const double current = length(scale * p - scale * corners[0]);
    sum += previous * current;
    previous = current;
  }
  return sum;
}

/// Twice the area vector of the scaled polygon.
Vec3<double> scaledAreaVector(std::span<const Vec3<double>> corners, double scale) {
  constexpr double kCancels = 0.1;       // from here on double would lose more than a digit
  constexpr double kRounding = 0x1p-98;  // 2^-102 per operation, a few operations
  const double size = crossProductsSize(corners, scale);
  const auto plain = crossProducts<Vec3<double>>(
      corners, scale, [](const auto& a, const auto& b) { return a - b; });
  if (length(plain) >= kCancels * size) return plain;
  // Through a lambda: a pointer to an always-inlined function does not compile below -O2.
  const auto precise = static_cast<Vec3<double>>(crossProducts<DoubleDouble3>(
      corners, scale,
      [](const auto& a, const auto& b) { return DoubleDouble3::difference(a, b); }));
  return length(precise) > kRounding * size ? precise : Vec3<double>{};
}

/// The area that corresponds to `twice`, twice the area of a polygon scaled by `scale`.
double unscaledArea(double twice, double scale) {
  return 0.5 * twice / scale / scale;
}

}  // namespace

double unitScale(std::span<const Vec3<double>> corners) {
  double size = 0;
  for (const auto& p : corners) size = std::max(size, maxComponent(abs(p - corners[0])));
  const auto exponent = std::bit_cast<std::uint64_t>(size) >> 52U;
  // The usual case, without function calls: the exponents of a number and its scale sum to twice
  // the bias.
  if (exponent - 1 < 2045) return std::bit_cast<double>((2046 - exponent) << 52U);
  return size > 0 ? std::ldexp(1.0, std::min(-std::ilogb(size), 1022)) : 1;
}

template <std::floating_point T>
T normalizingScale(std::span<const Vec3<T>> positions) {
  T largest = 0;
  for (const auto& p : positions) largest = std::max(largest, maxComponent(abs(p)));
  if (!(largest > 0)) return 1;
  // Scales up as far as squares of small numbers allow, and down to the least normal scale.
  constexpr int kMostUp = std::numeric_limits<T>::max_exponent / 2;
  constexpr int kMostDown = std::numeric_limits<T>::max_exponent - 2;
  return std::ldexp(T(1), -std::clamp(std::ilogb(largest), -kMostUp, kMostDown));
}

template <std::floating_point T>
T normalizingScale(std::span<const Vec3<T>> positions, std::span<const CornerIds> triangles) {
  Vec3<T> farthest;
  for (const auto& triangle : triangles) {
    for (const auto v : triangle) farthest = max(farthest, abs(positions[v]));
  }
  return normalizingScale<T>(std::span(&farthest, 1));
}

double normalizingScale(std::span<const Vec3<double>> positions,
                        std::span<const std::uint32_t> used) {
  Vec3<double> farthest;
  for (const auto i : used) farthest = max(farthest, abs(positions[i]));
  return normalizingScale<double>(std::span(&farthest, 1));
}

std::vector<Vec3<double>> normalizedPositions(std::span<const Vec3<double>> positions,
                                              std::span<const std::uint32_t> used) {
  const double scale = normalizingScale(positions, used);
  std::vector<Vec3<double>> result(positions.size());
  for (const auto i : used) result[i] = scale * positions[i];
  return result;
}

template <std::floating_point T>
std::vector<Vec3<double>> normalizedPositions(std::span<const Vec3<T>> positions,
                                              std::span<const CornerIds> triangles) {
  const double scale{normalizingScale(positions, triangles)};
  std::vector<Vec3<double>> result;
  result.reserve(positions.size());
  for (const auto& p : positions) result.push_back(scale * Vec3<double>(p));
  return result;
}

template <std::floating_point T>
std::vector<Box<double>> triangleBoxes(std::span<const Vec3<T>> positions,
                                       std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<Box<double>> boxes(triangles.size());
  parallelFor(triangles.size(), {.grain = 16384}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const auto v : triangles[i]) boxes[i].extend(Vec3<double>(positions[v]));
    }
  });
  return boxes;
}

PolygonArea polygonArea(std::span<const Vec3<double>> corners) {
  if (corners.size() < 3) return {};
  const double scale = unitScale(corners);
  const Vec3<double> twice = scaledAreaVector(corners, scale);
  return {normalized(twice), unscaledArea(length(twice), scale)};
}

TriangleShape triangleShape(const std::array<Vec3<double>, 3>& corners) {
  const double scale = unitScale(corners);
  const Vec3<double> twice = scaledAreaVector(corners, scale);
  const double twiceArea = length(twice);
  if (!(twiceArea > 0)) return {};
  const Vec3<double> u = scale * corners[1] - scale * corners[0];
  const Vec3<double> v = scale * corners[2] - scale * corners[1];
  const Vec3<double> w = scale * corners[0] - scale * corners[2];
  // u x v| is the same at all corners and accurate; for the dot product, rounding relative to |u|
  // |v| is accurate enough, as it vanishes only where |u x v| does not.
  return {twice / twiceArea,
          unscaledArea(twiceArea, scale),
          {std::atan2(twiceArea, -dot(u, w)), std::atan2(twiceArea, -dot(u, v)),
           std::atan2(twiceArea, -dot(v, w))}};
}

template float normalizingScale(std::span<const Vec3<float>>);
template double normalizingScale(std::span<const Vec3<double>>);
template float normalizingScale(std::span<const Vec3<float>>, std::span<const CornerIds>);
template double normalizingScale(std::span<const Vec3<double>>, std::span<const CornerIds>);
template std::vector<Vec3<double>> normalizedPositions(std::span<const Vec3<float>>,
                                                       std::span<const CornerIds>);
template std::vector<Vec3<double>> normalizedPositions(std::span<const Vec3<double>>,
                                                       std::span<const CornerIds>);
template std::vector<Box<double>> triangleBoxes(std::span<const Vec3<float>>,
                                                std::span<const std::array<std::uint32_t, 3>>);
template std::vector<Box<double>> triangleBoxes(std::span<const Vec3<double>>,
                                                std::span<const std::array<std::uint32_t, 3>>);

}  // namespace cutwater
