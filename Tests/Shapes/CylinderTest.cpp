#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class CylinderTest : public ::testing::Test {};
TYPED_TEST_SUITE(CylinderTest, Precisions);

TYPED_TEST(CylinderTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const Cylinder<T> can({0, 0, 0}, {0, 0, 4}, 2);
  EXPECT_EQ(can.signedDistance({0, 0, 1}), T(-1));
  EXPECT_EQ(can.signedDistance({0, 1.5, 2}), T(-0.5));
  EXPECT_EQ(can.signedDistance({5, 0, 2}), T(3));
  EXPECT_EQ(can.signedDistance({0, 0, 6}), T(2));
  EXPECT_EQ(can.signedDistance({0, -5, -4}), T(5));
  EXPECT_EQ(can.signedDistance({5, 0, 8}), T(5));
  EXPECT_EQ(can.signedDistance({1, 1, 4}), T(0));
  EXPECT_EQ(can.gradient({1, 1, 5}), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(can.gradient({0, 0, 2}), Vec3<T>{});  // on the axis, no cap nearer than the side
  EXPECT_EQ(can.gradient({0, 0, 1}), (Vec3<T>{0, 0, -1}));
  const Cylinder<T> slanted({1, 1, 1}, {2, 3, 3}, 1);
  EXPECT_NEAR(slanted.signedDistance({3, 5, 5}), T(3), tolerance<T>(8));
}

TYPED_TEST(CylinderTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((Cylinder<T>({1, 2, 3}, {1, 2, 3}, 1)), Error);
  EXPECT_THROW((Cylinder<T>({0, 0, 0}, {0, 0, 1}, 0)), Error);
  EXPECT_THROW((Cylinder<T>({0, 0, 0}, {0, 0, 1}, nan)), Error);
  EXPECT_THROW((Cylinder<T>({0, 0, 0}, {0, 0, inf}, 1)), Error);
}

TYPED_TEST(CylinderTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(Cylinder<T>({0, 0, -1}, {0, 0, 1}, T(0.75)), 2,
                  {.inside = [](const Vec3<double>& p) {
                    return std::hypot(p.x, p.y) < 0.75 && std::abs(p.z) < 1;
                  }});
  expectGuarantee(Cylinder<T>({T(-0.6), T(0.1), T(-0.5)}, {T(0.5), T(0.7), T(0.9)}, T(0.5)), 2);
}

TYPED_TEST(CylinderTest, IsEnclosedTightly) {
  using T = TypeParam;
  const auto box = Cylinder<T>({0, 0, 0}, {3, 4, 0}, 5).boundingBox();
  EXPECT_NEAR(box.lower.x, T(-4), tolerance<T>(40));
  EXPECT_NEAR(box.upper.y, T(7), tolerance<T>(40));
  EXPECT_NEAR(box.upper.z, T(5), tolerance<T>(40));
  // An axis so near to z that its cosine rounds to 1 still leans.
  const T lean = std::sqrt(std::numeric_limits<T>::epsilon()) / 4;
  const auto leaning = Cylinder<T>({0, 0, 0}, {lean, 0, 1}, 1000).boundingBox();
  EXPECT_LT(leaning.lower.z, -999 * lean);
}

TEST(CylinderRounding, StaysWithinItsBound) {
  expectRounding(Cylinder<float>({0, 0, 0}, {0, 0, 4}, 2),
                 Cylinder<double>({0, 0, 0}, {0, 0, 4}, 2), 4);
  expectRounding(Cylinder<float>({10, 11, 12}, {12, 10, 11.5f}, 0.25f),
                 Cylinder<double>({10, 11, 12}, {12, 10, 11.5f}, 0.25f), 4);
  expectRounding(Cylinder<float>({-3, 1, 2}, {1, 0.5f, 0.1f}, 0.001f),
                 Cylinder<double>({-3, 1, 2}, {1, 0.5f, 0.1f}, 0.001f), 4);
}

}  // namespace
}  // namespace cutwater::test
