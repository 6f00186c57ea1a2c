#pragma once

#include <Cutwater/Tpms/TpmsPattern.hpp>

#include <array>
#include <span>

namespace cutwater::detail {

/// A symmetric matrix, by columns.
using SymmetricMatrix = std::array<Vec3<double>, 3>;

/// Expansion of a pattern about a point, in radians:
///
///     |F(q + v) - (F + g v + v A v / 2)| <= T |v|^3 / 6       T: TpmsPattern::thirdDerivative()
struct PatternExpansion {
  static constexpr int kMostAtOnce = 16;

  double value;
  Vec3<double> gradient;
  SymmetricMatrix second;  ///< error of eigenvalues: at most secondError()

  /// The error of second derivatives, which are differences of gradients.
  [[nodiscard]] static double secondError(const TpmsPattern& pattern);
};

/// Expands a pattern about up to kMostAtOnce points: as many as `results` has room for.
void expandPattern(const TpmsPattern& pattern, std::span<const Vec3<double>> places,
                   std::span<PatternExpansion> results);

[[nodiscard]] double determinant(const SymmetricMatrix& a);
/// Whether all eigenvalues of factor a + shift are certainly positive.
[[nodiscard]] bool isPositiveDefinite(double factor, const SymmetricMatrix& a, double shift);
[[nodiscard]] double leastEigenvalue(SymmetricMatrix a);

}  // namespace cutwater::detail
