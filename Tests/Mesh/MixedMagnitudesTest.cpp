#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include "Support/Brick.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/MixedMagnitudes.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"
#include "Support/Scale.hpp"
#include "Support/TriangleOracle.hpp"

// Surfaces whose coordinates are of any magnitude, small ones beside large ones: what such numbers
// underflow in must not show.

namespace cutwater::test {
namespace {

/// By brute force, in quadruple precision.
template <typename T>
double distanceTo(const MeshSDF<T>& mesh, const Vec3<T>& p) {
  Float128 least = std::numeric_limits<double>::max();
  for (std::uint32_t id = 0; id < mesh.triangleCount(); ++id) {
    const auto t = mesh.triangle(id);
    least = std::min(least, triangleDistanceExactly(p, t[0], t[1], t[2]));
  }
  return static_cast<double>(least);
}

/// Places beside corners, in line with edges, and anywhere.
template <typename T>
std::vector<Vec3<T>> placesAround(const PolygonSoup& soup, MixedMagnitudes<T>& soups, int count) {
  const auto corner = [&] { return Vec3<T>(soup.points[soups.below(soup.points.size())]); };
  std::vector<Vec3<T>> places;
  for (int i = 0; i < count; ++i) {
    const auto a = corner();
    const Vec3<T> anywhere{soups.coordinate(), soups.coordinate(), soups.coordinate()};
    places.push_back(i % 3 == 0   ? anywhere
                     : i % 3 == 1 ? a + T(2) * soups.uniform() * (corner() - a)
                                  : T(2) * soups.uniform() * a);
  }
  return places;
}

template <typename T>
class MixedMagnitudesTest : public ::testing::Test {};
TYPED_TEST_SUITE(MixedMagnitudesTest, Precisions);

TYPED_TEST(MixedMagnitudesTest, DistancesAreThoseToTheNearestTriangle) {
  using T = TypeParam;
  MixedMagnitudes<T> soups(/*seed=*/1);
  double worst = 0;
  for (int n = 0; n < scaled(500); ++n) {
    SCOPED_TRACE(n);
    const auto soup = soups.next();
    const MeshSDF<T> mesh(soup, {.probes = 4});
    for (const auto& p : placesAround(soup, soups, 9)) {
      const double error = std::abs(double{std::abs(mesh.signedDistance(p))} - distanceTo(mesh, p));
      worst = std::max(worst, error / double{mesh.guarantee().error(length(p))});
    }
  }
  EXPECT_LE(worst, 1.0);
}

TYPED_TEST(MixedMagnitudesTest, BatchesHaveTheSameBits) {
  using T = TypeParam;
  MixedMagnitudes<T> soups(/*seed=*/2);
  for (int n = 0; n < scaled(500); ++n) {
    SCOPED_TRACE(n);
    const auto soup = soups.next();
    const MeshSDF<T> mesh(soup, {.probes = 4});
    const auto places = placesAround(soup, soups, 2);
    const auto points = brickBetween(places[0], places[1]);
    std::vector<T> together(points.size());
    mesh.signedDistances(points, together, {.threads = 1});
    for (std::size_t i = 0; i < points.size(); i += 5) {
      ASSERT_EQ(together[i], mesh.signedDistance(points[i])) << points[i];
    }
  }
}

TYPED_TEST(MixedMagnitudesTest, BoundsHoldTheValues) {
  using T = TypeParam;
  MixedMagnitudes<T> soups(/*seed=*/3);
  for (int n = 0; n < scaled(300); ++n) {
    SCOPED_TRACE(n);
    const auto soup = soups.next();
    const MeshSDF<T> mesh(soup, {.findSelfIntersections = true, .probes = 4});
    const auto places = placesAround(soup, soups, 12);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Box<T> box{min(places[i], places[i + 1]), max(places[i], places[i + 1])};
      const auto bounds = mesh.bounds(box);
      const auto kind = mesh.classify(box);
      for (const auto& p : {places[i], places[i + 1], box.center(), box.lower, box.upper}) {
        const T value = mesh.signedDistance(p);
        ASSERT_LE(bounds.lower, value) << p;
        ASSERT_GE(bounds.upper, value) << p;
        ASSERT_TRUE(kind != BoxClass::Inside || value < 0) << p;
        ASSERT_TRUE(kind != BoxClass::Outside || value >= 0) << p;
      }
    }
  }
}

TYPED_TEST(MixedMagnitudesTest, PointsOfNoFaceMayBeAnywhere) {
  using T = TypeParam;
  constexpr bool kIsFloat = sizeof(T) == sizeof(float);
  const double far = kIsFloat ? 1e37 : 1e150;
  const auto open = onlyFaces(cube(), [](std::size_t i) { return i != 5; });
  for (const double size : {1.0, kIsFloat ? 1e-15 : 1e-100}) {
    for (const auto& unit : {insideOut(cube()), open}) {
      auto soup = withPoints(unit, [&](const Vec3<double>& p) { return size * p; });
      const MeshSDFOptions options{.findSelfIntersections = true, .probes = 64};
      const MeshSDF<T> expected(soup, options);
      soup.points.emplace_back(far, -far, 0);
      const MeshSDF<T> mesh(soup, options);
      const std::vector<Vec3<T>> positions(soup.points.begin(), soup.points.end());
      const Vec3<T> within{T(0.5 * size), T(0.5 * size), T(0.125 * size)};
      RandomPoints<T> random(2);
      for (const auto& same : {mesh, mesh.refitted(positions), MeshSDF<T>::view(mesh.toBytes())}) {
        expectSameReport(same.signReport(), expected.signReport());
        EXPECT_EQ(same.guarantee(), expected.guarantee());
        EXPECT_EQ(same.boundingBox(), expected.boundingBox());
        EXPECT_EQ(same.signedDistance(within), -within.z);
        for (int i = 0; i < 100; ++i) {
          const auto p = static_cast<T>(size) * random.next();
          EXPECT_EQ(differingFields(same.closestPoint(p), expected.closestPoint(p)), "") << p;
        }
      }
      // Less, where the scale makes such numbers overflow.
      const bool fits = !kIsFloat || size == 1;
      EXPECT_EQ(mesh.soup().points.back() == Vec3<double>(positions.back()), fits);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
