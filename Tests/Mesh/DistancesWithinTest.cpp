#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <vector>

#include "Support/DamagedSoups.hpp"
#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DistancesWithinTest : public ::testing::Test {
 protected:
  /// Dense in places, so that many are within reach of the same triangles, and some far away.
  static std::vector<Vec3<T>> points() {
    std::vector<Vec3<T>> result;
    RandomPoints<T> random(3);
    for (int i = 0; i < 500; ++i) result.push_back(random.next());
    for (int i = 0; i < 1000; ++i) {
      const Vec3<T> place{T(i % 10), T(i / 10 % 10), T(i / 100)};
      result.push_back(Vec3<T>{T(0.8), T(0.1), T(-0.1)} + T(0.03) * place);
    }
    for (const T away : {T(50), T(1e7), T(1e30)}) result.push_back({away, -away, 0});
    return result;
  }

  static void expectTheValues(const SignedDistanceFunction<T>& solid) {
    const auto at = points();
    std::vector<T> all(at.size());
    solid.signedDistances(at, all);
    for (const T limit : {T(0), T(0.001), T(0.05), T(0.3), T(4), T(1e20)}) {
      std::vector<T> values(at.size());
      ASSERT_TRUE(solid.signedDistancesWithin(at, limit, values));
      std::size_t skipped = 0;
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (std::isnan(values[i])) {
          ++skipped;
          ASSERT_GT(std::abs(all[i]), limit) << i;
        } else {
          ASSERT_TRUE(sameBits(values[i], all[i]))
              << values[i] << " at " << i << ", not " << all[i];
        }
      }
      if (limit < T(0.1)) {
        EXPECT_GT(skipped, at.size() / 4) << "limit " << limit;
      }
    }
  }
  static bool hasAWay(const SignedDistanceFunction<T>& solid) {
    std::vector<T> values{T(7)};
    const bool result = solid.signedDistancesWithin(std::vector<Vec3<T>>{{1, 0, 0}}, T(1), values);
    if (!result) {
      EXPECT_EQ(values[0], T(7));
    }
    EXPECT_EQ(result, solid.signedDistancesWithin({}, T(1), {}));
    return result;
  }
};
TYPED_TEST_SUITE(DistancesWithinTest, Precisions);

TYPED_TEST(DistancesWithinTest, AreThoseOfAllWhereTheyAreNoFarther) {
  using T = TypeParam;
  this->expectTheValues(MeshSDF<T>(tessellation::icosphere(1, 1)));
  this->expectTheValues(MeshSDF<T>(tessellation::icosphere(1, 5)));
  const auto ball = tessellation::icosphere(0.8, 3);
  const MeshSDF<T> overlapping(together(ball, moved(ball, {0.4, 0.1, 0.05})));
  EXPECT_FALSE(overlapping.signReport().isSound());
  this->expectTheValues(overlapping);
  this->expectTheValues(MeshSDF<T>(bowl(24)));
  this->expectTheValues(DcelSDF<T>(DcelMesh<T>(tessellation::icosphere(1, 2))));
}

/// As many triangles as take every way to search them: for all points at once, for a few, for one.
TYPED_TEST(DistancesWithinTest, OfTinyTriangles) {
  using T = TypeParam;
  const auto speck = moved(tessellation::icosphere(0.02, 5), {0.95, 0.25, 0.05});
  this->expectTheValues(MeshSDF<T>(together(tessellation::icosphere(1, 2), speck)));
  const auto specks = together(moved(tessellation::icosphere(0.002, 6), {0.9, 0.2, 0}), speck);
  this->expectTheValues(MeshSDF<T>(specks));
}

TYPED_TEST(DistancesWithinTest, OfSolidsThatAreMoved) {
  using T = TypeParam;
  Solid<T> solid = MeshSDF<T>(tessellation::torus(0.8, 0.3, 60, 30));
  solid.rotate(T(35), {1, 2, 3});
  solid.translate({T(0.1), T(-0.2), T(0.3)});
  this->expectTheValues(solid);
}

TYPED_TEST(DistancesWithinTest, AreLeftToTheCallerWhereNothingIsFaster) {
  using T = TypeParam;
  const MeshSDF<T> closed(tessellation::icosphere(1, 1));
  EXPECT_TRUE(this->hasAWay(closed));
  EXPECT_FALSE(this->hasAWay(Torus<T>(1, T(0.25))));
  EXPECT_FALSE(this->hasAWay(Solid<T>(closed) | Torus<T>(1, T(0.25))));
}

TYPED_TEST(DistancesWithinTest, OfPointsThatAreNotFiniteAreNaN) {
  using T = TypeParam;
  const MeshSDF<T> ball(tessellation::icosphere(1, 2));
  const std::vector<Vec3<T>> at{{1, 0, 0}, {std::numeric_limits<T>::infinity(), 0, 0}, {0, 1, 0}};
  std::vector<T> values(3);
  ASSERT_TRUE(ball.signedDistancesWithin(at, T(1), values));
  EXPECT_TRUE(sameBits(values[0], ball.signedDistance(at[0])));
  EXPECT_TRUE(std::isnan(values[1]));
  EXPECT_TRUE(sameBits(values[2], ball.signedDistance(at[2])));
  EXPECT_THROW(static_cast<void>(ball.signedDistancesWithin(at, T(1), std::span(values).first(2))),
               Error);
}

}  // namespace
}  // namespace cutwater::test
