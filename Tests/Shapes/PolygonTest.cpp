#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Polygon.hpp>

#include <cmath>
#include <string>

#include "Polygons.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PolygonTest : public ::testing::Test {};
TYPED_TEST_SUITE(PolygonTest, Precisions);

TYPED_TEST(PolygonTest, TurnsItsLoopsSoThatTheSolidIsToTheLeft) {
  using T = TypeParam;
  auto outline = rectangle<T>(0, 0, 10, 10);
  auto hole = rectangle<T>(1, 1, 9, 9);
  auto island = rectangle<T>(2, 2, 4, 4);
  auto pond = rectangle<T>(T(2.5), T(2.5), 3, 3);
  auto other = rectangle<T>(20, 5, 21, 6);
  // 100 - 64 + 4 - 1/4 + 1, whatever the order and the sense.
  const T area = T(40.75);
  EXPECT_EQ(Polygon<T>(outline, {hole, island, pond, other}).area(), area);
  std::ranges::reverse(outline);
  std::ranges::reverse(island);
  const Polygon<T> mixed(pond, {island, other, outline, hole});
  EXPECT_EQ(mixed.area(), area);
  const auto partOf = [&](std::size_t i) { return Polygon<T>(mixed.loops()[i]).area(); };
  EXPECT_EQ(partOf(0), T(0.25));
  ASSERT_EQ(mixed.loops().size(), 5U);
  // The first side of the outline runs up, and that of the hole does not.
  EXPECT_EQ(mixed.loops()[3][0], (Vec2<T>{0, 0}));
  EXPECT_EQ(mixed.loops()[3][1], (Vec2<T>{10, 0}));
  EXPECT_EQ(mixed.loops()[4][0], (Vec2<T>{1, 9}));
  EXPECT_EQ(mixed.loops()[4][1], (Vec2<T>{9, 9}));
}

TYPED_TEST(PolygonTest, DropsRepeatedCorners) {
  using T = TypeParam;
  const Polygon<T> polygon({{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}});
  EXPECT_EQ(polygon.loops()[0].size(), 3U);
  EXPECT_EQ(polygon.area(), T(0.5));
}

TYPED_TEST(PolygonTest, TakesCornersInStraightSidesAndSidesThatNearlyTouch) {
  using T = TypeParam;
  const T next = std::nextafter(T(1), T(2));
  EXPECT_EQ(Polygon<T>({{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}}).area(), T(4));
  EXPECT_EQ(Polygon<T>(rectangle<T>(0, 0, 1, 1), {rectangle<T>(next, 0, 2, 1)}).loops().size(), 2U);
  EXPECT_GT(Polygon<T>({{0, 0}, {1, 0}, {1, next - 1}}).area(), T(0));
}

TYPED_TEST(PolygonTest, RefusesWhatIsNoPolygon) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  const auto refuses = [](const Loop<T>& loop, const std::vector<Loop<T>>& others = {}) {
    EXPECT_THROW((Polygon<T>(loop, others)), Error);
  };
  refuses({});
  refuses({{0, 0}, {1, 1}});
  refuses({{0, 0}, {1, 1}, {0, 0}, {0, 0}});
  refuses({{0, 0}, {1, nan}, {1, 0}});
  refuses({{0, 0}, {1, 0}, {0, 1}, {std::numeric_limits<T>::infinity(), 2}});
  refuses({{0, 0}, {2, 0}, {0, 2}, {2, 2}});                           // crosses itself
  refuses({{0, 0}, {2, 0}, {1, 0}, {1, 2}});                           // folds back
  refuses({{0, 0}, {1, 0}, {2, 0}});                                   // no area
  refuses({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}});                   // a corner on a side
  refuses({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}});           // a corner on a corner
  refuses({{0, 0}, {3, 0}, {3, 1}, {2, 0}, {1, 0}, {0, 1}});           // sides on one line overlap
  refuses(rectangle<T>(0, 0, 2, 2), {rectangle<T>(1, 1, 3, 3)});       // loops cross
  refuses(rectangle<T>(0, 0, 2, 2), {rectangle<T>(0, 0, 2, 2)});       // loops coincide
  refuses(rectangle<T>(0, 0, 2, 2), {rectangle<T>(1, 1, 2, T(1.5))});  // loops share a part
  refuses(rectangle<T>(0, 0, 2, 2), {rectangle<T>(2, 2, 3, 3)});       // loops touch
}

TYPED_TEST(PolygonTest, TellsWhichEdgesAreWrong) {
  using T = TypeParam;
  try {
    const Polygon<T> polygon(rectangle<T>(0, 0, 4, 4), {{{1, 1}, {2, 1}, {2, 5}}});
    FAIL() << "not refused: " << polygon.area();
  } catch (const Error& error) {
    const std::string expected =
        "Polygon: edges cross or touch (loop = 0, edge = 2, other loop = 1, other edge = ";
    EXPECT_EQ(std::string(error.what()).substr(0, expected.size()), expected);
  }
}

}  // namespace
}  // namespace cutwater::test
