#include <Cutwater/Operations/Detail/SmoothMinimum.hpp>

#include <algorithm>
#include <random>
#include <vector>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using Kind = SmoothKind;
constexpr Kind kMinimumKinds[] = {Kind::Quadratic, Kind::Cubic, Kind::Circular, Kind::Exponential};

/// The value of all, and by how much it grows with each of them.
template <typename T>
struct Folded {
  T value;
  std::vector<T> weights;
};

template <typename T>
Folded<T> fold(const std::vector<T>& values, const Smoothing<T>& smoothing) {
  detail::SmoothMinimum<T> sum(smoothing, values[0]);
  std::vector<T> weights{1};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const T weight = sum.add(values[i]);
    for (auto& other : weights) other *= 1 - weight;
    weights.push_back(weight);
  }
  return {sum.value(), weights};
}

template <typename T>
class SmoothMinimumTest : public ::testing::Test {};
TYPED_TEST_SUITE(SmoothMinimumTest, Precisions);

TYPED_TEST(SmoothMinimumTest, HasTheFormulasItStates) {
  using T = TypeParam;
  const T k = 2;
  const auto close = [](T value, double expected) {
    EXPECT_NEAR(static_cast<double>(value), expected, tolerance<T>(4));
  };
  for (const double b : {1.0, 1.25, 2.0, 2.9, 3.0, 7.0}) {
    const std::vector<T> both{1, static_cast<T>(b)};
    const double h = std::max(2 - (b - 1), 0.0) / 2;
    close(fold(both, {k, Kind::Quadratic}).value, 1 - 2 * h * h / 4);
    close(fold(both, {k, Kind::Cubic}).value, 1 - 2 * h * h * h / 6);
    close(fold(both, {k, Kind::Circular}).value, 1 - (1 + h - std::sqrt(1 - h * (h - 2))));
    close(fold(both, {k, Kind::Exponential}).value,
          -2 * std::log(std::exp(-0.5) + std::exp(-0.5 * b)));
  }
}

TYPED_TEST(SmoothMinimumTest, CirclesAreCircles) {
  using T = TypeParam;
  // Of the half-spaces x < 0 and y < 0, the fillet has radius k about (k, k).
  const double k = 0.75;
  for (const double angle : {0.3, 0.5, 0.7, std::numbers::pi / 4}) {
    const auto valueAt = [&](double t) {
      const T x = static_cast<T>(t * std::cos(angle));
      const T y = static_cast<T>(t * std::sin(angle));
      return fold<T>({std::min(x, y), std::max(x, y)}, {static_cast<T>(k), Kind::Circular}).value;
    };
    double inside = 0;
    double outside = 2;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (inside + outside);
      (valueAt(middle) < 0 ? inside : outside) = middle;
    }
    const double x = inside * std::cos(angle);
    const double y = inside * std::sin(angle);
    EXPECT_NEAR(std::hypot(x - k, y - k), k, tolerance<T>(4)) << angle;
  }
}

TYPED_TEST(SmoothMinimumTest, AddsNoMoreThanItStates) {
  using T = TypeParam;
  const T k = T(0.5);
  for (const auto kind : kMinimumKinds) {
    for (const std::size_t count : {2U, 3U, 5U, 50U, 1000U}) {
      const std::vector<T> equal(count, T(3));  // the worst case
      const T most = detail::SmoothMinimum<T>::mostAdded({k, kind}, count);
      const T added = 3 - fold(equal, {k, kind}).value;
      const T rounding = tolerance<T>(3);
      EXPECT_LE(added, most + rounding) << count;
      const bool isTight = count == 2 || kind == Kind::Exponential;
      EXPECT_GE(added, isTight ? most * T(0.9999) - rounding : T(0));
      EXPECT_LT(added, kind == Kind::Exponential ? 8 * k : k);
      EXPECT_GT(added, count == 1000 ? T(0.9) * k : T(0));
    }
  }
}

TYPED_TEST(SmoothMinimumTest, WeightsSumToOneAndAreItsDerivatives) {
  using T = TypeParam;
  std::mt19937 engine(5);
  std::uniform_real_distribution<T> number(-1, 1);
  for (const auto kind : kMinimumKinds) {
    for (int i = 0; i < 200; ++i) {
      std::vector<T> values(5);
      for (auto& value : values) value = number(engine);
      std::sort(values.begin(), values.end());
      const auto [value, weights] = fold(values, {1, kind});
      T sum = 0;
      for (const T weight : weights) {
        EXPECT_GE(weight, T(0));
        sum += weight;
      }
      EXPECT_NEAR(sum, T(1), tolerance<T>(1));
      // In ascending order it stays so under small changes of one value.
      const T delta = std::cbrt(std::numeric_limits<T>::epsilon());
      for (std::size_t j = 0; j < values.size(); ++j) {
        auto more = values;
        auto less = values;
        more[j] += delta;
        less[j] -= delta;
        std::sort(more.begin(), more.end());
        std::sort(less.begin(), less.end());
        const T slope = (fold(more, {1, kind}).value - fold(less, {1, kind}).value) / (2 * delta);
        EXPECT_NEAR(slope, weights[j], 4 * delta);
      }
    }
  }
}

TYPED_TEST(SmoothMinimumTest, IsInvariantUnderAConstant) {
  using T = TypeParam;
  for (const auto kind : kMinimumKinds) {
    const std::vector<T> values{-1, T(-0.5), 0, T(0.25)};
    auto more = values;
    for (auto& value : more) value += 8;
    EXPECT_NEAR(fold(more, {2, kind}).value, fold(values, {2, kind}).value + 8, tolerance<T>(8));
  }
}

}  // namespace
}  // namespace cutwater::test
