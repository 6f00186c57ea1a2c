#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>
#include <vector>

namespace cutwater::detail {

/// Two points with values of different sign: exactly one of them is inside.
template <std::floating_point T>
struct SignChange {
  Vec3<T> from;
  Vec3<T> to;
  double valueFrom;
  double valueTo;

  [[nodiscard]] Vec3<T> at(double t) const { return from + static_cast<T>(t) * (to - from); }
};

/// For each change, finds where between its ends (0 < t < 1) the sign changes: it certainly does so
/// within tolerance / 2 of the result. Only signs decide; values speed up the search where they are
/// nearly linear. All changes are evaluated together, a few times.
///
/// The ITP method of Oliveira and Takahashi, "An Enhancement of the Bisection Method Average
/// Performance Preserving Minmax Optimality", ACM TOMS 47 (2020), with kappa1 = 0.02, kappa2 = 2
/// and n0 = 1: at most one evaluation more than bisection.
template <std::floating_point T>
[[nodiscard]] std::vector<double> locate(const SignedDistanceFunction<T>& solid,
                                         std::span<const SignChange<T>> changes, double tolerance);

extern template std::vector<double> locate(const SignedDistanceFunction<float>&,
                                           std::span<const SignChange<float>>, double);
extern template std::vector<double> locate(const SignedDistanceFunction<double>&,
                                           std::span<const SignChange<double>>, double);

}  // namespace cutwater::detail
