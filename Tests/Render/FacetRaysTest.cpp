#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Detail/FacetRays.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <limits>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using detail::FacetRays;
using detail::Ray;

const Box<double> kAround{{-3, -3, -3}, {3, 3, 3}};

template <typename T>
class FacetRaysTest : public ::testing::Test {
 protected:
  static MeshSDF<T> box(const Vec3<double>& lower, const Vec3<double>& upper) {
    return MeshSDF<T>(triangulated(tessellation::box(lower, upper)));
  }
};
TYPED_TEST_SUITE(FacetRaysTest, Precisions);

TYPED_TEST(FacetRaysTest, MeetsTheFirstFacet) {
  const auto rays = FacetRays::of(this->box({-1, -1, -1}, {1, 1, 1}), kAround, 1);
  ASSERT_TRUE(rays.has_value());
  const Ray down{{0.25, 0.5, 3}, {0, 0, -1}};
  const auto hit = rays->first(down, 0, 10, 1e-6);
  ASSERT_TRUE(hit.has_value());
  EXPECT_DOUBLE_EQ(hit->along, 2);
  EXPECT_EQ(hit->normal, (Vec3<double>{0, 0, 1}));
  const auto behind = rays->first(down, 2.5, 10, 1e-6);
  ASSERT_TRUE(behind.has_value());
  EXPECT_DOUBLE_EQ(behind->along, 4);
  EXPECT_EQ(behind->normal, (Vec3<double>{0, 0, -1}));
  EXPECT_FALSE(rays->first(down, 0, 1.9, 1e-6).has_value());
  EXPECT_FALSE(rays->first(down, 3, 2, 1e-6).has_value());
  EXPECT_FALSE(rays->first({{1.1, 0, 3}, {0, 0, -1}}, 0, 10, 1e-6).has_value());
}

TYPED_TEST(FacetRaysTest, NothingSlipsThroughEdges) {
  const auto rays = FacetRays::of(this->box({-1, -1, -1}, {1, 1, 1}), kAround, 1);
  for (int i = -16; i <= 16; ++i) {
    const double t = i / 16.0;
    for (const double other : {t, -t, 1.0}) {  // along both diagonals of a side, and its rim
      const auto hit = rays->first({{t, other, 3}, {0, 0, -1}}, 0, 10, 1e-6);
      ASSERT_TRUE(hit.has_value()) << t << ' ' << other;
      ASSERT_DOUBLE_EQ(hit->along, 2);
    }
  }
}

TYPED_TEST(FacetRaysTest, FindsWhatARayPasses) {
  const auto rays = FacetRays::of(this->box({-1, -1, -1}, {1, 1, 1}), kAround, 1);
  const auto upTo = [](double reach) { return [reach](double) { return reach; }; };
  const Ray beside{{1.1, 0.5, 3}, {0, 0, -1}};
  const auto pass = rays->nearest(beside, 0, 10, upTo(0.11));
  ASSERT_TRUE(pass.has_value());
  EXPECT_DOUBLE_EQ(pass->point.x, 1);
  EXPECT_DOUBLE_EQ(pass->point.z, 3 - pass->along);
  EXPECT_FALSE(rays->nearest(beside, 0, 10, upTo(0.09)).has_value());
  EXPECT_FALSE(rays->nearest(beside, 0, 1.9, upTo(0.11)).has_value());
  EXPECT_FALSE(rays->nearest(beside, 3, 2, upTo(0.11)).has_value());

  const auto off = normalized(Vec3<double>{1, 1, 0});  // a corner's edge, seen askew
  const Ray askew{{1 + 0.01 * off.x, 1 + 0.01 * off.y, 0.25}, normalized(Vec3<double>{1, -1, 0.5})};
  const auto edge = rays->nearest(askew, -1, 1, upTo(0.02));
  ASSERT_TRUE(edge.has_value());
  EXPECT_NEAR(edge->along, 0, 1e-12);
  EXPECT_NEAR(length(edge->point - Vec3<double>{1, 1, 0.25}), 0, 1e-12);
}

TYPED_TEST(FacetRaysTest, PassesAsCloselyAsTheDistanceSays) {
  using T = TypeParam;
  const MeshSDF<T> ball(tessellation::icosphere(1, 3));
  const auto rays = FacetRays::of(ball, kAround, 1);
  RandomPoints<double> random(6);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const auto start = 3.0 * normalized(random.next());
    const Ray ray{start, normalized(random.next() - start)};
    if (rays->first(ray, 0, 6, 1e-6)) continue;
    double least = 10;
    for (int k = 0; k <= 3000; ++k) {
      least = std::min(least, double{ball.signedDistance(Vec3<T>(ray.at(k * 2e-3)))});
    }
    const auto pass = rays->nearest(ray, 0, 6, [](double) { return 0.5; });
    if (std::abs(least - 0.5) < 1e-3) continue;
    ASSERT_EQ(pass.has_value(), least < 0.5);
    if (!pass) continue;
    ++found;
    EXPECT_NEAR(length(pass->point - ray.at(pass->along)), least, 1e-4);
  }
  EXPECT_GT(found, 40);
}

TYPED_TEST(FacetRaysTest, MatchesTheCrossingsOfAMesh) {
  using T = TypeParam;
  const MeshSDF<T> ball(tessellation::icosphere(1, 3));
  const auto rays = FacetRays::of(ball, kAround, 1);
  RandomPoints<double> random(5);
  std::size_t found = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{3.0 * normalized(random.next()), {}};
    const Ray towards{ray.origin, normalized(random.next() - ray.origin)};
    const auto hit = rays->first(towards, 0, 10, 1e-6);
    std::optional<double> expected;
    ball.crossings({Vec3<T>(towards.origin), Vec3<T>(towards.at(10))}, [&](const auto& crossing) {
      expected = 10 * static_cast<double>(crossing.parameter);
      return false;
    });
    if (hit.has_value() != expected.has_value()) continue;  // within rounding of a silhouette
    ++found;
    EXPECT_NEAR(hit ? hit->along : 0, expected.value_or(0), tolerance<T>(100, 10));
  }
  EXPECT_GT(found, 1990U);
}

TYPED_TEST(FacetRaysTest, RaysFromAfarMeetTheSame) {
  const MeshSDF<TypeParam> ball(tessellation::icosphere(1, 3));
  const auto rays = FacetRays::of(ball, kAround, 1);
  ASSERT_TRUE(rays.has_value());
  RandomPoints<double> random(7);
  for (const double away : {3.0, 1e3, 1e5, 1e7}) {
    for (int i = 0; i < 500; ++i) {
      const auto towards = normalized(random.next());
      const Ray ray{0.5 * normalized(random.next()) - away * towards, towards};
      const auto near = rays->first(ray, away - 2, away + 2, 1e-6);
      const auto far = rays->first(ray, 0, std::numeric_limits<double>::infinity(), 1e-6);
      ASSERT_TRUE(near.has_value());
      ASSERT_TRUE(far.has_value()) << away;
      EXPECT_EQ(far->along, near->along);
    }
  }
}

TYPED_TEST(FacetRaysTest, OfFacetsOnEachOtherTheOneThatFacesTheViewerIsMet) {
  PolygonSoup soup;
  soup.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  soup.patchNames = {"down", "up", "up again"};
  soup.addPolygon(std::array{3U, 2U, 1U, 0U}, 0);
  soup.addPolygon(std::array{0U, 1U, 2U, 3U}, 2);
  soup.addPolygon(std::array{0U, 1U, 2U, 3U}, 1);
  const MeshSDF<TypeParam> sheets(soup);
  const auto rays = FacetRays::of(sheets, kAround, 1);
  ASSERT_TRUE(rays.has_value());
  const auto above = rays->first({{0.2, 0.3, 3}, {0, 0, -1}}, 0, 10, 1e-6);
  ASSERT_TRUE(above.has_value());
  EXPECT_EQ(above->patch, 1U);
  const auto below = rays->first({{0.2, 0.3, -3}, {0, 0, 1}}, 0, 10, 1e-6);
  ASSERT_TRUE(below.has_value());
  EXPECT_EQ(below->patch, 0U);
}

TYPED_TEST(FacetRaysTest, ThereAreNoneOfCurvedSurfaces) {
  using T = TypeParam;
  EXPECT_FALSE(FacetRays::of(Sphere<T>({}, 1), kAround, 1).has_value());
  const Solid<T> both = Solid<T>(Sphere<T>({}, 1)) | this->box({-1, -1, -1}, {1, 1, 1});
  EXPECT_FALSE(FacetRays::of(both, kAround, 1).has_value());
  const Box<double> elsewhere{{5, 5, 5}, {6, 6, 6}};
  EXPECT_FALSE(FacetRays::of(this->box({-1, -1, -1}, {1, 1, 1}), elsewhere, 1).has_value());
}

}  // namespace
}  // namespace cutwater::test
