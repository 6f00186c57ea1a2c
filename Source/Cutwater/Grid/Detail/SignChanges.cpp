#include <Cutwater/Grid/Detail/SignChanges.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// kappa1 of the method, tuned on distances from balls: smaller values pay off where values are
/// nearly linear.
constexpr double kTruncation = 0.02;

/// The interval from a to b in which the sign is known to change.
struct Bracket {
  double a = 0;
  double b = 1;
  double valueA;
  double valueB;

  /// Where to evaluate next; `slack` is how far from the middle that may be, so that the number of
  /// steps stays bounded.
  [[nodiscard]] double next(double slack) const {
    const double middle = 0.5 * (a + b);
    const double width = b - a;
    double guess = (valueB * a - valueA * b) / (valueB - valueA);
    if (!std::isfinite(guess)) guess = middle;
    // Truncated towards the middle, then projected onto the range that the bound allows.
    const double towards = std::copysign(
        std::min(kTruncation * width * width, std::abs(middle - guess)), middle - guess);
    return middle + std::clamp(guess + towards - middle, -slack, slack);
  }
  void narrow(double t, double value) {
    if ((value < 0) == (valueA < 0)) {
      a = t;
      valueA = value;
    } else {
      b = t;
      valueB = value;
    }
  }
};

}  // namespace

template <std::floating_point T>
std::vector<double> locate(const SignedDistanceFunction<T>& solid,
                           std::span<const SignChange<T>> changes, double tolerance) {
  std::vector<Bracket> brackets;
  std::vector<std::size_t> open;
  brackets.reserve(changes.size());
  for (const auto& change : changes) {
    open.push_back(brackets.size());
    brackets.push_back({.valueA = change.valueFrom, .valueB = change.valueTo});
  }
  std::vector<double> next(changes.size());
  std::vector<Vec3<T>> points;
  std::vector<T> values;
  // After this many halvings of 1, and one more step, brackets are narrow enough.
  double reach = std::exp2(std::ceil(std::log2(1 / tolerance))) * tolerance;
  while (!open.empty()) {
    points.clear();
    for (const auto n : open) {
      const auto& bracket = brackets[n];
      next[n] = bracket.next(std::max(reach - 0.5 * (bracket.b - bracket.a), 0.0));
      points.push_back(changes[n].at(next[n]));
    }
    values.resize(points.size());
    solid.signedDistances(points, values, {.threads = 1});
    for (std::size_t i = 0; i < open.size(); ++i)
      brackets[open[i]].narrow(next[open[i]], values[i]);
    reach *= 0.5;
    std::erase_if(open, [&](std::size_t n) {
      return brackets[n].b - brackets[n].a <= tolerance || reach < 0.25 * tolerance;
    });
  }
  std::vector<double> result;
  result.reserve(brackets.size());
  for (const auto& bracket : brackets) result.push_back(0.5 * (bracket.a + bracket.b));
  return result;
}

template std::vector<double> locate(const SignedDistanceFunction<float>&,
                                    std::span<const SignChange<float>>, double);
template std::vector<double> locate(const SignedDistanceFunction<double>&,
                                    std::span<const SignChange<double>>, double);

}  // namespace cutwater::detail
