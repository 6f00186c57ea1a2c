#include <Cutwater/Core/Detail/DoubleDouble.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "Support/Float128.hpp"

namespace cutwater::test {
namespace {

constexpr double kBound = 0x1p-102;  // the relative error that is promised

Float128 exact(DoubleDouble a) {
  return Float128(a.high) + a.low;
}

double relativeError(DoubleDouble got, Float128 want) {
  const Float128 error = (exact(got) - want) / want;
  return std::abs(static_cast<double>(error));
}

/// Doubles of either sign with exponents spread over +-`spread`.
class Numbers {
 public:
  explicit Numbers(int spread) : exponent_(-spread, spread) {}

  double next() { return std::ldexp(mantissa_(engine_), exponent_(engine_)); }
  /// Of no more than 104 bits, which Float128 holds without rounding.
  DoubleDouble nextPair() {
    const double high = next();
    const double low = std::round(mantissa_(engine_) * 0x1p50);
    return DoubleDouble::sum(high, std::ldexp(low, std::ilogb(high) - 103));
  }

 private:
  std::mt19937_64 engine_{1};
  std::uniform_real_distribution<double> mantissa_{-1, 1};
  std::uniform_int_distribution<int> exponent_;
};

TEST(DoubleDouble, KnowsHandValues) {
  const DoubleDouble third = DoubleDouble(1) / DoubleDouble(3);
  EXPECT_EQ(third.high, 1.0 / 3.0);
  EXPECT_EQ(third.low, 0x1p-54 / 3.0);  // 1/3 = .0101..., and 53 bits of it are 1/3 - 2^-54 / 3
  EXPECT_EQ((DoubleDouble(1) + DoubleDouble(0x1p-80)).low, 0x1p-80);
  EXPECT_EQ(static_cast<double>(DoubleDouble(1) + DoubleDouble(0x1p-80) - DoubleDouble(1)),
            0x1p-80);
  EXPECT_EQ(sqrt(DoubleDouble(4)), DoubleDouble(2));
  EXPECT_EQ(sqrt(DoubleDouble(0)), DoubleDouble(0));
  EXPECT_TRUE(std::isnan(sqrt(DoubleDouble(-1)).high));
  EXPECT_EQ(abs(DoubleDouble(-3, 0x1p-60)), DoubleDouble(3, -0x1p-60));
}

TEST(DoubleDouble, SumsAndProductsOfDoublesAreExact) {
  Numbers numbers(25);  // so that 113 bits hold the results
  for (int i = 0; i < 100000; ++i) {
    const double a = numbers.next();
    const double b = numbers.next();
    ASSERT_TRUE(exact(DoubleDouble::sum(a, b)) == Float128(a) + b);
    ASSERT_TRUE(exact(DoubleDouble::difference(a, b)) == Float128(a) - b);
    ASSERT_TRUE(exact(DoubleDouble::product(a, b)) == Float128(a) * b);
  }
}

TEST(DoubleDouble, KeepsItsErrorBound) {
  Numbers numbers(40);
  for (int i = 0; i < 100000; ++i) {
    const DoubleDouble a = numbers.nextPair();
    const DoubleDouble b = numbers.nextPair();
    ASSERT_LE(relativeError(a + b, exact(a) + exact(b)), kBound);
    ASSERT_LE(relativeError(a - b, exact(a) - exact(b)), kBound);
    ASSERT_LE(relativeError(a * b, exact(a) * exact(b)), kBound);
    ASSERT_LE(relativeError(a / b, exact(a) / exact(b)), kBound);
    ASSERT_LE(relativeError(sqrt(abs(a)), squareRoot(exact(abs(a)))), kBound);
  }
}

TEST(DoubleDouble, KeepsItsErrorBoundUnderCancellation) {
  Numbers numbers(2);
  for (int i = 0; i < 100000; ++i) {
    const DoubleDouble a = numbers.nextPair();
    const DoubleDouble b = DoubleDouble::sum(a.high, a.low * 0.5);
    if (a == b) continue;
    ASSERT_LE(relativeError(a - b, exact(a) - exact(b)), kBound);
  }
}

TEST(DoubleDouble, Compares) {
  const DoubleDouble one(1);
  const DoubleDouble more(1, 0x1p-60);
  EXPECT_LT(one, more);
  EXPECT_GT(more, one);
  EXPECT_LE(one, one);
  EXPECT_GE(one, one);
  EXPECT_FALSE(more <= one);
  EXPECT_FALSE(one >= more);
  EXPECT_FALSE(one == more);
}

TEST(DoubleDouble, VectorsSurviveWhereDoubleCancels) {
  // Two nearly parallel vectors far from the origin: their cross product is (0, 0, 2^-50).
  const Vec3<double> base{1024, 1024, 1024};
  const auto u = DoubleDouble3::difference({1025, 1024, 1024}, base);
  const auto v = DoubleDouble3::difference({1025, 1024 + 0x1p-42, 1024}, base);
  const auto normal = static_cast<Vec3<double>>(cross(u, v));
  EXPECT_EQ(normal, (Vec3<double>{0, 0, 0x1p-42}));
  EXPECT_EQ(static_cast<double>(dot(u, v)), 1);
  EXPECT_EQ((u + v - u).y, DoubleDouble(0x1p-42));
}

}  // namespace
}  // namespace cutwater::test
