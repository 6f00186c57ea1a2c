#include <Cutwater/Triangles/TriangleDistance.hpp>

#include "Support/CpuTime.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "WindingCases.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class WindingNumberTest : public ::testing::Test {};
TYPED_TEST_SUITE(WindingNumberTest, Precisions);

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

TYPED_TEST(WindingNumberTest, FarFromALevelIsCertain) {
  using T = TypeParam;
  for (const auto& soup : soups()) {
    const Winding<T> winding(soup);
    RandomPoints<double> random(1.3, 9);
    for (int i = 0; i < scaled(100); ++i) {
      const auto p = random.next();
      const double level = random.next().x;
      const double apart = std::abs(bruteForce(winding, p) - level);
      for (const double distance : {0.0, 0.1, apart - 1e-3, apart + 1e-3}) {
        if (distance < 0 || std::abs(distance - apart) < 1e-4) continue;
        EXPECT_EQ(winding->isFarFrom(p, level, distance, 1e-6), apart > distance) << p;
      }
      // What is too close to call within the tolerance is left open.
      EXPECT_FALSE(winding->isFarFrom(p, level, apart, 0x1p-20).value_or(false)) << p;
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

/// Where it is exactly 1/2 whatever the triangulation: between rounding errors there would be no
/// choice, nor any before the last triangle.
TYPED_TEST(WindingNumberTest, ThePlaneOfAFlatHoleIsOutside) {
  using T = TypeParam;
  const auto box = tessellation::box({-1, -1, -1}, {1, 1, 0.5}, 40);
  const auto isLid = [&](std::size_t i) {
    return std::ranges::all_of(box.polygon(i), [&](auto v) { return box.points[v].z == 0.5; });
  };
  const Winding<T> open(filtered(box, [&](std::size_t i, const auto&) { return !isLid(i); }));
  RandomPoints<double> random(1, 10);
  const double seconds = cpuSeconds([&] {
    for (int i = 0; i < scaled(500); ++i) {
      const auto p = random.next();
      EXPECT_FALSE(open->isInside({p.x, p.y, 0.5})) << p;
      EXPECT_TRUE(open->isInside({0.9 * p.x, 0.9 * p.y, 0.49})) << p;
    }
  });
  EXPECT_NEAR(open->exactSum({0.2, 0.3, 0.5}), 0.5, 1e-12);
  EXPECT_LT(seconds, 10 * scaled(1));
}

TYPED_TEST(WindingNumberTest, TheTreeChangesNoDecision) {
  using T = TypeParam;
  const auto soup = soups()[1];
  const Winding<T> winding(soup);
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

/// A small cluster far from the frame's origin: the point must not be rounded to single precision.
TYPED_TEST(WindingNumberTest, FarFieldsOfSmallPartsKeepTheirBound) {
  using T = TypeParam;
  const auto cluster = withPoints(randomTriangles(8, 0.3, 3), [](const auto& p) {
    return 0x1p-22 * p + Vec3<double>{0.875, 0.75, 0.625};
  });
  const auto other = withPoints(cluster, [](const auto& p) { return -1.0 * p; });
  const Winding<T> winding(together(cluster, other));
  RandomPoints<double> random(1, 18);
  for (int i = 0; i < scaled(1'000); ++i) {
    const auto offset = 0x1p-22 * (1.5 + i % 40) * normalized(random.next());
    const auto p = Vec3<double>{0.875, 0.75, 0.625} + offset;
    const auto [value, error] = winding->estimate(p, 1e5);
    EXPECT_LE(std::abs(value - bruteForce(winding, p)), error) << p;
  }
}

/// Every lane's ball holds the triangles below it, and its area is theirs.
TYPED_TEST(WindingNumberTest, MomentsEncloseTheirTriangles) {
  using T = TypeParam;
  const Winding<T> winding(soups()[1]);
  const auto tree = winding.tree().tree();
  const auto visit = [&](const auto& self, std::uint32_t n, auto&& each) -> void {
    const auto& node = tree.nodes()[n];
    for (int lane = 0; lane < 16; ++lane) {
      if ((node.nodeMask >> lane & 1) != 0) self(self, node.nodeIndex(lane), each);
      if (!node.isLeaf(lane)) continue;
      for (const auto id : tree.leaf(node.leafIndex(lane))) {
        if (id != kNone) each(winding.triangle(id));
      }
    }
  };
  ASSERT_GT(tree.nodes().size(), 20U);
  for (const auto& node : tree.nodes()) {
    const auto& moments =
        winding.arrays().moments[static_cast<std::size_t>(&node - &tree.nodes()[0])];
    for (int lane = 0; lane < 16; ++lane) {
      if ((node.nodeMask >> lane & 1) == 0) continue;
      const auto k = static_cast<std::size_t>(lane);
      const Vec3<double> center{moments.center[0][k], moments.center[1][k], moments.center[2][k]};
      double radius = 0;
      double area = 0;
      visit(visit, node.nodeIndex(lane), [&](const auto& triangle) {
        std::array<Vec3<double>, 3> v;
        for (std::size_t i = 0; i < 3; ++i) {
          v[i] = tree.frame().scale * (triangle[i] - tree.frame().center);
          radius = std::max(radius, length(v[i] - center));
        }
        area += 0.5 * length(cross(v[1] - v[0], v[2] - v[0]));
      });
      EXPECT_LE(radius, moments.radius[k]);
      EXPECT_GE(1.5 * radius, moments.radius[k]);
      EXPECT_LE(area, moments.area[k]);
      EXPECT_GE(1.001 * area, moments.area[k]);
    }
  }
}

TYPED_TEST(WindingNumberTest, NoTriangleIsNearerThanTheBound) {
  using T = TypeParam;
  auto cases = soups();
  cases.push_back(tessellation::box({-1, -1, -1}, {1, 1, -0.5}));  // of few triangles
  for (const auto& soup : cases) {
    const Winding<T> winding(soup);
    RandomPoints<double> random(3, 5);
    int useful = 0;
    for (int i = 0; i < scaled(200); ++i) {
      const auto p = random.next();
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t id = 0; id < winding.triangles().size(); ++id) {
        const auto [a, b, c] = winding.triangle(id);
        const Triangle<double> t{a, b, c, true};
        nearest = std::min(nearest, std::sqrt(triangleDistance(p, t).distanceSquared));
      }
      EXPECT_LE(winding->distanceBound(p), nearest) << p;
      useful += winding->distanceBound(p) > 0.3 * nearest ? 1 : 0;
    }
    EXPECT_GT(useful, 0);
  }
}

TYPED_TEST(WindingNumberTest, IsNowhereInABoxLargerThanTheBound) {
  using T = TypeParam;
  for (const auto& soup : soups()) {
    const Winding<T> winding(soup);
    RandomPoints<double> random(3, 6);
    int useful = 0;
    for (int i = 0; i < scaled(200); ++i) {
      const auto size = std::pow(0.5, i % 8);
      const auto lower = (1 + 3.0 * (i % 3)) * random.next();
      const Box<double> box{lower, lower + Vec3<double>{size, 0.7 * size, 0.2 * size}};
      const double bound = winding->bound(box);
      useful += bound < 0.5 ? 1 : 0;
      for (int corner = 0; corner < 8; ++corner) {
        const auto p = corner == 0 ? box.center() : box.corner(corner);
        EXPECT_LE(std::abs(winding->exactSum(p)), bound) << p;
      }
    }
    EXPECT_GT(useful, 10);
    for (const double far : {1e3, 1e9, 1e30, 1e300}) {
      EXPECT_LT(winding->bound({{far, 0, 0}, {far, 1, 1}}), 1e-4) << far;
    }
    EXPECT_GT(winding->bound({{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}}), 1e30);
  }
  EXPECT_EQ(Winding<T>({}, {})->bound({{0, 0, 0}, {1, 1, 1}}), 0);
}

TYPED_TEST(WindingNumberTest, AnswersPointsOutOfRange) {
  using T = TypeParam;
  const Winding<T> winding(soups()[1]);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const Vec3<double> p : {Vec3<double>{kNan, 0, 0}, Vec3<double>{0, kInf, 0}}) {
    EXPECT_TRUE(std::isnan(winding->estimate(p, 0.1).value));
    EXPECT_FALSE(winding->isInside(p));
    EXPECT_FALSE(winding->isFarFrom(p, 0.5, 0.1, 1e-6));
  }
  for (const double far : {1e3, 1e9, 1e17, 1e30, 1e300}) {
    const auto [value, error] = winding->estimate({far, -far, 0}, 1e-3);
    EXPECT_LE(std::abs(value), error + 1 / far) << far;
    EXPECT_LE(error, 1e-3);
    EXPECT_FALSE(winding->isInside({far, far, far}));
    EXPECT_EQ(winding->isFarFrom({far, -far, 0}, 0.5, 0.1, 1e-6), true);
  }
  const Winding<T> nothing({}, {});
  EXPECT_EQ(nothing->estimate({0, 0, 0}, 0.1).value, 0);
  EXPECT_FALSE(nothing->isInside({0, 0, 0}));
  EXPECT_EQ(nothing->isFarFrom({0, 0, 0}, 0.5, 0.1, 1e-6), true);
  EXPECT_EQ(nothing->gradientBound({{0, 0, 0}, {1, 1, 1}}), 0);
}

}  // namespace
}  // namespace cutwater::test
