#include <numbers>

#include "Support/CpuTime.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "WindingCases.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class WindingGradientTest : public ::testing::Test {};
TYPED_TEST_SUITE(WindingGradientTest, Precisions);

TEST(OpenEdgesTest, AreThoseWithoutBalance) {
  using Ids = std::array<std::uint32_t, 3>;
  EXPECT_TRUE(
      findOpenEdges(std::vector<Ids>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, 4).empty());
  // Two triangles that pass their common edge in the same direction, and one without area.
  const auto edges = findOpenEdges(std::vector<Ids>{{0, 1, 2}, {0, 1, 3}, {1, 1, 2}}, 4);
  ASSERT_EQ(edges.size(), 5U);
  EXPECT_EQ(edges[0].lower, 0U);
  EXPECT_EQ(edges[0].upper, 1U);
  EXPECT_EQ(edges[0].multiplicity, 2);
  EXPECT_EQ(edges[0].triangle, 0U);
  EXPECT_EQ(edges[1].multiplicity, -1);  // 0 - 2, passed by (0, 1, 2) from 2 to 0
  EXPECT_EQ(edges[1].upper, 2U);
  // A sheet that ends at the middle of another is open there, fins and doubled sheets are not.
  EXPECT_TRUE(findOpenEdges(std::vector<Ids>{{0, 1, 2}, {0, 2, 1}}, 3).empty());
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

TYPED_TEST(WindingGradientTest, GradientsStayBelowTheirBound) {
  using T = TypeParam;
  const auto all = soups();
  for (const std::size_t s : {1U, 2U, 4U, 5U}) {
    const Winding<T> winding(all[s]);
    RandomPoints<double> random(1.2, 15);
    RandomPoints<double> direction(1, 16);
    for (int i = 0; i < scaled(300); ++i) {
      const auto center = random.next();
      const double half = std::pow(10.0, -1.0 - i % 4);
      const auto box = Box<double>{center, center}.grown(half);
      const double bound = std::min(winding->gradientBound(box), winding->gradientBoundByArea(box));
      const auto p = center + half * direction.next();
      const auto step = 1e-6 * normalized(direction.next());
      const double change = winding->exactSum(p + step) - winding->exactSum(p - step);
      if (std::abs(change) > 0.4) continue;  // through a triangle
      EXPECT_LE(std::abs(change) / 2e-6, bound * 1.0001 + 1e-8) << center << ' ' << half;
    }
  }
}

/// On the axis of something small the field is that of a dipole, A / (4 pi z^2).
TYPED_TEST(WindingGradientTest, ByAreaIsAttainedAboveASmallDisk) {
  using T = TypeParam;
  const double pi = std::numbers::pi;
  for (const double r : {0.0078125, 0.25}) {
    const auto disk = filtered(star(200), [&](std::size_t i, const auto&) { return i < 200; });
    const Winding<T> small(withPoints(disk, [&](const auto& p) {
      return r * Vec3<double>{p.x, p.y, 0};
    }));
    const double z = 8 * r;
    const double slope = 2 * pi * r * r / (4 * pi * z * z * z);
    const double bound = small->gradientBoundByArea({{0, 0, z}, {0, 0, z}});
    EXPECT_GE(bound, slope * 0.95);
    EXPECT_LE(bound, slope * 1.2);
    EXPECT_LE(small->gradientBoundByArea({{0, 0, z}, {0, 0, 2 * z}}), bound * (1 + 1e-9));
    EXPECT_EQ(small->gradientBoundByArea({{0, 0, -z}, {0, 0, z}}),
              std::numeric_limits<double>::max());
  }
}

/// In the middle of a round rim all of it pulls the same way, so the bound is the gradient itself:
/// 1/(4 pi) * 2 pi r / r^2.
TYPED_TEST(WindingGradientTest, IsAttainedInTheMiddleOfARim) {
  using T = TypeParam;
  const double r = 0.0625;
  const auto rim = [&](std::uint32_t n) {
    auto disk = star(n);
    const auto cone = filtered(disk, [&](std::size_t i, const auto&) { return i < n; });
    return withPoints(cone, [&](const auto& p) { return r * p; });
  };
  for (const std::uint32_t n : {24U, 2'000U}) {
    const Winding<T> cone(rim(n));
    const double bound = cone->gradientBound({{0, 0, 0}, {0, 0, 0}});
    const double step = 1e-4 * r;
    const double slope =
        (cone->exactSum({0, 0, step}) - cone->exactSum({0, 0, -step})) / (2 * step);
    EXPECT_NEAR(std::abs(slope), 0.5 / r, 0.01 * 0.5 / r) << n;
    EXPECT_GE(bound, 0.5 / r * 0.99) << n;
    EXPECT_LE(bound, 0.5 / r * 4) << n;
  }
}

TYPED_TEST(WindingGradientTest, GradientBoundsAreNotIdle) {
  using T = TypeParam;
  const auto all = soups();
  for (const std::size_t s : {1U, 2U}) {
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
  // An eighth of the size, eight times the gradient: through nodes that are far away, too.
  const Winding<T> large(all[2]);
  const Winding<T> little(withPoints(all[2], [](const auto& p) { return 0.125 * p; }));
  const double far = large->gradientBound({{-3, 1, 1}, {-2.5, 1, 1}});
  EXPECT_NEAR(little->gradientBound({{-0.375, 0.125, 0.125}, {-0.3125, 0.125, 0.125}}), 8 * far,
              1e-3 * far);
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
