#pragma once

#include <Cutwater/Tpms/Detail/PatternBatch.hpp>

namespace cutwater::detail {

/// psi = absolute |F| + plain F + level h, or half F if that is more: the part is where psi < 0.
/// Each factor is -1, 0 or 1, and psi changes no faster than F and h do.
template <std::floating_point T>
struct PartTerms {
  T absolute;
  T plain;
  T level;
  T half;
};

/// Quantities from which the distance to a level of a pattern follows. Slopes are per radian of the
/// axis with the smallest cells.
template <std::floating_point T>
struct LevelTerms {
  PartTerms<T> part;
  Vec3<T> weight;    ///< of each axis: the smallest cell size over its own
  T levelSlope;      ///< an upper bound, of the level h
  T leastSlope;      ///< replaces slopes below it: keeps rounding small
  T perLipschitz;    ///< 1 / (the largest slope of F plus that of the level)
  T twiceCurvature;  ///< 2 H
  T lengthPerRadian;
};

/// Points of a pattern, component by component.
template <std::floating_point T>
struct alignas(64) LevelBatch {
  static constexpr int kMost = 64;
  using Row = std::array<T, kMost>;

  std::array<Row, 3> inCells;
  Row level;     ///< h at each
  Row distance;  ///< the result
};

/// A lower bound of the distance to psi = 0, with the sign of psi. Let s bound the slope of psi:
/// |grad F| plus the slope of the level. Over a distance r, psi can change by no more than s r + H
/// r^2 / 2, and by no more than L r, so
///
///     max(|psi| / L, (sqrt(s^2 + 2 H |psi|) - s) / H)
///
/// is such a bound. As functions of position, both terms are 1-Lipschitz: with d the second,
/// |psi| = s d + H d^2 / 2 gives (s + H d) grad d = grad |psi| - d grad s, where |grad |psi|| <= s
/// and |grad s| <= H. So is the product with the sign, as both vanish where the sign changes.
/// Compiled for each instruction set from one source: LevelDistances.inl.
template <std::floating_point T>
void levelDistances(TpmsKind kind, const LevelTerms<T>& terms, LevelBatch<T>& batch, int count);

/// The same, to the bit, at one point.
template <std::floating_point T>
[[nodiscard]] T levelDistance(TpmsKind kind, const LevelTerms<T>& terms, const Vec3<T>& inCells,
                              T level);

extern template void levelDistances(TpmsKind, const LevelTerms<float>&, LevelBatch<float>&, int);
extern template void levelDistances(TpmsKind, const LevelTerms<double>&, LevelBatch<double>&, int);
extern template float levelDistance(TpmsKind, const LevelTerms<float>&, const Vec3<float>&, float);
extern template double levelDistance(TpmsKind, const LevelTerms<double>&, const Vec3<double>&,
                                     double);

}  // namespace cutwater::detail
