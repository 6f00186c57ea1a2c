#include <Cutwater/Core/Detail/SpatialOrder.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using detail::spatialOrder;

template <typename T>
class SpatialOrderTest : public ::testing::Test {
 protected:
  static std::vector<Vec3<T>> randomPoints(std::size_t count, const Vec3<T>& size) {
    std::vector<Vec3<T>> points;
    RandomPoints<T> random(1);
    for (std::size_t i = 0; i < count; ++i) {
      const auto p = random.next();
      points.push_back({size.x * p.x + 100, size.y * p.y, size.z * p.z - 7});
    }
    return points;
  }
  static double meanStep(const std::vector<Vec3<T>>& points) {
    double sum = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      sum += double{length(points[i] - points[i - 1])};
    return sum / static_cast<double>(points.size() - 1);
  }
  static std::vector<Vec3<T>> ordered(const std::vector<Vec3<T>>& points,
                                      const std::vector<std::uint32_t>& order) {
    std::vector<Vec3<T>> result;
    for (const auto i : order) result.push_back(points[i]);
    return result;
  }
  static void expectPermutation(std::vector<std::uint32_t> order, std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    std::ranges::sort(order);
    EXPECT_EQ(order, all);
  }
};
TYPED_TEST_SUITE(SpatialOrderTest, Precisions);

TYPED_TEST(SpatialOrderTest, BringsNeighboursTogether) {
  using T = TypeParam;
  for (const Vec3<T> size : {Vec3<T>{1, 1, 1}, Vec3<T>{10, T(0.5), 1}, Vec3<T>{1, 1, 0}}) {
    const auto points = this->randomPoints(40000, size);
    for (const int threads : {1, 3}) {
      const auto order = spatialOrder<T>(points, threads);
      this->expectPermutation(order, points.size());
      const auto sorted = this->ordered(points, order);
      EXPECT_LT(this->meanStep(sorted), 0.1 * this->meanStep(points));
      EXPECT_TRUE(spatialOrder<T>(sorted, threads).empty()) << "are together already";
    }
  }
}

TYPED_TEST(SpatialOrderTest, TakesBlocksOfAGridAsTheyAreAndNotItsRows) {
  using T = TypeParam;
  std::vector<Vec3<T>> blocks;
  std::vector<Vec3<T>> rows;
  for (int n = 0; n < 40 * 40 * 40; ++n) {
    const int cell = n / 64;
    blocks.push_back({T(4 * (cell % 10) + n % 4), T(4 * (cell / 10 % 10) + n / 4 % 4),
                      T(4 * (cell / 100) + n / 16 % 4)});
    rows.push_back({T(n % 40), T(n / 40 % 40), T(n / 1600)});
  }
  EXPECT_TRUE(spatialOrder<T>(blocks, 1).empty());
  EXPECT_FALSE(spatialOrder<T>(rows, 1).empty());
}

TYPED_TEST(SpatialOrderTest, OfPointsThatAreNotFiniteOrAllTheSame) {
  using T = TypeParam;
  constexpr T kInf = std::numeric_limits<T>::infinity();
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  auto points = this->randomPoints(5000, {1, 2, 3});
  for (std::size_t i = 0; i < points.size(); i += 7) points[i][static_cast<int>(i % 3)] = kNaN;
  for (std::size_t i = 3; i < points.size(); i += 11) points[i] = {kInf, -kInf, 0};
  this->expectPermutation(spatialOrder<T>(points, 2), points.size());

  EXPECT_TRUE(spatialOrder<T>({}, 1).empty());
  EXPECT_TRUE(spatialOrder<T>(std::vector<Vec3<T>>(1000, {1, 2, 3}), 1).empty());
  EXPECT_TRUE(spatialOrder<T>(std::vector<Vec3<T>>(1000, {kNaN, 0, 0}), 1).empty());
  constexpr T kMost = std::numeric_limits<T>::max();
  std::vector<Vec3<T>> far(1000, {kMost, 0, 0});
  far.front() = {-kMost, 0, 0};
  EXPECT_TRUE(spatialOrder<T>(far, 1).empty()) << "their distance overflows";
}

}  // namespace
}  // namespace cutwater::test
