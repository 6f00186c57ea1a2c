#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cutwater {

/// A point of a rule on the unit interval.
struct GaussPoint {
  double at = 0;
  double weight = 0;
};

/// The most points that a rule has.
inline constexpr int kMostGaussPoints = 6;

/// The Gauss-Legendre rule of so many points, 1 to kMostGaussPoints, on [0, 1]: exact for
/// polynomials of degree 2 points - 1 (Abramowitz and Stegun 1964, 25.4.30).
[[nodiscard]] inline std::span<const GaussPoint> gaussPoints(int points) {
  // On [-1, 1], from the middle outwards, with the weight of each.
  struct Half {
    std::array<double, 3> at;
    std::array<double, 3> weight;
  };
  static constexpr std::array<Half, kMostGaussPoints> kHalves{{
      {{0}, {2}},
      {{0.5773502691896257645}, {1}},
      {{0, 0.7745966692414833770}, {0.8888888888888888889, 0.5555555555555555556}},
      {{0.3399810435848562648, 0.8611363115940525752},
       {0.6521451548625461426, 0.3478548451374538574}},
      {{0, 0.5384693101056830910, 0.9061798459386639928},
       {0.5688888888888888889, 0.4786286704993664680, 0.2369268850561890875}},
      {{0.2386191860831969086, 0.6612093864662645137, 0.9324695142031520278},
       {0.4679139345726910473, 0.3607615730481386076, 0.1713244923791703450}},
  }};
  struct Table {
    std::array<GaussPoint, kMostGaussPoints*(kMostGaussPoints + 1) / 2> points;
    std::array<std::size_t, kMostGaussPoints + 1> first;
  };
  static constexpr auto kTable = [] {
    Table table{};
    std::size_t next = 0;
    for (std::size_t n = 1; n <= kMostGaussPoints; ++n) {
      const auto& half = kHalves[n - 1];
      table.first[n] = next;
      for (std::size_t i = 0; i < n; ++i) {
        const bool isLow = i < n / 2;
        const auto fromMiddle = isLow ? (n + 1) / 2 - 1 - i : i - n / 2;
        const double at = half.at[fromMiddle];
        table.points[next++] = {0.5 + 0.5 * (isLow ? -at : at), 0.5 * half.weight[fromMiddle]};
      }
    }
    return table;
  }();
  const auto count = static_cast<std::size_t>(points);
  return std::span(kTable.points).subspan(kTable.first[count], count);
}

/// The rule of fewest points that is exact for polynomials of this degree.
[[nodiscard]] inline std::span<const GaussPoint> gaussOfDegree(int degree) {
  return gaussPoints(degree / 2 + 1);
}

/// Calls visit(at, weight, number of the stretch) for the points of a rule in each stretch from
/// `low` on, between ascending ends; empty ones have none.
template <typename Ends, typename Visit>
void forStretches(std::span<const GaussPoint> rule, double low, const Ends& ends,
                  const Visit& visit) {
  std::uint32_t stretch = 0;
  for (const double high : ends) {
    if (!(high > low)) continue;
    for (const auto& g : rule) visit(low + g.at * (high - low), g.weight * (high - low), stretch);
    low = high;
    ++stretch;
  }
}

}  // namespace cutwater
