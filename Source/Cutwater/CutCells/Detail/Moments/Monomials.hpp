#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cutwater {

/// The monomials of two or three variables, in the order of CutCells::Moments.
template <std::size_t kVariables>
class Monomials {
 public:
  static constexpr int kHighest = CutCells::Moments::kHighest;
  /// How many there are up to a degree.
  [[nodiscard]] static constexpr std::size_t count(int degree) {
    const auto n = static_cast<std::size_t>(degree) + 1;
    return kVariables == 2 ? n * (n + 1) / 2 : n * (n + 1) * (n + 2) / 6;
  }
  static constexpr std::size_t kCount = count(kHighest);

  struct Monomial {
    std::array<std::uint8_t, kVariables> powers{};
    int degree = 0;
    /// The monomials that are this one times one of the variables, but for the highest degree.
    std::array<std::uint8_t, kVariables> raised{};
    double factorials = 1;  ///< the product of its powers' factorials
  };
  static constexpr std::array<Monomial, kCount> all();

  [[nodiscard]] static constexpr std::size_t indexOf(
      const std::array<std::uint8_t, kVariables>& powers) {
    if constexpr (kVariables == 2) {
      return CutCells::Moments::indexOf(powers[0], powers[1]);
    } else {
      return CutCells::Moments::indexOf(powers[0], powers[1], powers[2]);
    }
  }
};

template <std::size_t kVariables>
constexpr auto Monomials<kVariables>::all() -> std::array<Monomial, kCount> {
  constexpr std::array<double, kHighest + 1> kFactorials{1, 1, 2, 6, 24};
  std::array<Monomial, kCount> result;
  std::array<std::uint8_t, kVariables> powers{};
  // Counts through all powers up to the highest degree.
  while (true) {
    Monomial monomial{.powers = powers};
    for (const auto power : powers) {
      monomial.degree += power;
      monomial.factorials *= kFactorials[power];
    }
    if (monomial.degree <= kHighest) {
      for (std::size_t axis = 0; axis < kVariables; ++axis) {
        auto more = powers;
        ++more[axis];
        monomial.raised[axis] = static_cast<std::uint8_t>(indexOf(more));
      }
      result[indexOf(powers)] = monomial;
    }
    std::size_t axis = 0;
    while (axis < kVariables && powers[axis] == kHighest) powers[axis++] = 0;
    if (axis == kVariables) return result;
    ++powers[axis];
  }
}

template <std::size_t kVariables>
inline constexpr auto kMonomials = Monomials<kVariables>::all();

/// The monomials of an offset up to a degree, in the order of CutCells::Moments.
template <std::size_t kVariables>
void evaluate(const std::array<double, kVariables>& offset, std::span<double> monomials) {
  monomials[0] = 1;
  const auto& table = kMonomials<kVariables>;
  for (std::size_t i = 0; i < monomials.size(); ++i) {
    for (std::size_t axis = 0; axis < kVariables; ++axis) {
      const std::size_t raised = table[i].raised[axis];
      const bool isHighest = table[i].degree == Monomials<kVariables>::kHighest;
      if (!isHighest && raised < monomials.size()) monomials[raised] = offset[axis] * monomials[i];
    }
  }
}

/// n! / m! for n <= m, the factor of a simplex.
[[nodiscard]] constexpr double factorialRatio(int n, int m) {
  double result = 1;
  for (int i = n + 1; i <= m; ++i) result /= i;
  return result;
}

/// Takes a further corner of a simplex into the complete homogeneous symmetric polynomials h_k of
/// the linear forms l_i(t) = corner_i . t, as coefficients of the monomials of t, for all k up to a
/// degree: h_k(..., l) = h_k(...) + l h_{k-1}(..., l). Those of no corner are 1, 0, 0, ...
///
/// They give the integrals of monomials over a simplex of dimension d, size V and d + 1 corners:
///
///     integral of x^a = V d! a! / (|a| + d)! times the coefficient of t^a in h_|a|
///
/// which is the formula for powers of linear forms (Lasserre and Avrachenkov 2001; Baldoni,
/// Berline, De Loera, Koeppe and Vergne 2011), compared power by power. A corner at the origin
/// changes nothing.
template <std::size_t kVariables>
void addCorner(std::array<double, Monomials<kVariables>::kCount>& h, int degree,
               const std::array<double, kVariables>& corner) {
  const auto& table = kMonomials<kVariables>;
  const auto count = Monomials<kVariables>::count(degree - 1);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < kVariables; ++axis) {
      h[table[i].raised[axis]] += corner[axis] * h[i];
    }
  }
}

/// Makes moments about a point those about another one: `by` leads from that to this one. Each step
/// multiplies one factor of a power by its offset, as in Pascal's triangle.
template <std::size_t kVariables, typename Value, std::size_t kSize>
void shift(std::span<Value, kSize> moments, int degree, const std::array<double, kVariables>& by) {
  const auto& table = kMonomials<kVariables>;
  for (std::size_t axis = 0; axis < kVariables; ++axis) {
    for (int step = 0; step < degree; ++step) {
      for (auto i = Monomials<kVariables>::count(degree - 1); i-- > 0;) {
        if (table[i].powers[axis] < step) continue;
        moments[table[i].raised[axis]] += by[axis] * moments[i];
      }
    }
  }
}

/// Adds moments about a point to those about another one: `by` leads from that to this one.
template <std::size_t kVariables, typename Value>
void addShifted(std::span<const Value> moments, int degree,
                const std::array<double, kVariables>& by, std::span<Value> to) {
  std::array<Value, Monomials<kVariables>::kCount> moved{};
  std::copy(moments.begin(), moments.end(), moved.begin());
  shift(std::span(moved), degree, by);
  for (std::size_t i = 0; i < moments.size(); ++i) to[i] += moved[i];
}

/// Of a box between these offsets from the point that they refer to.
template <std::size_t kVariables>
[[nodiscard]] std::array<double, Monomials<kVariables>::kCount> momentsOfBox(
    const std::array<double, kVariables>& lower, const std::array<double, kVariables>& upper) {
  std::array<double, Monomials<kVariables>::kCount> result{};
  std::array<double, kVariables> center{};
  for (std::size_t axis = 0; axis < kVariables; ++axis) {
    center[axis] = 0.5 * (lower[axis] + upper[axis]);
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = 1;
    for (std::size_t axis = 0; axis < kVariables; ++axis) {
      const int power = kMonomials<kVariables>[i].powers[axis];
      const double width = upper[axis] - lower[axis];
      result[i] *= power % 2 == 0 ? width / (power + 1) : 0;
      for (int n = 0; n < power; ++n) result[i] *= width / 2;
    }
  }
  shift(std::span(result), CutCells::Moments::kHighest, center);
  return result;
}

/// The axes of a face across an axis, in ascending order: those of its moments.
[[nodiscard]] constexpr std::array<int, 2> axesAlongFace(int across) {
  return {across == 0 ? 1 : 0, across == 2 ? 1 : 2};
}
[[nodiscard]] inline std::array<double, 2> alongFace(const Vec3<double>& p, int across) {
  const auto [first, second] = axesAlongFace(across);
  return {p[first], p[second]};
}
[[nodiscard]] inline std::array<double, 3> asArray(const Vec3<double>& p) {
  return {p.x, p.y, p.z};
}

/// What the moments of a part of a face are in three variables, about a point at this distance
/// below it.
[[nodiscard]] inline std::array<double, Monomials<3>::kCount> inSpace(
    std::span<const double> ofFace, int degree, int across, double distance) {
  std::array<double, Monomials<3>::kCount> result{};
  const auto [first, second] = axesAlongFace(across);
  for (std::size_t i = 0; i < Monomials<3>::count(degree); ++i) {
    const auto& powers = kMonomials<3>[i].powers;
    result[i] = ofFace[Monomials<2>::indexOf(
        {powers[static_cast<std::size_t>(first)], powers[static_cast<std::size_t>(second)]})];
    for (int n = 0; n < powers[static_cast<std::size_t>(across)]; ++n) result[i] *= distance;
  }
  return result;
}

}  // namespace cutwater
