#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Simd/SineCosine.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "Support/Float128.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SineCosineTest : public ::testing::Test {};
TYPED_TEST_SUITE(SineCosineTest, Precisions);

template <typename T>
struct Both {
  std::vector<T> sines, cosines;
};

template <typename T>
Both<T> ofTurns(const std::vector<T>& turns) {
  Both<T> result{std::vector<T>(turns.size()), std::vector<T>(turns.size())};
  sinesAndCosines<T>(turns, result.sines, result.cosines);
  return result;
}

/// Small ones of every size, and large ones.
template <typename T>
std::vector<T> angles(int count) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> exponent(-30, 18);
  std::uniform_real_distribution<double> mantissa(-2, 2);
  std::vector<T> result;
  for (int i = 0; i < count; ++i) {
    const double size = i % 2 == 0 ? 1 : std::exp2(exponent(engine));
    result.push_back(static_cast<T>(mantissa(engine) * size));
  }
  return result;
}

/// sin(2 pi t) by Taylor's series, in quadruple precision.
Float128 sineOfTurns(Float128 t) {
  constexpr double kTwoPi[3] = {0x1.921fb54442d18p+2, 0x1.1a62633145c07p-52,
                                -0x1.f1976b7ed8fbcp-108};
  t -= static_cast<Float128>(std::nearbyint(static_cast<double>(t)));
  const Float128 y = t * (Float128(kTwoPi[0]) + kTwoPi[1] + kTwoPi[2]);
  Float128 term = y;
  Float128 sum = y;
  for (int k = 2; k < 60; k += 2) {
    term *= -y * y / (k * (k + 1));
    sum += term;
  }
  return sum;
}

template <typename T>
double ulpsOff(T value, Float128 exact) {
  if (std::abs(static_cast<double>(exact)) < 1e-30) return value == 0 ? 0 : 1e9;  // but for its pi
  const T rounded = static_cast<T>(exact);
  const T ulp =
      std::nextafter(std::abs(rounded), std::numeric_limits<T>::infinity()) - std::abs(rounded);
  const Float128 off = (Float128(value) - exact) / Float128(ulp);
  return std::abs(static_cast<double>(off));
}

TYPED_TEST(SineCosineTest, AreWithinTwoUnitsInTheLastPlace) {
  using T = TypeParam;
  const auto turns = angles<T>(scaled(40000));
  const auto [sines, cosines] = ofTurns(turns);
  double worst = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    worst = std::max(worst, ulpsOff(sines[i], sineOfTurns(turns[i])));
    worst = std::max(worst, ulpsOff(cosines[i], sineOfTurns(Float128(turns[i]) + Float128(0.25))));
  }
  EXPECT_LT(worst, 2);
  EXPECT_GT(worst, 0.5);  // or nothing was compared
}

TYPED_TEST(SineCosineTest, AreExactAtQuarterTurns) {
  using T = TypeParam;
  std::vector<T> turns;
  for (int i = -40; i <= 40; ++i) turns.push_back(static_cast<T>(i) / 4);
  turns.push_back(T(1 << 20) + T(0.25));
  const auto [sines, cosines] = ofTurns(turns);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const int quarter = static_cast<int>(std::fmod(4 * turns[i] + 400, T(4)));
    EXPECT_EQ(sines[i], T(quarter == 1 ? 1 : quarter == 3 ? -1 : 0)) << turns[i];
    EXPECT_EQ(cosines[i], T(quarter == 0 ? 1 : quarter == 2 ? -1 : 0)) << turns[i];
  }
}

TYPED_TEST(SineCosineTest, AreTheSameOneByOneAndOnEveryInstructionSet) {
  using T = TypeParam;
  const auto turns = angles<T>(1003);
  const auto together = ofTurns(turns);
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto alone = ofTurns(std::vector<T>{turns[i]});
    ASSERT_EQ(alone.sines[0], together.sines[i]) << turns[i];
    ASSERT_EQ(alone.cosines[0], together.cosines[i]) << turns[i];
  }
  // The test runs once for each set.
  const auto hash = xxHash64(std::as_bytes(std::span<const T>(together.sines))) ^
                    xxHash64(std::as_bytes(std::span<const T>(together.cosines)));
  EXPECT_EQ(hash, sizeof(T) == 4 ? 8869666280121400066U : 13174687721353375109U);
}

TYPED_TEST(SineCosineTest, RefusesSpansOfDifferentSizes) {
  std::vector<TypeParam> two(2);
  std::vector<TypeParam> one(1);
  EXPECT_THROW((sinesAndCosines<TypeParam>(two, one, two)), Error);
  EXPECT_THROW((sinesAndCosines<TypeParam>(two, two, one)), Error);
}

}  // namespace
}  // namespace cutwater::test
