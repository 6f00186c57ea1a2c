#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// Of very different sizes, some within others, some twice.
template <typename T>
std::vector<Ball<T>> scattered(int count, T size, unsigned seed = 1) {
  RandomPoints<T> random(1, seed);
  std::vector<Ball<T>> balls;
  for (int i = 0; i < count; ++i) {
    const auto center = random.next();
    balls.push_back({center, size * (T(0.01) + std::abs(random.next().x))});
    if (i % 10 == 9) balls.push_back(balls[static_cast<std::size_t>(i) / 2]);
  }
  return balls;
}

template <typename T>
class PackedBedTest : public ::testing::Test {};
TYPED_TEST_SUITE(PackedBedTest, Precisions);

TYPED_TEST(PackedBedTest, HasTheValuesOfThePlainLoopOverSpheres) {
  using T = TypeParam;
  for (const T shift : {T(0), T(5000)}) {
    auto balls = scattered<T>(2000, T(0.05));
    for (auto& ball : balls) ball.center += Vec3<T>{shift, -shift, 0};
    std::vector<Sphere<T>> spheres;
    for (const auto& [center, radius] : balls) spheres.emplace_back(center, radius);
    const PackedBed<T> bed(balls);
    EXPECT_EQ(bed.size(), balls.size());
    RandomPoints<T> random(T(1.3), 5);
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 700; ++i) {
      points.push_back((i % 50 == 0 ? T(1000) : T(1)) * random.next() + Vec3<T>{shift, -shift, 0});
    }
    points.push_back(balls[7].center);
    points.push_back(balls[7].center + Vec3<T>{balls[7].radius, 0, 0});
    std::vector<T> together(points.size());
    bed.signedDistances(points, together);
    for (std::size_t i = 0; i < points.size(); ++i) {
      T least = Box<T>::kInf;
      std::uint32_t first = 0;
      for (std::uint32_t n = 0; n < spheres.size(); ++n) {
        const T value = spheres[n].signedDistance(points[i]);
        if (value < least) first = n;
        least = std::min(least, value);
      }
      EXPECT_EQ(bed.signedDistance(points[i]), least);
      EXPECT_EQ(together[i], least);
      EXPECT_EQ(bed.owner(points[i]).face, first);
      EXPECT_EQ(bed.gradient(points[i]), spheres[first].gradient(points[i]));
    }
  }
}

TYPED_TEST(PackedBedTest, FindsTheLeastWhereRoundingDecides) {
  using T = TypeParam;
  // Balls that all touch the plane x = 0 from below in the origin: above it, all have the same
  // value but for rounding.
  RandomPoints<T> random(1, 8);
  std::vector<Ball<T>> balls;
  for (int i = 0; i < 400; ++i) {
    const T radius = T(0.01) + std::abs(random.next().x);
    balls.push_back({{-radius, 0, 0}, radius});
  }
  const PackedBed<T> bed(balls);
  for (int i = 0; i < 100; ++i) {
    const Vec3<T> p{std::numeric_limits<T>::epsilon() * std::pow(T(1.37), T(i - 3)), 0, 0};
    T least = Box<T>::kInf;
    for (const auto& [center, radius] : balls) {
      least = std::min(least, Sphere<T>(center, radius).signedDistance(p));
    }
    EXPECT_EQ(bed.signedDistance(p), least);
  }
}

TYPED_TEST(PackedBedTest, KeepsItsGuarantee) {
  using T = TypeParam;
  expectGuarantee(PackedBed<T>(scattered<T>(30, T(0.4))), /*extent=*/2,
                  {.probes = 2000, .covering = 4});
  const std::vector<Ball<T>> touching{{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}};
  expectGuarantee(PackedBed<T>(touching), /*extent=*/3, {.probes = 2000});
}

TYPED_TEST(PackedBedTest, TellsTheBallOfAClosestPoint) {
  using T = TypeParam;
  const std::vector<Ball<T>> balls{{{-2, 0, 0}, 1}, {{2, 0, 0}, T(0.5)}};
  const PackedBed<T> bed(balls);
  const auto left = bed.closestPoint({-4, 0, 0});
  EXPECT_EQ(left.point, (Vec3<T>{-3, 0, 0}));
  EXPECT_EQ(left.normal, (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(left.distance, 1);
  EXPECT_TRUE(left.exact);
  EXPECT_EQ(left.owner.face, 0U);
  EXPECT_EQ(bed.closestPoint({T(1.75), 0, 0}).owner.face, 1U);
  EXPECT_GE(bed.boundingBox().upper.x, T(2.5));
  EXPECT_NEAR(bed.boundingBox().upper.x, 2.5, 100 * std::numeric_limits<T>::epsilon());
}

TYPED_TEST(PackedBedTest, RefusesWhatIsNoBall) {
  using T = TypeParam;
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const auto refuses = [](const Ball<T>& ball) {
    const std::vector<Ball<T>> balls{{{0, 0, 0}, 1}, ball};
    EXPECT_THROW(PackedBed<T>{balls}, Error);
  };
  refuses({{0, 0, 0}, 0});
  refuses({{0, 0, 0}, -1});
  refuses({{0, 0, 0}, kInf});
  refuses({{0, 0, 0}, std::numeric_limits<T>::quiet_NaN()});
  refuses({{kInf, 0, 0}, 1});
  EXPECT_THROW(PackedBed<T>(std::vector<Ball<T>>{}), Error);
}

}  // namespace
}  // namespace cutwater::test
