#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <optional>

#include <gtest/gtest.h>

#include "Support/CpuTime.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Random.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

using Mesh = MeshSDF<double>;

/// n log n and linear work grow four- to fivefold, quadratic work sixteenfold. Times under a
/// hundredth of a second count as that.
constexpr double kMostGrowth = 8;

/// Of the time for `large` over that for `small`, the least of up to three rounds: what else the
/// machine does only adds to either.
template <typename Small, typename Large>
double growth(Small&& small, Large&& large, double enough) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  double least = kInf;
  double leastSmall = kInf;
  for (int round = 0; round < 3 && !(least < enough * leastSmall); ++round) {
    leastSmall = std::min(leastSmall, std::max(cpuSeconds(small), 0.01));
    least = std::min(least, cpuSeconds(large));
  }
  return least / leastSmall;
}

/// Builds a mesh of size n and one of 4 n.
template <typename MakeSoup>
Mesh expectBuild(MakeSoup makeSoup, std::uint32_t n, double mostSeconds) {
  const auto smallSoup = makeSoup(n);
  const auto largeSoup = makeSoup(4 * n);
  std::optional<Mesh> mesh;
  double seconds = 0;
  const double factor =
      growth([&] { const Mesh other(smallSoup); },
             [&] { seconds = cpuSeconds([&] { mesh.emplace(largeSoup); }); }, kMostGrowth);
  EXPECT_LT(factor, kMostGrowth);
  EXPECT_LT(seconds, mostSeconds);
  return *mesh;
}

/// Even if all triangles are equally near: a few exact predicates for each, 0.1 to 0.5 us. The
/// least of up to three rounds, as above.
void expectLinearQuery(const Mesh& mesh, const Vec3<double>& p) {
  const double enough = 10e-6 * static_cast<double>(mesh.triangleCount());
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 3 && !(least < enough); ++round) {
    least = std::min(least, cpuSeconds([&] { (void)mesh.signedDistance(p); }));
  }
  EXPECT_LT(least, enough) << p;
}

/// The same triangles n times, with the same points or with others in the same places.
PolygonSoup copies(const PolygonSoup& one, std::uint32_t n, bool shared) {
  PolygonSoup soup;
  soup.patchNames = one.patchNames;
  const auto count = static_cast<std::uint32_t>(one.points.size());
  for (std::uint32_t k = 0; k < n; ++k) {
    if (k == 0 || !shared) {
      soup.points.insert(soup.points.end(), one.points.begin(), one.points.end());
    }
    const std::uint32_t shift = shared ? 0 : k * count;
    for (std::size_t i = 0; i < one.polygonCount(); ++i) {
      const auto c = one.polygon(i);
      soup.addPolygon(std::array{c[0] + shift, c[1] + shift, c[2] + shift});
    }
  }
  return soup;
}

PolygonSoup cubeOf(double half) {
  return triangulated(tessellation::box({-half, -half, -half}, {half, half, half}));
}

TEST(MeshGrowthTest, AMillionTrianglesAtTwoVertices) {
  const auto mesh = expectBuild(bipyramid, 125'000, 120);
  ASSERT_EQ(mesh.triangleCount(), 1'000'000U);
  EXPECT_TRUE(mesh.signReport().isSound());
  const double half = std::sqrt(0.5);
  // All triangles of one apex, or of both, are equally near, and agree on the side or do not.
  EXPECT_EQ(mesh.signedDistance({0, 0, 1}), 0);
  EXPECT_EQ(mesh.signedDistance({0, 0, 3}), 2);
  EXPECT_NEAR(mesh.signedDistance({0, 0, 0}), -half, 1e-10);
  EXPECT_NEAR(mesh.signedDistance({0, 0, 0.5}), -half / 2, 1e-10);
  EXPECT_NEAR(mesh.signedDistance({0, 0, 1 - 0x1p-40}), -half * 0x1p-40, 1e-15);
  EXPECT_LT(mesh.signedDistance({0, 0, 1 - 0x1p-40}), 0);
  EXPECT_NEAR(mesh.signedDistance({1, 1, 1}), 1, 1e-9);  // of the cone r + z = 1, r = sqrt(2)
  for (const double z : {0.0, 0.5, 1 - 0x1p-40, 1.0, 1 + 0x1p-40, 3.0, 1e6}) {
    expectLinearQuery(mesh, {0, 0, z});
    expectLinearQuery(mesh, {0x1p-40, 0, z});
  }
}

/// Seconds for one round of points about the bipyramid; those nearest to an apex, where all its
/// triangles tie and have to be compared, are left out.
double secondsAround(const Mesh& mesh) {
  RandomPoints<double> random(1.25);
  std::vector<Vec3<double>> points;
  while (points.size() < 3000) {
    const auto p = random.next();
    if (std::abs(p.z) - 1 < 0.9 * std::hypot(p.x, p.y)) points.push_back(p);
  }
  return cpuSeconds([&] {
    for (const auto& p : points) (void)mesh.signedDistance(p);
  });
}

TEST(MeshGrowthTest, QueriesAroundAFanGrowMuchSlowerThanItsTriangles) {
  const Mesh small(bipyramid(1'000));
  const Mesh large(bipyramid(64'000));
  // Axis-aligned boxes of its triangles all overlap, and queries take 64 times as long. In turned
  // boxes it is those within a thousandth of a radian, which single precision cannot tell apart.
  EXPECT_LT(growth([&] { secondsAround(small); }, [&] { secondsAround(large); }, 16), 16);
}

TEST(MeshGrowthTest, TwentyThousandCopiesOfABox) {
  // Exact arithmetic takes ten times as long under AddressSanitizer: a quarter as many there.
#ifdef __SANITIZE_ADDRESS__
  constexpr std::uint32_t kSmall = 1'250;
#else
  constexpr std::uint32_t kSmall = 5'000;
#endif
  for (const bool shared : {false, true}) {
    const auto make = [&](std::uint32_t n) { return copies(cubeOf(1), n, shared); };
    const auto mesh = expectBuild(make, kSmall, 60);
    EXPECT_TRUE(mesh.signReport().isClosed());
    EXPECT_EQ(mesh.signReport().unsound, mesh.signReport().probes);
    EXPECT_GE(mesh.signReport().probes, 64U);
    EXPECT_NEAR(mesh.signedDistance({0.1, 0.2, 0.3}), -0.7, 1e-15);
    EXPECT_EQ(mesh.signedDistance({1, 0.3, 0.2}), 0);
    EXPECT_EQ(mesh.signedDistance({0.3, 0.2, 3}), 2);
    EXPECT_LT(mesh.signedDistance({1 - 0x1p-50, 0.3, 0.2}), 0);
    EXPECT_GT(mesh.signedDistance({1 + 0x1p-50, 0.3, 0.2}), 0);
    for (const double x : {0.0, 0.3, 1.0, 2.0}) expectLinearQuery(mesh, {x, x, x});
  }
}

TEST(MeshGrowthTest, TwentyThousandCopiesOfATriangle) {
  const auto triangle = makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  for (const bool shared : {false, true}) {
    const auto make = [&](std::uint32_t n) { return copies(triangle, n, shared); };
    const auto mesh = expectBuild(make, 5'000, 60);
    EXPECT_EQ(mesh.signReport().unbalancedEdges, shared ? 3U : 60'000U);
    // A winding number of nearly 10 000 just behind, its opposite just before.
    EXPECT_EQ(mesh.signedDistance({0.25, 0.25, -0.125}), -0.125);
    EXPECT_EQ(mesh.signedDistance({0.25, 0.25, 0.125}), 0.125);
    EXPECT_EQ(mesh.signedDistance({0.25, 0.25, 0}), 0);
    EXPECT_EQ(mesh.signedDistance({3, 0, 0}), 2);
    // From afar it is 20 000 times the area over 4 pi z^2: 1/2 at z = 39.9.
    EXPECT_LT(mesh.signedDistance({1.0 / 3, 1.0 / 3, -39}), 0);
    EXPECT_GT(mesh.signedDistance({1.0 / 3, 1.0 / 3, -41}), 0);
    for (const double z : {-1.0, 0.0, 1.0}) expectLinearQuery(mesh, {0.25, 0.25, z});
  }
}

TEST(MeshGrowthTest, BoxesNestedByPowersOfTwo) {
  for (const int n : {64, 200}) {
    PolygonSoup soup;
    soup.patchNames = {"boxes"};
    for (int k = 0; k < n; ++k) soup = together(soup, cubeOf(std::ldexp(1, -k)));
    const Mesh mesh(soup);
    EXPECT_EQ(mesh.signReport().shells, static_cast<std::size_t>(n));
    EXPECT_GT(mesh.signReport().unsound, 0U);
    // Inside all of them, inside some, and on the faces of one within the others.
    EXPECT_EQ(mesh.signedDistance({0, 0, 0}), -std::ldexp(1, 1 - n));
    EXPECT_EQ(mesh.signedDistance({std::ldexp(1, 2 - n), 0, 0}), 0);
    EXPECT_EQ(mesh.signedDistance({0.75, 0, 0}), -0.25);
    EXPECT_EQ(mesh.signedDistance({0.375, 0.125, 0}), -0.125);
    EXPECT_EQ(mesh.signedDistance({1, 0.5, 0}), 0);
    EXPECT_EQ(mesh.signedDistance({2, 0.5, 0}), 1);
    for (int k = 0; k < n + 3; ++k) expectLinearQuery(mesh, {std::ldexp(0.75, -k), 0, 0});
  }
}

TEST(MeshGrowthTest, ALongStripOfSlivers) {
  const auto strip = [](std::uint32_t n) {
    PolygonSoup soup;
    soup.patchNames = {"strip"};
    for (std::uint32_t i = 0; i <= n; ++i) {
      for (const double y : {0.0, 1e-9}) soup.points.push_back({static_cast<double>(i) / n, y, 0});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      soup.addPolygon(std::array{2 * i, 2 * i + 2, 2 * i + 1});
      soup.addPolygon(std::array{2 * i + 1, 2 * i + 2, 2 * i + 3});
    }
    return soup;
  };
  const auto mesh = expectBuild(strip, 50'000, 60);
  EXPECT_EQ(mesh.signedDistance({0.5, 0, 1}), 1);
  EXPECT_EQ(mesh.signedDistance({-5, 0, 0}), 5);
  // Nearby a few triangles compete, from afar those that single precision cannot tell apart.
  const double seconds = cpuSeconds([&] {
    for (int i = 0; i < 1000; ++i) (void)mesh.signedDistance({i * 1e-3, 1e-4, 1e-4});
  });
  EXPECT_LT(seconds, 1);
}

TEST(MeshGrowthTest, QueriesNearTheSurfaceGrowLikeTheLogarithm) {
  const Mesh small(tessellation::icosphere(1, 4));
  const Mesh large(tessellation::icosphere(1, 7));
  // About a thousandth away; farther away more and more boxes overlap the ball about the point.
  const auto ask = [](const Mesh& mesh) {
    RandomPoints<double> random(1);
    for (int i = 0; i < 20'000; ++i) (void)mesh.signedDistance(1.001 * normalized(random.next()));
  };
  // 64 times as many triangles
  EXPECT_LT(growth([&] { ask(small); }, [&] { ask(large); }, 6), 6);
}

}  // namespace
}  // namespace cutwater::test
