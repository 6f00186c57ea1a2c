#include <Cutwater/Sdf/Detail/BoxDescent.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BoxDescentTest : public ::testing::Test {
 protected:
  static Interval<T> least(const SignedDistanceFunction<T>& solid, const OrientedBox<T>& box,
                           std::optional<T> concavity) {
    const auto value = [&](const Vec3<T>& p) { return solid.signedDistance(p); };
    const auto gradient = [&](const Vec3<T>& p) { return solid.gradient(p); };
    return detail::leastIn<T>({value, gradient, solid.guarantee()}, box, value(box.center),
                              concavity);
  }
};
TYPED_TEST_SUITE(BoxDescentTest, Precisions);

TYPED_TEST(BoxDescentTest, MeetsTheMinimumOfABall) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  // The nearest point is (2, 0, 0), in the middle of neither a face nor an edge.
  const auto box = OrientedBox<T>::of({{2, T(-0.3), T(-0.1)}, {3, T(0.1), T(0.4)}});
  const auto found = this->least(ball, box, T(0));
  const T error = 2000 * std::numeric_limits<T>::epsilon();
  EXPECT_LE(found.lower, T(1));
  EXPECT_GE(found.lower, T(1) - error);
  EXPECT_GE(found.upper, T(1) - error);
  EXPECT_LE(found.upper, T(1) + error);
}

TYPED_TEST(BoxDescentTest, ProvesNothingWithoutAConcavity) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const auto box = OrientedBox<T>::of({{2, T(-0.3), T(-0.1)}, {3, T(0.1), T(0.4)}});
  EXPECT_EQ(this->least(ball, box, {}).lower, -Box<T>::kInf);
  EXPECT_EQ(this->least(ball, box, T(10)).lower, -Box<T>::kInf) << "more than 1 over the radius";
  EXPECT_LT(this->least(ball, box, {}).upper, T(1.001));
}

// The value along the inner side of a ring falls on both sides of every point.
TYPED_TEST(BoxDescentTest, StaysBelowConcaveValues) {
  using T = TypeParam;
  const Torus<T> ring(1, T(0.25));
  RandomPoints<T> random(T(1), /*seed=*/11);
  int proven = 0;
  for (int i = 0; i < 300; ++i) {
    const T angle = 3 * random.next().x;
    const Vec3<T> center{T(0.6) * std::cos(angle), T(0.6) * std::sin(angle), T(0.1)};
    const auto half = T(0.15) * abs(random.next());
    const Box<T> box{center - half, center + half};
    const T toAxis = T(0.6) - length(half) - T(1e-3);
    const auto found = this->least(ring, OrientedBox<T>::of(box), 1 / toAxis);
    T lowest = Box<T>::kInf;
    for (int n = 0; n < 1000; ++n) {
      const auto share = [&](int k) { return T(k) / 9; };
      const auto size = box.size();
      lowest = std::min(lowest, ring.signedDistance(box.lower + Vec3<T>{share(n % 10) * size.x,
                                                                        share(n / 10 % 10) * size.y,
                                                                        share(n / 100) * size.z}));
    }
    EXPECT_LE(found.lower, lowest);
    proven += found.lower > lowest - T(0.1) * length(half) ? 1 : 0;
  }
  EXPECT_GT(proven, 200);
}

}  // namespace
}  // namespace cutwater::test
