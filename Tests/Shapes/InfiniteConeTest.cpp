#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class InfiniteConeTest : public ::testing::Test {};
TYPED_TEST_SUITE(InfiniteConeTest, Precisions);

TYPED_TEST(InfiniteConeTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const InfiniteCone<T> cone({0, 0, 1}, {0, 0, 3}, 45);
  const T r = std::sqrt(T(0.5));
  EXPECT_NEAR(cone.signedDistance({0, 0, 3}), T(-2 * r), tolerance<T>(5));
  EXPECT_NEAR(cone.signedDistance({4, 0, 1}), T(4 * r), tolerance<T>(5));
  EXPECT_EQ(cone.signedDistance({0, 0, -4}), T(5));
  EXPECT_EQ(cone.signedDistance({3, 0, -3}), T(5));
  EXPECT_NEAR(cone.signedDistance({2, 0, 3}), T(0), tolerance<T>(4));
  EXPECT_EQ(cone.gradient({0, 0, 3}), Vec3<T>{});
  EXPECT_EQ(cone.gradient({0, 0, -3}), (Vec3<T>{0, 0, -1}));
}

TYPED_TEST(InfiniteConeTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((InfiniteCone<T>({0, 0, 0}, {0, 0, 1}, 0)), Error);
  EXPECT_THROW((InfiniteCone<T>({0, 0, 0}, {0, 0, 1}, 90)), Error);
  EXPECT_THROW((InfiniteCone<T>({0, 0, 0}, {0, 0, 0}, 30)), Error);
  EXPECT_THROW((InfiniteCone<T>({0, 0, 0}, {0, 0, 1}, nan)), Error);
  EXPECT_THROW((InfiniteCone<T>({inf, 0, 0}, {0, 0, 1}, 30)), Error);
}

TYPED_TEST(InfiniteConeTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(
      InfiniteCone<T>({0, 0, T(-0.5)}, {0, 0, 1}, 45), 2,
      {.inside = [](const Vec3<double>& p) { return std::hypot(p.x, p.y) < p.z + 0.5; }});
  expectGuarantee(InfiniteCone<T>({T(0.3), 0, T(-0.5)}, {-1, 2, 1}, 20), 2, {.covering = 4});
  expectGuarantee(InfiniteCone<T>({T(0.3), 0, T(-0.5)}, {1, 0, 0}, 80), 2);
}

TYPED_TEST(InfiniteConeTest, IsBoundedByItsApex) {
  using T = TypeParam;
  const auto box = InfiniteCone<T>({0, 0, 1}, {0, 0, 3}, 45).boundingBox();
  EXPECT_NEAR(box.lower.z, T(1), tolerance<T>(4));
  EXPECT_EQ(box.upper, (Vec3<T>{Box<T>::kInf, Box<T>::kInf, Box<T>::kInf}));
  EXPECT_EQ(box.lower.x, -Box<T>::kInf);
  const auto oblique = InfiniteCone<T>({0, 0, 1}, {1, 0, 1}, 50).boundingBox();
  EXPECT_EQ(oblique, Box<T>::everywhere());
  EXPECT_NEAR((InfiniteCone<T>({0, 0, 1}, {1, 0, 1}, 40).boundingBox().lower.x), 0,
              tolerance<T>(4));
}

TEST(InfiniteConeRounding, StaysWithinItsBound) {
  expectRounding(InfiniteCone<float>({0, 0, 1}, {0, 0, 3}, 45),
                 InfiniteCone<double>({0, 0, 1}, {0, 0, 3}, 45), 4);
  expectRounding(InfiniteCone<float>({5, 2, 1}, {1, 2, 3}, 0.001f),
                 InfiniteCone<double>({5, 2, 1}, {1, 2, 3}, 0.001f), 4);
  expectRounding(InfiniteCone<float>({5, 2, 1}, {1, 2, 3}, 89.99f),
                 InfiniteCone<double>({5, 2, 1}, {1, 2, 3}, 89.99f), 4);
}

}  // namespace
}  // namespace cutwater::test
