#include <Cutwater/Tpms/Detail/PatternExpansion.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {
namespace {

using detail::PatternExpansion;
using detail::SymmetricMatrix;

Vec3<double> times(const SymmetricMatrix& a, const Vec3<double>& v) {
  return v.x * a[0] + v.y * a[1] + v.z * a[2];
}

PatternExpansion expansionAt(const TpmsPattern& pattern, const Vec3<double>& place) {
  PatternExpansion result{};
  detail::expandPattern(pattern, {&place, 1}, {&result, 1});
  return result;
}

TEST(PatternExpansionTest, MissesNoMoreThanThirdDerivativesAdd) {
  const auto all = TpmsPattern::all();
  const auto plain = plainPatterns();
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    const double third = all[i].thirdDerivative() / 6;
    const double second = PatternExpansion::secondError(all[i]) / 2;
    RandomPoints<double> random(4, 11);
    double most = 0;
    for (int k = 0; k < scaled(2000); ++k) {
      const auto q = random.next();
      const auto f = expansionAt(all[i], q);
      for (const double reach : {1e-4, 0.05, 0.4}) {
        const auto v = reach / 4 * random.next();
        const double expanded = f.value + dot(f.gradient, v) + 0.5 * dot(v, times(f.second, v));
        const auto y = q + v;
        const double missed = std::abs(plain[i].value(y.x, y.y, y.z) - expanded);
        const double squared = lengthSquared(v);
        const double ofThird = third * squared * length(v);
        ASSERT_LE(missed, ofThird + second * squared + 1e-13) << q << ' ' << v;
        if (reach > 0.01) most = std::max(most, missed / ofThird);
      }
    }
    EXPECT_GT(most, 0.6);
  }
}

TEST(PatternExpansionTest, IsTheSameForOneAndForMany) {
  const auto pattern = TpmsPattern::splitP();
  RandomPoints<double> random(7, 2);
  std::array<Vec3<double>, PatternExpansion::kMostAtOnce> places;
  for (auto& place : places) place = random.next();
  std::array<PatternExpansion, PatternExpansion::kMostAtOnce> found;
  detail::expandPattern(pattern, places, found);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto alone = expansionAt(pattern, places[i]);
    EXPECT_EQ(found[i].value, alone.value);
    EXPECT_EQ(found[i].gradient, alone.gradient);
    EXPECT_EQ(found[i].second, alone.second);
  }
}

/// The symmetric matrix with these eigenvalues, along three directions at right angles.
SymmetricMatrix matrixOf(const Vec3<double>& eigenvalues, RandomPoints<double>& random) {
  const auto a = normalized(random.next());
  const auto b = normalized(cross(a, random.next()));
  const std::array<Vec3<double>, 3> along{a, b, cross(a, b)};
  SymmetricMatrix result{};
  for (int i = 0; i < 3; ++i) {
    const auto& e = along[static_cast<std::size_t>(i)];
    for (int k = 0; k < 3; ++k) {
      result[static_cast<std::size_t>(k)] += eigenvalues[i] * e[k] * e;
    }
  }
  return result;
}

TEST(PatternExpansionTest, EigenvaluesAreThoseTheMatrixIsMadeOf) {
  RandomPoints<double> random(3, 4);
  for (int k = 0; k < 2000; ++k) {
    auto values = random.next();
    if (k % 5 == 0) values.y = values.x;
    const auto a = matrixOf(values, random);
    const double least = -maxComponent(-values);
    EXPECT_NEAR(detail::leastEigenvalue(a), least, 1e-7);
    EXPECT_TRUE(detail::isPositiveDefinite(1, a, -least + 1e-3)) << values;
    EXPECT_FALSE(detail::isPositiveDefinite(1, a, -least - 1e-9)) << values;
    const double most = maxComponent(values);
    EXPECT_TRUE(detail::isPositiveDefinite(-1, a, most + 1e-3)) << values;
    EXPECT_FALSE(detail::isPositiveDefinite(-1, a, most - 1e-9)) << values;
    EXPECT_NEAR(detail::determinant(a), values.x * values.y * values.z, 1e-12);
  }
}

}  // namespace
}  // namespace cutwater::test
