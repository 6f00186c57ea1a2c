#include <Cutwater/Bvh/PointCloud.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "Support/AllocationCount.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// All points, the nearest first.
template <typename T>
std::vector<Neighbor<T>> bruteForce(const std::vector<Vec3<T>>& points, const Vec3<T>& p) {
  std::vector<std::pair<T, std::uint32_t>> ranked;
  for (const auto& q : points) {
    ranked.push_back({lengthSquared(p - q), static_cast<std::uint32_t>(ranked.size())});
  }
  std::ranges::sort(ranked);
  std::vector<Neighbor<T>> result;
  for (const auto& [square, point] : ranked) result.push_back({point, std::sqrt(square)});
  return result;
}

template <typename T>
void expectSame(const Neighbor<T>& a, const Neighbor<T>& b) {
  EXPECT_EQ(a.primitive, b.primitive);
  EXPECT_EQ(a.distance, b.distance);
}

/// Clouds that searches stumble over: on a grid, where distances tie; all in one place; in a plane
/// and on a line; far from the origin; of sizes from 10^-12 to 10^6.
template <typename T>
std::vector<std::vector<Vec3<T>>> clouds() {
  RandomPoints<T> random(1, 2);
  std::vector<std::vector<Vec3<T>>> result(8);
  for (int i = 0; i < 1000; ++i) {
    const auto p = random.next();
    result[0].push_back(p);
    result[1].push_back(
        {std::round(4 * p.x) / 4, std::round(4 * p.y) / 4, std::round(4 * p.z) / 4});
    result[2].push_back({p.x, p.y, T(0.1)});
    result[3].push_back({T(0.3), T(0.3), p.z});
    result[4].push_back(p + Vec3<T>{1000, -3000, 500});
    result[5].push_back(std::pow(T(10), T(-12 + 18 * i / 1000.0)) * p);
  }
  result[6].assign(30, {T(0.5), 0, 0});
  result[7].push_back({T(0.25), T(0.5), 0});
  return result;
}

template <typename T>
class PointCloudTest : public ::testing::Test {
 protected:
  /// Points of the cloud, points near it, and points far away.
  static std::vector<Vec3<T>> queries(const std::vector<Vec3<T>>& points) {
    RandomPoints<T> random(T(1.2), 3);
    std::vector<Vec3<T>> result;
    for (std::size_t i = 0; i < 60; ++i) {
      const auto shift = random.next();
      const T sizes[] = {0, T(1e-3), T(0.1), 1, 100};
      result.push_back(points[i * 7 % points.size()] + sizes[i % 5] * shift);
    }
    return result;
  }
};
TYPED_TEST_SUITE(PointCloudTest, Precisions);

TYPED_TEST(PointCloudTest, FindsWhatTryingAllFinds) {
  using T = TypeParam;
  for (const auto& points : clouds<T>()) {
    const PointCloud<T> cloud(points);
    EXPECT_EQ(cloud.size(), points.size());
    for (const auto& p : this->queries(points)) {
      const auto all = bruteForce(points, p);
      expectSame(cloud.nearest(p), all[0]);
      for (const std::size_t count : {1U, 8U, 50U, 2000U}) {
        std::vector<Neighbor<T>> found(count);
        ASSERT_EQ(cloud.nearest(p, found), std::min(count, all.size()));
        for (std::size_t i = 0; i < std::min(count, all.size()); ++i) expectSame(found[i], all[i]);
      }
      // As far as the tenth, and not quite.
      const T radius = all[std::min<std::size_t>(9, all.size() - 1)].distance;
      for (const T reach : {radius, std::nextafter(radius, T(-1))}) {
        const auto last = std::ranges::find_if(all, [=](auto& n) { return n.distance > reach; });
        const auto count = static_cast<std::size_t>(last - all.begin());
        std::vector<std::uint32_t> found;
        cloud.within(p, reach, [&](const Neighbor<T>& neighbor) {
          found.push_back(neighbor.primitive);
          return true;
        });
        EXPECT_EQ(found.size(), count);
        std::vector<Neighbor<T>> some(all.size());
        EXPECT_EQ(cloud.nearest(p, some, reach), count);
        EXPECT_EQ(cloud.nearest(p, reach).primitive, count > 0 ? all[0].primitive : kNone);
      }
    }
  }
}

TYPED_TEST(PointCloudTest, AnswersManyAsOneByOne) {
  using T = TypeParam;
  for (const auto& points : clouds<T>()) {
    const PointCloud<T> cloud(points);
    std::vector<Vec3<T>> queries;
    for (int round = 0; round < 20; ++round) {
      for (const auto& p : this->queries(points)) queries.push_back(p);
    }
    // Neighbours in a row, too.
    for (int i = 0; i < 300; ++i) queries.push_back({T(i) / 300, T(0.1), T(0.1)});
    queries[500] = {std::numeric_limits<T>::quiet_NaN(), 0, 0};
    queries[501] = {std::numeric_limits<T>::max(), 0, 0};
    for (const int threads : {1, 2}) {
      for (const std::size_t count : {1U, 5U}) {
        std::vector<Neighbor<T>> found(queries.size() * count);
        cloud.nearest(queries, count, found, {.threads = threads});
        for (std::size_t n = 0; n < queries.size(); ++n) {
          std::vector<Neighbor<T>> row(count);
          static_cast<void>(cloud.nearest(queries[n], row));
          for (std::size_t i = 0; i < count; ++i) expectSame(found[n * count + i], row[i]);
        }
      }
      const auto rows = cloud.within(queries, T(0.2), {.threads = threads});
      ASSERT_EQ(rows.offsets.size(), queries.size() + 1);
      for (std::size_t n = 0; n < queries.size(); ++n) {
        std::vector<Neighbor<T>> row(points.size());
        row.resize(cloud.nearest(queries[n], row, T(0.2)));
        ASSERT_EQ(rows.of(n).size(), row.size());
        for (std::size_t i = 0; i < row.size(); ++i) expectSame(rows.of(n)[i], row[i]);
      }
    }
  }
}

TYPED_TEST(PointCloudTest, StopsWhenToldTo) {
  using T = TypeParam;
  const PointCloud<T> cloud(clouds<T>()[0]);
  int visited = 0;
  cloud.within({0, 0, 0}, 10, [&](const Neighbor<T>&) { return ++visited < 17; });
  EXPECT_EQ(visited, 17);
}

TYPED_TEST(PointCloudTest, AllocatesNothingForOnePoint) {
  using T = TypeParam;
  const PointCloud<T> cloud(clouds<T>()[0]);
  std::vector<Neighbor<T>> found(20);
  std::size_t count = 0;
  const AllocationCount allocations;
  static_cast<void>(cloud.nearest({T(0.1), 0, 0}));
  count += cloud.nearest({T(0.1), 0, 0}, found);
  cloud.within({T(0.1), 0, 0}, T(0.5), [&](const Neighbor<T>&) { return ++count > 0; });
  EXPECT_EQ(allocations.count(), 0);
  EXPECT_GT(count, 20U);
}

TYPED_TEST(PointCloudTest, FindsNothingWhereThereIsNothing) {
  using T = TypeParam;
  const PointCloud<T> none(std::vector<Vec3<T>>{});
  EXPECT_EQ(none.nearest({0, 0, 0}).primitive, kNone);
  const PointCloud<T> cloud(clouds<T>()[0]);
  std::vector<Neighbor<T>> found(4);
  constexpr T kInf = std::numeric_limits<T>::infinity();
  for (const T bad : {std::numeric_limits<T>::quiet_NaN(), kInf, -kInf}) {
    EXPECT_EQ(cloud.nearest({bad, 0, 0}).primitive, kNone);
    EXPECT_EQ(cloud.nearest({0, bad, 0}, found), 0U);
  }
  EXPECT_EQ(cloud.nearest({0, 0, 0}, found, T(-1)), 0U);
  EXPECT_EQ(cloud.nearest({0, 0, 0}, std::numeric_limits<T>::quiet_NaN()).primitive, kNone);
  EXPECT_NE(cloud.nearest({0, 0, 0}, kInf).primitive, kNone);
  EXPECT_EQ(cloud.nearest({0, 0, 0}, std::span<Neighbor<T>>{}), 0U);
}

TYPED_TEST(PointCloudTest, RefusesWhatHasNoPlace) {
  using T = TypeParam;
  const auto refuses = [](const Vec3<T>& p) {
    EXPECT_THROW(PointCloud<T>(std::vector<Vec3<T>>{{0, 0, 0}, p}), Error);
  };
  refuses({std::numeric_limits<T>::quiet_NaN(), 0, 0});
  refuses({0, std::numeric_limits<T>::infinity(), 0});
  refuses({0, 0, std::numeric_limits<T>::max()});
  const PointCloud<T> cloud(clouds<T>()[0]);
  std::vector<Neighbor<T>> found(5);
  const std::vector<Vec3<T>> two(2);
  EXPECT_THROW(cloud.nearest(two, found), Error);
  EXPECT_THROW(cloud.nearest(two, 2, found), Error);
  EXPECT_THROW(cloud.nearest(two, 0, found), Error);
}

}  // namespace
}  // namespace cutwater::test
