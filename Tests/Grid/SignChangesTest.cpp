#include <Cutwater/Grid/Detail/SignChanges.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <atomic>
#include <cmath>

#include "Support/Precisions.hpp"

namespace cutwater::detail {
namespace {

using cutwater::test::Precisions;

/// A function of x alone, and how often it was asked for.
template <typename T, typename Function>
struct Counted {
  Function function;
  std::atomic<int>* calls;

  T operator()(const Vec3<T>& p) const {
    ++*calls;
    return function(p.x);
  }
};

template <typename T>
class SignChangesTest : public ::testing::Test {
 protected:
  /// Where the function changes its sign between 0 and 1, and after how many evaluations.
  template <typename Function>
  static std::pair<double, int> found(Function function, double tolerance) {
    std::atomic<int> calls{0};
    const FunctionSDF solid(Counted<T, Function>{function, &calls}, Guarantee<T>{});
    const std::array<SignChange<T>, 1> change{
        {{{0, 0, 0}, {1, 0, 0}, double(function(0)), double(function(1))}}};
    const auto result = locate<T>(solid, change, tolerance);
    return {result.at(0), calls};
  }
};
TYPED_TEST_SUITE(SignChangesTest, Precisions);

TYPED_TEST(SignChangesTest, FindsTheRootWithinTheTolerance) {
  using T = TypeParam;
  const double tolerance = 1e-4;
  // Bisection takes 14 evaluations.
  const auto expectRoot = [&](auto function, double root, int most) {
    const auto [at, calls] = this->found(function, tolerance);
    EXPECT_NEAR(at, root, 0.5 * tolerance + 4 * std::numeric_limits<T>::epsilon());
    EXPECT_LE(calls, most);
  };
  expectRoot([](T x) { return x - T(0.3); }, 0.3, 5);
  expectRoot([](T x) { return T(0.3) - x; }, 0.3, 5);
  expectRoot([](T x) { return x * x - T(0.5); }, std::sqrt(0.5), 9);
  expectRoot([](T x) { return std::sqrt(x) - T(0.01); }, 1e-4, 15);
  expectRoot([](T x) { return x * x * x * x * x * x * x * x * x - T(1e-6); },
             std::pow(1e-6, 1.0 / 9), 15);
  expectRoot([](T x) { return x < T(0.77) ? T(-1) : T(1e-6); }, 0.77, 15);
  expectRoot([](T x) { return x < T(0.77) ? T(-1e-6) : T(1); }, 0.77, 15);
}

TYPED_TEST(SignChangesTest, SignsDecideWhereValuesAreNone) {
  using T = TypeParam;
  constexpr T kInfinity = std::numeric_limits<T>::infinity();
  constexpr T kNan = std::numeric_limits<T>::quiet_NaN();
  const double half = 0.5e-3;
  EXPECT_NEAR(this->found([](T x) { return x < T(0.4) ? -kInfinity : kInfinity; }, 1e-3).first, 0.4,
              half);
  // What is no number is outside, as 0 is.
  EXPECT_NEAR(this->found([](T x) { return x < T(0.4) ? T(-1) : kNan; }, 1e-3).first, 0.4, half);
  EXPECT_NEAR(this->found([](T x) { return x < T(0.4) ? T(-1) : T(0); }, 1e-3).first, 0.4, half);
}

TYPED_TEST(SignChangesTest, LiesStrictlyBetweenTheEnds) {
  using T = TypeParam;
  const auto atEnd = this->found([](T x) { return x - T(1); }, 1e-3).first;
  EXPECT_LT(atEnd, 1);
  EXPECT_GT(atEnd, 1 - 1e-3);
  const auto atBegin = this->found([](T x) { return -x; }, 1e-3).first;
  EXPECT_GT(atBegin, 0);
  EXPECT_LT(atBegin, 1e-3);
}

TYPED_TEST(SignChangesTest, ManyAreFoundAtOnceAsOneByOne) {
  using T = TypeParam;
  const auto ball = [](const Vec3<T>& p) { return length(p) - T(1); };
  const FunctionSDF solid(ball, Guarantee<T>{});
  std::vector<SignChange<T>> changes;
  for (int i = 0; i < 100; ++i) {
    const Vec3<T> from{T(0.01) * static_cast<T>(i % 7), T(0.02) * static_cast<T>(i % 11), 0};
    const Vec3<T> to{std::cos(T(i)), std::sin(T(i)), T(1) + T(0.1) * static_cast<T>(i % 3)};
    changes.push_back({from, to, double(ball(from)), double(ball(to))});
  }
  const auto together = locate<T>(solid, changes, 1e-3);
  ASSERT_EQ(together.size(), changes.size());
  for (std::size_t n = 0; n < changes.size(); ++n) {
    const std::span<const SignChange<T>> one(&changes[n], 1);
    EXPECT_EQ(together[n], locate<T>(solid, one, 1e-3).at(0));
    const T edge = length(changes[n].to - changes[n].from);
    EXPECT_LE(std::abs(ball(changes[n].at(together[n]))), T(0.51e-3) * edge);
  }
  EXPECT_TRUE(locate<T>(solid, {}, 1e-3).empty());
}

}  // namespace
}  // namespace cutwater::detail
