#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/RigidTransform.hpp>

#include <array>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RigidTransformTest : public ::testing::Test {};
TYPED_TEST_SUITE(RigidTransformTest, Precisions);

template <typename T>
void expectNear(const Vec3<T>& a, const Vec3<T>& b, T size) {
  EXPECT_LE(length(a - b), tolerance<T>(size)) << a << " is not " << b;
}

TYPED_TEST(RigidTransformTest, QuarterTurnsAreRightHandedAndExact) {
  using T = TypeParam;
  const Vec3<T> p{2, 3, 5};
  // Right-hand rule: about x, y turns to z; about y, z to x; about z, x to y.
  const std::array<Vec3<T>, 3> quarter{Vec3<T>{2, -5, 3}, {5, 3, -2}, {-3, 2, 5}};
  const std::array<Vec3<T>, 3> half{Vec3<T>{2, -3, -5}, {-2, 3, -5}, {-2, -3, 5}};
  const std::array<Vec3<T>, 3> back{Vec3<T>{2, 5, -3}, {-5, 3, 2}, {3, -2, 5}};
  for (int axis = 0; axis < 3; ++axis) {
    const auto turned = [&](T degrees) {
      RigidTransform<T> t;
      t.rotate(degrees, axis);
      return t.toWorld(p);
    };
    const auto i = static_cast<std::size_t>(axis);
    for (const T turns : {T(0), T(360), T(-720), T(3600)}) {
      EXPECT_EQ(turned(turns), p);
      EXPECT_EQ(turned(turns + 90), quarter[i]);
      EXPECT_EQ(turned(turns + 180), half[i]);
      EXPECT_EQ(turned(turns - 90), back[i]);
      EXPECT_EQ(turned(turns + 270), back[i]);
    }
  }
}

TYPED_TEST(RigidTransformTest, MotionsActInCallOrderAboutEveryAxis) {
  using T = TypeParam;
  const std::array<Vec3<T>, 3> movedThenTurned{Vec3<T>{1, -3, 2}, {3, 2, -1}, {-2, 1, 3}};
  for (int axis = 0; axis < 3; ++axis) {
    RigidTransform<T> first;
    first.translate({1, 2, 3});
    first.rotate(90, axis);
    EXPECT_EQ(first.toWorld(Vec3<T>{}), movedThenTurned[static_cast<std::size_t>(axis)]);
    EXPECT_EQ(first.toLocal(movedThenTurned[static_cast<std::size_t>(axis)]), Vec3<T>{});
    RigidTransform<T> second;
    second.rotate(90, axis);
    second.translate({1, 2, 3});
    EXPECT_EQ(second.toWorld(Vec3<T>{}), (Vec3<T>{1, 2, 3}));
    EXPECT_NE(first, second);
  }
}

TYPED_TEST(RigidTransformTest, TurnsAboutAnyAxisThroughAnyPoint) {
  using T = TypeParam;
  RigidTransform<T> t;
  t.rotate(120, Vec3<T>{5, 5, 5});  // x -> y -> z -> x
  expectNear(t.toWorld(Vec3<T>{1, 2, 3}), Vec3<T>{3, 1, 2}, T(4));
  expectNear(t.directionToLocal({0, 1, 0}), Vec3<T>{1, 0, 0}, T(1));
  RigidTransform<T> about;
  about.rotate(180, Vec3<T>{0, 0, 1}, Vec3<T>{1, 1, 0});
  expectNear(about.toWorld(Vec3<T>{3, 0, 7}), Vec3<T>{-1, 2, 7}, T(8));
  expectNear(about.toWorld(Vec3<T>{1, 1, 4}), Vec3<T>{1, 1, 4}, T(4));
  RigidTransform<T> slight;
  slight.rotate(30, 2);
  expectNear(slight.toWorld(Vec3<T>{2, 0, 0}), Vec3<T>{std::sqrt(T(3)), 1, 0}, T(2));
}

TYPED_TEST(RigidTransformTest, AxesMayHaveAnyLength) {
  using T = TypeParam;
  RigidTransform<T> wanted;
  wanted.rotate(90, 2);
  for (const T length : {std::numeric_limits<T>::denorm_min(), std::numeric_limits<T>::min(),
                         T(3e-30), T(1e30), std::numeric_limits<T>::max()}) {
    RigidTransform<T> t;
    t.rotate(90, Vec3<T>{0, 0, length});
    EXPECT_EQ(t, wanted) << length;
  }
}

TYPED_TEST(RigidTransformTest, StaysOrthogonalThroughManySmallTurns) {
  using T = TypeParam;
  RigidTransform<T> t;
  for (int i = 0; i < 100000; ++i) t.rotate(T(0.37), Vec3<T>{1, T(i % 7), -2});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(dot(t.axis(i), t.axis(j)), i == j ? 1 : 0, tolerance<T>(1, 4));
    }
  }
}

TYPED_TEST(RigidTransformTest, ComposesFirstThenSecond) {
  using T = TypeParam;
  RigidTransform<T> first;
  first.translate({1, 0, 0});
  first.rotate(40, Vec3<T>{1, 2, 3});
  RigidTransform<T> second;
  second.rotate(-70, 1);
  second.translate({0, 5, 0});
  const auto both = RigidTransform<T>::composed(first, second);
  RandomPoints<T> points(3);
  for (int i = 0; i < 100; ++i) {
    const auto p = points.next();
    expectNear(both.toWorld(p), second.toWorld(first.toWorld(p)), T(10));
    expectNear(both.toLocal(both.toWorld(p)), p, T(10));
  }
  EXPECT_EQ(RigidTransform<T>::composed(first, {}), first);
  EXPECT_TRUE(RigidTransform<T>::composed({}, {}).isIdentity());
}

TYPED_TEST(RigidTransformTest, MovesBoxesAroundTheirContents) {
  using T = TypeParam;
  const Box<T> box{{-1, -2, -3}, {4, 5, 6}};
  RigidTransform<T> t;
  t.rotate(33, Vec3<T>{1, -1, 2});
  t.translate({7, 8, 9});
  const auto world = t.toWorld(box);
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(world.contains(t.toWorld(box.corner(i))));
  EXPECT_LT(world.diagonal(), T(3) * box.diagonal());
  EXPECT_TRUE(t.toWorld(Box<T>{}).empty());
  EXPECT_EQ(t.toWorld(Box<T>::everywhere()), Box<T>::everywhere());

  // A half-infinite box is still grown for the rounding of its finite side.
  Box<T> half = Box<T>::everywhere();
  half.upper.x = T(0.1);
  RigidTransform<T> shift;
  shift.translate({T(0.3), 0, 0});
  EXPECT_GT(shift.toWorld(half).upper.x, T(0.1) + T(0.3));
  EXPECT_EQ(shift.toWorld(half).lower.x, -Box<T>::kInf);
}

TYPED_TEST(RigidTransformTest, RefusesImpossibleMotions) {
  using T = TypeParam;
  const T inf = std::numeric_limits<T>::infinity();
  RigidTransform<T> t;
  EXPECT_THROW(t.translate({0, inf, 0}), Error);
  EXPECT_THROW(t.rotate(90, 3), Error);
  EXPECT_THROW(t.rotate(90, -1), Error);
  EXPECT_THROW(t.rotate(inf, 0), Error);
  EXPECT_THROW(t.rotate(90, Vec3<T>{}), Error);
  EXPECT_THROW(t.rotate(90, Vec3<T>{0, 0, 1}, Vec3<T>{inf, 0, 0}), Error);
  EXPECT_TRUE(t.isIdentity());
}

TYPED_TEST(RigidTransformTest, RefusesMotionsThatAddUpToInfinity) {
  using T = TypeParam;
  const T most = std::numeric_limits<T>::max();
  RigidTransform<T> t;
  t.translate({most, most, 0});
  const auto before = t;
  EXPECT_THROW(t.translate({most, 0, 0}), Error);
  EXPECT_THROW(t.rotate(45, 2), Error);
  EXPECT_THROW(t.rotate(90, Vec3<T>{0, 0, 1}, Vec3<T>{-most, 0, 0}), Error);
  EXPECT_THROW(static_cast<void>(RigidTransform<T>::composed(t, t)), Error);
  EXPECT_EQ(t, before);
  t.rotate(180, 0);
  t.translate({-most, most, 0});
  EXPECT_EQ(t.offset(), Vec3<T>{});
}

TYPED_TEST(RigidTransformTest, ComesBackFromItsAxesAndOffset) {
  using T = TypeParam;
  RigidTransform<T> t;
  for (int i = 0; i < 1000; ++i) {
    const RigidTransform<T> again({t.axis(0), t.axis(1), t.axis(2)}, t.offset());
    EXPECT_EQ(again, t);
    EXPECT_EQ(again.isRotated(), t.isRotated());
    t.rotate(T(0.37) * static_cast<T>(i), {T(1), T(i % 3), T(-2)}, {1, 0, T(0.5)});
    t.translate({T(0.1), T(-0.2), 7});
  }
}

TYPED_TEST(RigidTransformTest, RefusesAxesThatAreNoRotation) {
  using T = TypeParam;
  const Vec3<T> x{1, 0, 0};
  const Vec3<T> y{0, 1, 0};
  const Vec3<T> z{0, 0, 1};
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  EXPECT_NO_THROW(RigidTransform<T>({y, z, x}, {1, 2, 3}));
  EXPECT_THROW(RigidTransform<T>({y, x, z}, {}), Error);  // left-handed
  EXPECT_THROW(RigidTransform<T>({x, y, -z}, {}), Error);
  EXPECT_THROW(RigidTransform<T>({x, y, y}, {}), Error);
  EXPECT_THROW(RigidTransform<T>({x, y, T(1.001) * z}, {}), Error);
  EXPECT_THROW(RigidTransform<T>({x, y, {0, T(0.001), 1}}, {}), Error);
  EXPECT_THROW(RigidTransform<T>({x, y, {0, 0, kNaN}}, {}), Error);
  EXPECT_THROW(RigidTransform<T>({x, y, z}, {0, kNaN, 0}), Error);
}

}  // namespace
}  // namespace cutwater::test
