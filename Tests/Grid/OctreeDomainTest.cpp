#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeDomainTest : public ::testing::Test {};
TYPED_TEST_SUITE(OctreeDomainTest, Precisions);

TYPED_TEST(OctreeDomainTest, LevelsShareTheirCoordinatesToTheBit) {
  using T = TypeParam;
  const OctreeDomain<T> domain({T(-1.7), T(0.3), T(1e3)}, T(0.7), {3, 2, 5});
  for (int level = 0; level < 6; ++level) {
    const auto coarse = domain.level(level).cell({1, 1, 2});
    for (int corner = 0; corner < 8; ++corner) {
      const Index3 child{2 + (corner & 1), 2 + (corner >> 1 & 1), 4 + (corner >> 2)};
      const auto fine = domain.level(level + 1).cell(child);
      EXPECT_EQ(fine.corner(corner), coarse.corner(corner));
    }
  }
  EXPECT_EQ(domain.box().lower, domain.origin());
  EXPECT_EQ(domain.box().upper, domain.level(4).cell({47, 31, 79}).upper);
  EXPECT_EQ(domain.indices(4), IndexBox::ofSize(48, 32, 80));
}

TYPED_TEST(OctreeDomainTest, KnowsItsFinestLevel) {
  using T = TypeParam;
  EXPECT_EQ(OctreeDomain<T>({}, 1, {1, 1, 1}).deepest(), 21);
  EXPECT_EQ(OctreeDomain<T>({}, 1, {1, 2, 1}).deepest(), 20);
  EXPECT_EQ(OctreeDomain<T>({}, 1, {16, 3, 1}).deepest(), 17);
  EXPECT_EQ(OctreeDomain<T>({}, 1, {17, 3, 1}).deepest(), 16);
}

TYPED_TEST(OctreeDomainTest, RefusesWhatIsNoDomain) {
  using T = TypeParam;
  EXPECT_THROW(OctreeDomain<T>({}, 0, {1, 1, 1}), Error);
  EXPECT_THROW(OctreeDomain<T>({}, std::numeric_limits<T>::infinity(), {1, 1, 1}), Error);
  EXPECT_THROW(OctreeDomain<T>({std::numeric_limits<T>::quiet_NaN(), 0, 0}, 1, {1, 1, 1}), Error);
  EXPECT_THROW(OctreeDomain<T>({}, 1, {1, 0, 1}), Error);
  EXPECT_THROW(OctreeDomain<T>({}, 1, {1, 1, 1 << 21}), Error);
}

}  // namespace
}  // namespace cutwater::test
