#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeCellsTest : public ::testing::Test {
 protected:
  using List = std::vector<OctreeCell>;
  static OctreeCells<T> cells(const List& list) { return {domain(), 2, list}; }
  static OctreeDomain<T> domain() { return {{1, 2, 3}, T(0.5), {2, 3, 1}}; }
};
TYPED_TEST_SUITE(OctreeCellsTest, Precisions);

TYPED_TEST(OctreeCellsTest, KnowWhereTheyAre) {
  using T = TypeParam;
  const auto cells = this->cells({{{0, 0, 0}, 0, BoxClass::Cut}, {{3, 1, 1}, 1, BoxClass::Cut}});
  EXPECT_EQ(cells.deepest(), 2);
  EXPECT_EQ(cells.count(BoxClass::Cut), 2U);
  EXPECT_EQ(cells.count(BoxClass::Inside), 0U);
  EXPECT_EQ(cells.center(cells.cells()[1]), (Vec3<T>{T(1.875), T(2.375), T(3.375)}));
  EXPECT_EQ(cells.box(cells.cells()[1]).lower, (Vec3<T>{T(1.75), T(2.25), T(3.25)}));
}

TYPED_TEST(OctreeCellsTest, AnyStretchOfAMeshWillDo) {
  using T = TypeParam;
  const auto mesh = ballAndPlateMesh<T>(3);
  for (const std::size_t first : {0U, 1U, 77U, 1001U}) {
    const auto some = mesh.cells().subspan(first, 500);
    const OctreeCells<T> stretch(mesh.domain(), mesh.deepest(), {some.begin(), some.end()});
    EXPECT_TRUE(std::ranges::equal(stretch.cells(), some));
  }
  EXPECT_TRUE(this->cells({}).cells().empty());
}

TYPED_TEST(OctreeCellsTest, RefusesWhatIsNoStretch) {
  using T = TypeParam;
  EXPECT_THROW(this->cells({{{2, 0, 0}, 0}}), Error);                  // outside
  EXPECT_THROW(this->cells({{{0, 0, -1}, 2}}), Error);                 // outside
  EXPECT_THROW(this->cells({{{0, 0, 0}, 3}}), Error);                  // too fine
  EXPECT_THROW(this->cells({{{1, 0, 0}, 0}, {{0, 0, 0}, 0}}), Error);  // out of order
  EXPECT_THROW(this->cells({{{0, 0, 0}, 0}, {{1, 1, 1}, 1}}), Error);  // one in the other
  EXPECT_THROW(this->cells({{{0, 0, 0}, 1}, {{0, 0, 0}, 1}}), Error);  // twice
  EXPECT_THROW(OctreeCells<T>(this->domain(), -1, {}), Error);
  EXPECT_THROW(OctreeCells<T>(this->domain(), 20, {}), Error);
}

}  // namespace
}  // namespace cutwater::test
