#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "WindingCases.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class SolidAngleTest : public ::testing::Test {};
TYPED_TEST_SUITE(SolidAngleTest, Precisions);

TYPED_TEST(SolidAngleTest, AnOctantIsAnEighth) {
  using T = TypeParam;
  // Seen from the origin, x + y + z = 1 fills an octant of the sphere.
  const Winding<T> front({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}});
  EXPECT_NEAR(front->exactSum({0, 0, 0}), 0.125, 1e-16);
  const Winding<T> back({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}});
  EXPECT_NEAR(back->exactSum({0, 0, 0}), -0.125, 1e-16);
  // One side of a cube, seen from its middle, is a sixth; half of it a twelfth.
  const Winding<T> square({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}}, {{0, 1, 2}});
  EXPECT_NEAR(square->exactSum({0, 0, 0}), 1.0 / 12, 1e-16);
}

TYPED_TEST(SolidAngleTest, AHugeTriangleIsHalfSpace) {
  using T = TypeParam;
  const Winding<T> plane({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}});
  // Up is the front: the side that is outside. At height h what is missing is of order h.
  EXPECT_NEAR(plane->exactSum({0, 0, -1e-9}), 0.5, 1e-8);
  EXPECT_NEAR(plane->exactSum({0, 0, 1e-9}), -0.5, 1e-8);
  EXPECT_NEAR(plane->exactSum({0, 0, 0}), -0.5, 1e-15);  // moved by (e, e^2, e^3): before it
  EXPECT_EQ(plane->exactSum({3, 1, 0}), 0);
}

TYPED_TEST(SolidAngleTest, AHemisphereOnItsAxis) {
  using T = TypeParam;
  // Whatever its shape, a sheet with a circle of radius 1 for a rim spans the solid angle of the
  // disk, or the rest of the sphere: from the height z over the disk, 2 pi (1 - z / sqrt(1 + z^2)).
  const int n = 512;
  std::vector<Vec3<double>> points{{0, 0, -1}};
  Polygons polygons;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    polygons.push_back({0, (i + 1) % n + 1, i + 1});
  }
  const Winding<T> cup(makeSoup(points, polygons));
  for (const double z : {-0.5, -0.1, 0.0, 0.1, 1.0, 10.0}) {
    const double expected = 0.5 * (1 - z / std::hypot(1, z));
    EXPECT_NEAR(cup->exactSum({0, 0, z}), expected, 2e-5) << z;  // the rim has corners
    EXPECT_EQ(cup->isInside({0, 0, z}), z < 0) << z;
  }
}

TYPED_TEST(SolidAngleTest, JumpsByOneAtATriangle) {
  using T = TypeParam;
  // Scaled by powers of two, and far from the origin for their size.
  for (const auto& scene : {std::pair{1.0, 0.0}, std::pair{0x1p-20, 0.0}, std::pair{0x1p-10, 1.0},
                            std::pair{0x1p-20, 1.0}}) {
    const double size = scene.first;
    if (size < 0x1p-12 && scene.second > 0 && std::same_as<T, float>)
      continue;  // a cloud of points
    const double offset = scene.second;
    const auto sphere = withPoints(tessellation::icosphere(0.9, 3), [&](const auto& p) {
      return size * p + Vec3<double>{offset, offset, -offset};
    });
    const Winding<T> winding(sphere);
    std::mt19937 engine(12);
    std::uniform_real_distribution<double> weight(0, 1);
    for (int i = 0; i < scaled(500); ++i) {
      const auto [a, b, c] = winding.triangle(engine() % winding.triangles().size());
      const double u = weight(engine);
      const double v = weight(engine) * (1 - u);
      const auto on = a + u * (b - a) + v * (c - a);
      const auto normal = normalized(cross(b - a, c - a));
      // The coordinates' rounding moves `on` by up to about 1e-16.
      const double step = 1e-15 * std::max(size, offset);
      EXPECT_NEAR(winding->exactSum(on - step * normal), 1, 1e-12) << on;
      EXPECT_NEAR(winding->exactSum(on + step * normal), 0, 1e-12) << on;
      EXPECT_TRUE(winding->isInside(on - step * normal)) << on;
      EXPECT_FALSE(winding->isInside(on + step * normal)) << on;
    }
  }
}

/// Next to edges and vertices, where the directions to two corners are nearly opposite.
TYPED_TEST(SolidAngleTest, IsRightNextToEdgesAndVertices) {
  using T = TypeParam;
  const Winding<T> box(tessellation::box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, 3));
  const auto& corners = box.positions();
  RandomPoints<double> random(1, 13);
  for (int i = 0; i < scaled(3'000); ++i) {
    const Vec3<double> corner(corners[static_cast<std::size_t>(i) % corners.size()]);
    const auto offset = random.next();
    const auto p = corner + std::pow(10.0, -5.0 - i % 11) * offset;
    const double distance = maxComponent(abs(p)) - 0.5;
    const double expected = distance < 0 ? 1 : distance > 0 ? 0 : 0.5;
    if (distance == 0) continue;  // one coordinate was rounded onto the surface
    EXPECT_EQ(box->isInside(p), distance < 0) << p << ' ' << corner;
    EXPECT_NEAR(box->exactSum(p), expected, 1e-12) << p << ' ' << corner;
    const auto estimate = box->estimate(p, 1e-9);
    EXPECT_LE(estimate.error, 1e-9) << p;
  }
}

TYPED_TEST(SolidAngleTest, SliversAndDegenerateTriangles) {
  using T = TypeParam;
  // A closed needle of 3 slivers and a tiny lid, and triangles without area that change nothing.
  const T thin = T(1e-7);
  std::vector<Vec3<T>> points{{-1, 0, 0}, {1, thin, 0}, {1, -thin, thin}, {1, -thin, -thin}};
  const Winding<T> needle(points, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
  const Winding<T> dirty(points,
                         {{0, 2, 1}, {0, 1, 0}, {0, 3, 2}, {3, 3, 3}, {0, 1, 3}, {1, 2, 3}});
  RandomPoints<double> random(1, 14);
  int inside = 0;
  for (int i = 0; i < scaled(3'000); ++i) {
    const auto r = random.next();
    const Vec3<double> p{r.x, 2 * double{thin} * r.y, 2 * double{thin} * r.z};
    const double expected = bruteForce(needle, p);
    EXPECT_NEAR(needle->exactSum(p), std::round(expected), 1e-12) << p;
    EXPECT_EQ(needle->isInside(p), expected > 0.5) << p;
    EXPECT_NEAR(dirty->exactSum(p), std::round(expected), 1e-12) << p;
    EXPECT_EQ(dirty->isInside(p), expected > 0.5) << p;
    inside += expected > 0.5 ? 1 : 0;
  }
  EXPECT_GT(inside, 10);
}

}  // namespace
}  // namespace cutwater::test
