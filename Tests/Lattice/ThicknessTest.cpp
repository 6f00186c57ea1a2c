#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Thickness.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ThicknessTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThicknessTest, Precisions);

template <typename T>
struct Waves {
  T operator()(const Vec3<T>& p) const { return 1 + T(0.5) * std::sin(2 * p.x); }
};
template <typename T>
struct NoNumber {
  T operator()(const Vec3<T>&) const { return std::numeric_limits<T>::quiet_NaN(); }
};

TYPED_TEST(ThicknessTest, ConstantIsTheSameEverywhere) {
  using T = TypeParam;
  const Thickness<T> thickness = T(0.25);
  EXPECT_TRUE(thickness.isConstant());
  EXPECT_EQ(thickness.at({1, 2, 3}, {4, 5, 6}), T(0.25));
  EXPECT_EQ(thickness.guarantee(1).lipschitz, T(0));
  EXPECT_EQ(Thickness<T>::constant(2).at({}, {}), T(2));
}

TYPED_TEST(ThicknessTest, ByDistanceIsLinearAndThenConstant) {
  using T = TypeParam;
  const auto thickness = Thickness<T>::byDistanceTo(Sphere<T>({0, 0, 0}, 4), {3, 1, 2});
  EXPECT_FALSE(thickness.isConstant());
  EXPECT_EQ(thickness.at({4, 0, 0}, {}), T(3));
  EXPECT_EQ(thickness.at({0, 5, 0}, {}), T(2));
  EXPECT_EQ(thickness.at({0, 0, 3}, {}), T(2));  // inside alike
  EXPECT_EQ(thickness.at({9, 0, 0}, {}), T(1));
  EXPECT_EQ(thickness.at({0, 0, 0}, {}), T(1));
  EXPECT_EQ(thickness.guarantee(1).lipschitz, T(1));
  EXPECT_EQ(thickness.least(), T(1));
  EXPECT_EQ(thickness.most(), T(3));
}

TYPED_TEST(ThicknessTest, ByDistanceToCellCenterIsTheSameInEveryCell) {
  using T = TypeParam;
  const auto thickness = Thickness<T>::byDistanceToCellCenter(1, 2);
  const T atFace = 1 + std::sqrt(T(0.25) / T(0.75));
  for (const T cell : {T(0), T(1), T(-3)}) {
    EXPECT_EQ(thickness.at({}, {cell + T(0.5), T(0.5), T(0.5)}), T(1));
    EXPECT_NEAR(thickness.at({}, {cell, 0, cell}), T(2), tolerance<T>(2));
    EXPECT_NEAR(thickness.at({}, {cell, T(0.5), T(0.5)}), atFace, tolerance<T>(2));
  }
  EXPECT_NEAR(*thickness.guarantee(T(0.5)).lipschitz, 2 / std::sqrt(T(0.75)), tolerance<T>(2));
}

TYPED_TEST(ThicknessTest, FunctionsAreKeptWithinTheirLimits) {
  using T = TypeParam;
  const auto waves = Thickness<T>::by(Waves<T>(), {.lipschitz = 1, .least = T(0.75), .most = 2});
  EXPECT_EQ(waves.at({0, 1, 2}, {}), T(1));
  EXPECT_EQ(waves.at({T(-0.785), 1, 2}, {}), T(0.75));
  EXPECT_NEAR(waves.at({T(0.785), 1, 2}, {}), T(1.5), T(1e-5));
  EXPECT_EQ(waves.guarantee(1).lipschitz, T(1));
  const auto none = Thickness<T>::by(NoNumber<T>(), {.lipschitz = 1, .least = 1, .most = 2});
  EXPECT_EQ(none.at({0, 0, 0}, {}), T(1));
}

TYPED_TEST(ThicknessTest, LipschitzConstantsAreKept) {
  using T = TypeParam;
  const T cell = T(0.5);
  const Thickness<T> kinds[] = {
      Thickness<T>::byDistanceTo(Sphere<T>({0, 0, 0}, 1), {T(0.5), 1, T(0.25)}),
      Thickness<T>::byDistanceToCellCenter(2, 1),
      Thickness<T>::by(Waves<T>(), {.lipschitz = 1, .least = T(0.75), .most = 2})};
  RandomPoints<T> random(2);
  for (const auto& thickness : kinds) {
    const auto known = thickness.guarantee(cell);
    T steepest = 0;
    for (int i = 0; i < 2000; ++i) {
      const auto p = random.next();
      const auto q = p + T(0.01) * random.next();
      const T change = std::abs(thickness.at(p, p / cell) - thickness.at(q, q / cell));
      const T rounding = known.error(length(p)) + known.error(length(q));
      EXPECT_LE(change, *known.lipschitz * length(p - q) + rounding);
      steepest = std::max(steepest, change / length(p - q));
    }
    EXPECT_GT(steepest, T(0.8) * *known.lipschitz);
  }
}

TYPED_TEST(ThicknessTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const Solid<T> ball = Sphere<T>({0, 0, 0}, 1);
  constexpr T kInf = std::numeric_limits<T>::infinity();
  for (const T bad : {T(0), T(-1), kInf, std::numeric_limits<T>::quiet_NaN()}) {
    const auto expectRefused = [&](auto make) {
      const std::string words = refusal(make);  // of the number, or of the radius that it is
      EXPECT_TRUE(words.starts_with("Thickness: need ") || words.starts_with("GradedValue: need "))
          << words << bad;
    };
    expectRefused([&] { (void)Thickness<T>(bad); });
    expectRefused([&] { (void)Thickness<T>::byDistanceTo(ball, {bad, 1, 1}); });
    expectRefused([&] { (void)Thickness<T>::byDistanceTo(ball, {1, bad, 1}); });
    expectRefused([&] { (void)Thickness<T>::byDistanceTo(ball, {1, 2, bad}); });
    expectRefused([&] { (void)Thickness<T>::byDistanceToCellCenter(bad, 1); });
    expectRefused([&] { (void)Thickness<T>::byDistanceToCellCenter(1, bad); });
    expectRefused([&] { (void)Thickness<T>::by(Waves<T>(), {1, bad, 2}); });
    expectRefused([&] { (void)Thickness<T>::by(Waves<T>(), {1, 3, bad}); });
    if (bad != 0) expectRefused([&] { (void)Thickness<T>::by(Waves<T>(), {bad, 1, 2}); });
  }
  const FunctionSDF<T, Waves<T>> onlySign({}, {.lipschitz = {}, .continuous = true});
  EXPECT_EQ(refusal([&] {
              (void)Thickness<T>::byDistanceTo(onlySign, {1, 2, 1});
            }),
            "GradedValue: need a solid whose values have a Lipschitz constant");
}

}  // namespace
}  // namespace cutwater::test
