#include <Cutwater/Tpms/TpmsMap.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

TEST(DeformationFieldTest, ShiftsAreThoseOfTheNodesAndChangeNoFasterThanTheySay) {
  const DeformationField<double> field{.amplitude = 0.5, .spacing = {1, 2, 0.5}, .seed = 3};
  const auto other = DeformationField<double>{.amplitude = 0.5, .spacing = {1, 2, 0.5}, .seed = 4};
  RandomPoints<double> random(20);
  double steepest = 0;
  Vec3<double> most{-1, -1, -1};
  for (int i = 0; i < scaled(20000); ++i) {
    const auto p = random.next();
    const auto v = field.shiftAt(p);
    most = max(most, abs(v));
    EXPECT_LE(maxComponent(abs(v)), 0.5);
    const auto q = p + 0.01 * random.next();
    steepest = std::max(steepest, length(field.shiftAt(q) - v) / length(q - p));
    EXPECT_NE(v, other.shiftAt(p));
  }
  EXPECT_LE(steepest, field.lipschitz());
  EXPECT_GT(steepest, 0.2 * field.lipschitz());
  EXPECT_GT(maxComponent(most), 0.45);
  // Half-way between nodes it is half of both, and the same from wherever it is asked.
  const auto at = [&](double x) { return field.shiftAt({x, 4, 1}); };
  EXPECT_NEAR(length(at(3.5) - 0.5 * (at(3) + at(4))), 0, 1e-15);
  EXPECT_NEAR(length(at(-0.5) - 0.5 * (at(-1) + at(0))), 0, 1e-15);
  EXPECT_EQ(DeformationField<float>({.amplitude = 0.5F, .spacing = {1, 2, 0.5F}, .seed = 3})
                .shiftAt({3, 4, 1}),
            Vec3<float>(at(3)));
}

TEST(DeformationFieldTest, ChangesAsFastAtTheSmallestAndLargestSizes) {
  const auto changeAt = [](auto size) {
    return DeformationField<decltype(size)>{.amplitude = size, .spacing = {size, size, size}}
        .lipschitz();
  };
  EXPECT_NEAR(changeAt(1.0), 6, 1e-13);
  for (const double size : {0x1p-1000, 0x1p-600, 0x1p600}) EXPECT_EQ(changeAt(size), changeAt(1.0));
  for (const float size : {0x1p-100F, 0x1p100F}) EXPECT_EQ(changeAt(size), changeAt(1.0F));
  // Does not change at all.
  EXPECT_EQ(DeformationField<double>({.amplitude = 0, .spacing = {1e-200, 1, 1}}).lipschitz(), 0);
  EXPECT_EQ(DeformationField<float>({.amplitude = 0, .spacing = {1e-30F, 1, 1}}).lipschitz(), 0);
}

}  // namespace
}  // namespace cutwater::test
