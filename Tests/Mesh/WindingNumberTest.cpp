#include <Cutwater/Bvh/BvhBuilder.hpp>
#include <Cutwater/Mesh/Tessellation.hpp>
#include <Cutwater/Mesh/WindingNumber.hpp>

#include "Support/CpuTime.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Triangles, a tree over them, and their moments.
template <typename T>
class Winding {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  Winding(std::vector<Vec3<T>> positions, std::vector<Corners> triangles)
      : positions_(std::move(positions)), triangles_(std::move(triangles)) {
    std::vector<Box<double>> boxes;
    for (const auto& corners : triangles_) {
      Box<double> box;
      for (const auto v : corners) box.extend(Vec3<double>(positions_[v]));
      boxes.push_back(box);
    }
    tree_ = buildBvh<16, 4>(boxes);
    arrays_ = buildWindingMoments<T>(positions_, triangles_, tree_.tree());
  }
  /// Polygons as fans.
  explicit Winding(const PolygonSoup& soup) : Winding(positionsOf(soup), trianglesOf(soup)) {}
  Winding(const Winding&) = delete;
  Winding& operator=(const Winding&) = delete;

  [[nodiscard]] WindingNumber<T> number() const {
    return {positions_,      triangles_,    tree_.tree(),
            arrays_.moments, arrays_.edges, arrays_.openEdges};
  }
  [[nodiscard]] const WindingNumber<T>* operator->() const {
    number_ = number();
    return &number_;
  }
  [[nodiscard]] const WindingArrays& arrays() const { return arrays_; }
  [[nodiscard]] const BvhArrays<16, 4>& tree() const { return tree_; }
  [[nodiscard]] const std::vector<Vec3<T>>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
  [[nodiscard]] std::array<Vec3<double>, 3> triangle(std::size_t id) const {
    const auto& v = triangles_[id];
    return {Vec3<double>(positions_[v[0]]), Vec3<double>(positions_[v[1]]),
            Vec3<double>(positions_[v[2]])};
  }

 private:
  static std::vector<Vec3<T>> positionsOf(const PolygonSoup& soup) {
    std::vector<Vec3<T>> result;
    for (const auto& p : soup.points) result.push_back(static_cast<Vec3<T>>(p));
    return result;
  }
  static std::vector<Corners> trianglesOf(const PolygonSoup& soup) {
    std::vector<Corners> result;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto c = soup.polygon(i);
      for (std::size_t k = 2; k < c.size(); ++k) result.push_back({c[0], c[k - 1], c[k]});
    }
    return result;
  }

  std::vector<Vec3<T>> positions_;
  std::vector<Corners> triangles_;
  BvhArrays<16, 4> tree_;
  WindingArrays arrays_;
  mutable WindingNumber<T> number_;
};

struct Long3 {
  long double x, y, z;
};
long double dot(const Long3& a, const Long3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The oracle: one triangle by atan2 in extended precision.
long double turnsOf(const std::array<Vec3<double>, 3>& triangle, const Vec3<double>& p) {
  std::array<Long3, 3> v{};
  std::array<long double, 3> l{};
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {static_cast<long double>(triangle[i].x) - p.x,
            static_cast<long double>(triangle[i].y) - p.y,
            static_cast<long double>(triangle[i].z) - p.z};
    l[i] = std::sqrt(dot(v[i], v[i]));
  }
  const auto& [a, b, c] = v;
  const Long3 normal{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
  return std::atan2(dot(a, normal),
                    l[0] * l[1] * l[2] + dot(a, b) * l[2] + dot(b, c) * l[0] + dot(c, a) * l[1]) /
         (2 * 3.14159265358979323846264338327950288L);
}

template <typename T>
double bruteForce(const Winding<T>& winding, const Vec3<double>& p) {
  long double sum = 0;
  for (std::size_t i = 0; i < winding.triangles().size(); ++i) {
    sum += turnsOf(winding.triangle(i), p);
  }
  return static_cast<double>(sum);
}

PolygonSoup filtered(const PolygonSoup& soup, auto keep) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (keep(i, soup.points[soup.polygon(i)[0]])) result.addPolygon(soup.polygon(i), 0);
  }
  return result;
}

PolygonSoup randomTriangles(std::uint32_t count, double size, unsigned seed) {
  RandomPoints<double> random(1, seed);
  PolygonSoup soup;
  soup.patchNames = {"all"};
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto center = 0.5 * random.next();
    for (int k = 0; k < 3; ++k) soup.points.push_back(center + size * random.next());
    soup.addPolygon(std::array{3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

/// Closed, holed, overlapping, and without any order; all within [-1, 1]^3.
std::vector<PolygonSoup> soups() {
  const auto sphere = tessellation::icosphere(0.8, 4);
  const auto torus = tessellation::torus(0.6, 0.2, 40, 20);
  const auto moved = withPoints(sphere, [](auto p) { return 0.5 * p + Vec3<double>{0.3, 0.2, 0}; });
  return {sphere,
          filtered(sphere, [](std::size_t i, const auto&) { return i % 29 != 0; }),
          filtered(torus, [](std::size_t, const auto& p) { return p.x < 0.3; }),
          together(sphere, moved),
          randomTriangles(1500, 0.03, 1),
          randomTriangles(300, 0.6, 2)};
}

template <typename T>
class WindingNumberTest : public ::testing::Test {};
TYPED_TEST_SUITE(WindingNumberTest, Precisions);

TYPED_TEST(WindingNumberTest, AnOctantIsAnEighth) {
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

TYPED_TEST(WindingNumberTest, AHugeTriangleIsHalfSpace) {
  using T = TypeParam;
  const Winding<T> plane({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{0, 1, 2}});
  // Up is the front: the side that is outside. At height h what is missing is of order h.
  EXPECT_NEAR(plane->exactSum({0, 0, -1e-9}), 0.5, 1e-8);
  EXPECT_NEAR(plane->exactSum({0, 0, 1e-9}), -0.5, 1e-8);
  EXPECT_EQ(plane->exactSum({0, 0, 0}), 0);
  EXPECT_EQ(plane->exactSum({3, 1, 0}), 0);
}

TYPED_TEST(WindingNumberTest, ClosedSurfacesAreWholeNumbers) {
  using T = TypeParam;
  const Winding<T> sphere(tessellation::icosphere(1, 4));
  const Winding<T> box(tessellation::box({-1, -0.5, -0.25}, {1, 0.5, 0.25}, 5));
  RandomPoints<double> random(1.5);
  for (int i = 0; i < scaled(300); ++i) {
    const auto p = random.next();
    if (std::abs(length(p) - 1) > 0.01) {
      EXPECT_NEAR(sphere->exactSum(p), length(p) < 1 ? 1 : 0, 1e-12) << p;
      EXPECT_NEAR(sphere->estimate(p, 1e-9).value, length(p) < 1 ? 1 : 0, 1e-9) << p;
      EXPECT_EQ(sphere->isInside(p), length(p) < 1) << p;
    }
    const bool inBox = std::abs(p.x) < 1 && std::abs(p.y) < 0.5 && std::abs(p.z) < 0.25;
    EXPECT_NEAR(box->exactSum(p), inBox ? 1 : 0, 1e-12) << p;
    EXPECT_EQ(box->isInside(p), inBox) << p;
  }
  EXPECT_TRUE(sphere.arrays().openEdges.empty());
  EXPECT_EQ(sphere->gradientBound({{-1, -1, -1}, {1, 1, 1}}), 0);
}

TYPED_TEST(WindingNumberTest, AHemisphereOnItsAxis) {
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

TYPED_TEST(WindingNumberTest, EstimatesKeepTheirError) {
  using T = TypeParam;
  for (const auto& soup : soups()) {
    const Winding<T> winding(soup);
    RandomPoints<double> random(1.3, 7);
    for (int i = 0; i < scaled(100); ++i) {
      const auto p = random.next();
      const double expected = bruteForce(winding, p);
      for (const double tolerance : {0.5, 0.1, 1e-2, 1e-4, 1e-8}) {
        const auto [value, error] = winding->estimate(p, tolerance);
        EXPECT_LE(error, tolerance);
        EXPECT_LE(std::abs(value - expected), error) << p << ' ' << tolerance;
      }
      EXPECT_NEAR(winding->exactSum(p), expected, 1e-12) << p;
    }
  }
}

TYPED_TEST(WindingNumberTest, InsideIsDecidedRightly) {
  using T = TypeParam;
  for (const auto& soup : soups()) {
    const Winding<T> winding(soup);
    RandomPoints<double> random(1, 8);
    for (int i = 0; i < scaled(300); ++i) {
      const auto p = random.next();
      const double expected = bruteForce(winding, p);
      if (std::abs(expected - WindingNumber<T>::kThreshold) < 1e-9) continue;
      EXPECT_EQ(winding->isInside(p), expected > WindingNumber<T>::kThreshold) << p;
    }
  }
}

/// Bisects for points where the winding number is within rounding of the threshold.
TYPED_TEST(WindingNumberTest, InsideIsDecidedRightlyNextToTheSheet) {
  using T = TypeParam;
  const auto sphere = tessellation::icosphere(0.8, 4);
  const Winding<T> winding(filtered(sphere, [](auto, const auto& p) { return p.z < 0.4; }));
  RandomPoints<double> random(0.4, 9);
  constexpr double kThreshold = WindingNumber<T>::kThreshold;
  for (int i = 0; i < scaled(20); ++i) {
    const auto p = random.next();
    double inside = -0.5;
    double outside = 0.9;
    for (int k = 0; k < 48; ++k) {
      const double middle = (inside + outside) / 2;
      const Vec3<double> probe{p.x, p.y, middle};
      const double expected = bruteForce(winding, probe);
      if (std::abs(expected - kThreshold) > 1e-11) {
        EXPECT_EQ(winding->isInside(probe), expected > kThreshold) << probe;
      }
      (expected > kThreshold ? inside : outside) = middle;
    }
  }
}

TYPED_TEST(WindingNumberTest, TheTreeChangesNoDecision) {
  using T = TypeParam;
  const auto soup = soups()[1];
  const Winding<T> winding(soup);
  auto tree = winding.tree();
  std::vector<Box<double>> blurred;  // larger boxes: another tree
  RandomPoints<double> random(1, 10);
  for (std::size_t i = 0; i < winding.triangles().size(); ++i) {
    const auto [a, b, c] = winding.triangle(i);
    blurred.push_back(
        Box<double>{min(a, min(b, c)), max(a, max(b, c))}.extend(a + 0.2 * random.next()));
  }
  const auto other = buildBvh<16, 4>(blurred);
  const auto arrays =
      buildWindingMoments<T>(winding.positions(), winding.triangles(), other.tree());
  const WindingNumber<T> number(winding.positions(), winding.triangles(), other.tree(),
                                arrays.moments, arrays.edges, arrays.openEdges);
  bool differs = false;
  for (int i = 0; i < scaled(2'000); ++i) {
    const auto p = random.next();
    EXPECT_EQ(number.isInside(p), winding->isInside(p)) << p;
    differs = differs || number.estimate(p, 0.1).value != winding->estimate(p, 0.1).value;
    EXPECT_EQ(number.exactSum(p), winding->exactSum(p));
  }
  EXPECT_TRUE(differs);
}

/// Of single lanes: four triangles or many, about any centre, and the point as near as it can be.
/// The worst quotient of error and bound must be below 1, and the bound not idle.
TYPED_TEST(WindingNumberTest, FarFieldsKeepTheirBound) {
  using T = TypeParam;
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> exponent(0, 3);
  double worst = 0;
  for (int i = 0; i < scaled(1'500); ++i) {
    const auto count = static_cast<std::uint32_t>(1 + i % 40);
    const Winding<T> winding(randomTriangles(count, 0.3, static_cast<unsigned>(i)));
    const auto& node = winding.arrays().moments.front();
    const auto& frame = winding.tree().frame;
    RandomPoints<double> random(1, static_cast<unsigned>(i));
    for (std::size_t k = 0; k < 70; ++k) {
      const std::size_t lane = k % node.radius.size();
      if (!(node.area[lane] > 1e-20F)) continue;  // not used
      const double distance =
          double{node.radius[lane]} * (2 + std::pow(10, -exponent(engine)) * 10);
      const Vec3<double> center{node.center[0][lane], node.center[1][lane], node.center[2][lane]};
      const auto p = frame.center + (center + distance * normalized(random.next())) / frame.scale;
      const auto [value, error] = winding->estimate(p, 1e5);
      const double wrong = std::abs(value - bruteForce(winding, p));
      EXPECT_LE(wrong, error) << p;
      worst = std::max(worst, wrong / error);
    }
  }
  EXPECT_GT(worst, 0.02);
}

TYPED_TEST(WindingNumberTest, JumpsByOneAtATriangle) {
  using T = TypeParam;
  // Scaled by powers of two, and far from the origin for their size.
  for (const auto& [size, offset] :
       {std::pair{1.0, 0.0}, std::pair{0x1p-20, 0.0}, std::pair{0x1p-10, 1.0}}) {
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
TYPED_TEST(WindingNumberTest, IsRightNextToEdgesAndVertices) {
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

TYPED_TEST(WindingNumberTest, SliversAndDegenerateTriangles) {
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

TYPED_TEST(WindingNumberTest, AnswersPointsOutOfRange) {
  using T = TypeParam;
  const Winding<T> winding(soups()[1]);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const Vec3<double> p : {Vec3<double>{kNan, 0, 0}, Vec3<double>{0, kInf, 0}}) {
    EXPECT_TRUE(std::isnan(winding->estimate(p, 0.1).value));
    EXPECT_FALSE(winding->isInside(p));
  }
  for (const double far : {1e3, 1e9, 1e17, 1e30, 1e300}) {
    const auto [value, error] = winding->estimate({far, -far, 0}, 1e-3);
    EXPECT_LE(std::abs(value), error + 1 / far) << far;
    EXPECT_LE(error, 1e-3);
    EXPECT_FALSE(winding->isInside({far, far, far}));
  }
  const Winding<T> nothing({}, {});
  EXPECT_EQ(nothing->estimate({0, 0, 0}, 0.1).value, 0);
  EXPECT_FALSE(nothing->isInside({0, 0, 0}));
  EXPECT_EQ(nothing->gradientBound({{0, 0, 0}, {1, 1, 1}}), 0);
}

TEST(OpenEdgesTest, AreThoseWithoutBalance) {
  using Corners = std::array<std::uint32_t, 3>;
  EXPECT_TRUE(
      findOpenEdges(std::vector<Corners>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, 4).empty());
  // Two triangles that pass their common edge in the same direction, and one without area.
  const auto edges = findOpenEdges(std::vector<Corners>{{0, 1, 2}, {0, 1, 3}, {1, 1, 2}}, 4);
  ASSERT_EQ(edges.size(), 5U);
  EXPECT_EQ(edges[0].lower, 0U);
  EXPECT_EQ(edges[0].upper, 1U);
  EXPECT_EQ(edges[0].multiplicity, 2);
  EXPECT_EQ(edges[0].triangle, 0U);
  EXPECT_EQ(edges[1].multiplicity, -1);  // 0 - 2, passed by (0, 1, 2) from 2 to 0
  EXPECT_EQ(edges[1].upper, 2U);
  // A sheet that ends at the middle of another is open there, fins and doubled sheets are not.
  EXPECT_TRUE(findOpenEdges(std::vector<Corners>{{0, 1, 2}, {0, 2, 1}}, 3).empty());
}

TEST(OpenEdgesTest, TakeNoSquareOfTheValence) {
  const std::uint32_t n = 1'000'000;
  std::vector<std::array<std::uint32_t, 3>> fan;
  for (std::uint32_t i = 1; i < n; ++i) fan.push_back({0, i, i + 1});
  std::vector<OpenEdge> edges;
  EXPECT_LT(cpuSeconds([&] { edges = findOpenEdges(fan, n + 1); }), 20);
  EXPECT_EQ(edges.size(), n + 1);
}

/// The norm of the sum over open edges, by the midpoint rule: what the bound is to be near.
template <typename T>
double biotSavartSum(const Winding<T>& winding, const Vec3<double>& p) {
  double sum = 0;
  for (const auto& edge : winding.arrays().openEdges) {
    const Vec3<double> a(winding.positions()[edge.lower]);
    const Vec3<double> b(winding.positions()[edge.upper]);
    sum += std::abs(edge.multiplicity) * length(b - a) / lengthSquared(0.5 * (a + b) - p);
  }
  return sum / (4 * 3.141592653589793);
}

TYPED_TEST(WindingNumberTest, GradientsStayBelowTheirBound) {
  using T = TypeParam;
  const auto all = soups();
  for (const std::size_t s : {1, 2, 4, 5}) {
    const Winding<T> winding(all[s]);
    RandomPoints<double> random(1.2, 15);
    RandomPoints<double> direction(1, 16);
    for (int i = 0; i < scaled(300); ++i) {
      const auto center = random.next();
      const double half = std::pow(10.0, -1.0 - i % 4);
      const auto box = Box<double>{center, center}.grown(half);
      const double bound = winding->gradientBound(box);
      const auto p = center + half * direction.next();
      const auto step = 1e-6 * normalized(direction.next());
      const double change = winding->exactSum(p + step) - winding->exactSum(p - step);
      if (std::abs(change) > 0.4) continue;  // through a triangle
      EXPECT_LE(std::abs(change) / 2e-6, bound * 1.0001 + 1e-8) << center << ' ' << half;
    }
  }
}

TYPED_TEST(WindingNumberTest, GradientBoundsAreNotIdle) {
  using T = TypeParam;
  const auto all = soups();
  for (const std::size_t s : {1, 2}) {
    const Winding<T> winding(all[s]);
    RandomPoints<double> random(1.2, 17);
    double nearest = std::numeric_limits<double>::max();
    for (int i = 0; i < scaled(1'000); ++i) {
      const auto center = random.next();
      double distance = nearest;
      for (const auto& edge : winding.arrays().openEdges) {
        distance =
            std::min(distance, length(Vec3<double>(winding.positions()[edge.lower]) - center));
      }
      if (distance < 0.15) continue;
      const double bound = winding->gradientBound(Box<double>{center, center}.grown(0.01));
      EXPECT_LE(bound, 4 * biotSavartSum(winding, center)) << center;
    }
  }
  // Touching an open edge: no bound.
  const Winding<T> single({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_EQ(single->gradientBound({{0.5, -0.1, -0.1}, {0.6, 0.1, 0.1}}),
            std::numeric_limits<double>::max());
  EXPECT_LT(single->gradientBound({{0.2, 0.2, -0.1}, {0.21, 0.21, 0.1}}), 100);
  // Twice the edge, twice the bound; and the inverse of the unit of length.
  const double once = single->gradientBound({{2, 2, 2}, {2, 2, 2}});
  const Winding<T> twice({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}});
  EXPECT_NEAR(twice->gradientBound({{2, 2, 2}, {2, 2, 2}}), 2 * once, 1e-9 * once);
  const Winding<T> small({{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}}, {{0, 1, 2}});
  EXPECT_NEAR(small->gradientBound({{1, 1, 1}, {1, 1, 1}}), 2 * once, 1e-9 * once);
}

}  // namespace
}  // namespace cutwater::test
