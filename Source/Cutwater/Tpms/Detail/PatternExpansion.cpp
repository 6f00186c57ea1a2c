#include <Cutwater/Tpms/Detail/Constants.hpp>
#include <Cutwater/Tpms/Detail/PatternBatch.hpp>
#include <Cutwater/Tpms/Detail/PatternExpansion.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// Step of differences of gradients, in radians.
constexpr double kStep = 1e-5;
/// The place itself, and one a step away along each axis.
constexpr std::size_t kSamples = 4;
static_assert(PatternExpansion::kMostAtOnce * kSamples == PatternBatch<double>::kMost);

PatternExpansion expansionFrom(const PatternBatch<double>& batch, std::size_t first) {
  const auto gradient = [&](std::size_t i) {
    return Vec3<double>{batch.gradient[0][first + i], batch.gradient[1][first + i],
                        batch.gradient[2][first + i]};
  };
  PatternExpansion result{batch.value[first], gradient(0), {}};
  auto& second = result.second;
  for (std::size_t i = 0; i < 3; ++i) {
    second[i] = (gradient(i + 1) - result.gradient) / kStep;
  }
  const auto makeEqual = [](double& a, double& b) { a = b = 0.5 * (a + b); };
  makeEqual(second[0].y, second[1].x);
  makeEqual(second[0].z, second[2].x);
  makeEqual(second[1].z, second[2].y);
  return result;
}

}  // namespace

double PatternExpansion::secondError(const TpmsPattern& pattern) {
  // Half a step of third derivatives in each of three columns, and rounding.
  return kStep * pattern.thirdDerivative() + 1e-8;
}

void expandPattern(const TpmsPattern& pattern, std::span<const Vec3<double>> places,
                   std::span<PatternExpansion> results) {
  PatternBatch<double> batch;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled as needed
  for (std::size_t k = 0; k < results.size(); ++k) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double step = i == axis + 1 ? kStep : 0;
        batch.inCells[axis][kSamples * k + i] =
            (places[k][static_cast<int>(axis)] + step) / kTwoPi<double>;
      }
    }
  }
  samplePattern(pattern.kind(), batch, static_cast<int>(kSamples * results.size()));
  for (std::size_t k = 0; k < results.size(); ++k) results[k] = expansionFrom(batch, kSamples * k);
}

double determinant(const SymmetricMatrix& a) {
  return dot(a[0], cross(a[1], a[2]));
}

bool isPositiveDefinite(double factor, const SymmetricMatrix& a, double shift) {
  // By Sylvester's criterion. A nearly singular matrix is not certain: its minors may be mere
  // rounding.
  constexpr double kRounding = 1e-13;
  SymmetricMatrix b{factor * a[0], factor * a[1], factor * a[2]};
  for (int i = 0; i < 3; ++i) b[static_cast<std::size_t>(i)][i] += shift;
  const double size = std::abs(b[0].x) + std::abs(b[1].y) + std::abs(b[2].z) + 1;
  const double minor = b[0].x * b[1].y - b[0].y * b[0].y;
  return b[0].x > kRounding * size && minor > kRounding * size * size &&
         determinant(b) > kRounding * size * size * size;
}

/// In closed form (Smith 1961, "Eigenvalues of a symmetric 3 x 3 matrix").
double leastEigenvalue(SymmetricMatrix a) {
  const double mean = (a[0].x + a[1].y + a[2].z) / 3;
  for (int i = 0; i < 3; ++i) a[static_cast<std::size_t>(i)][i] -= mean;
  const double spread =
      std::sqrt((lengthSquared(a[0]) + lengthSquared(a[1]) + lengthSquared(a[2])) / 6);
  if (!(spread > 0)) return mean;
  for (auto& column : a) column = column / spread;
  const double angle = std::acos(std::clamp(0.5 * determinant(a), -1.0, 1.0)) / 3;
  return mean + 2 * spread * std::cos(angle + kTwoPi<double> / 3);
}

}  // namespace cutwater::detail
