#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/Search/TriangleSearch.hpp>

#include <numeric>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"
#include "Support/SurfaceInBlock.hpp"

// The same answers as when all triangles compete; ctest runs these for every instruction set.

namespace cutwater::test {
namespace {

/// A surface that can be searched with and without its tree.
template <typename T>
struct Searched : SearchableInBlock<T> {
  using SearchableInBlock<T>::surface;
  using SearchableInBlock<T>::hulls;
  using SearchableInBlock<T>::search;

  explicit Searched(const PolygonSoup& soup) : SearchableInBlock<T>(soup) {
    ids.resize(surface.triangles.size());
    std::iota(ids.begin(), ids.end(), 0U);
  }

  using Nearest = typename TriangleSurface<T>::Nearest;

  Nearest found(const Vec3<T>& p) const {
    auto best = surface.nothing(p);
    search.nearest(surface, p, best);
    return best;
  }
  Nearest expected(const Vec3<T>& p) const {
    auto best = surface.nothing(p);
    surface.compete(p, ids, best);
    return best;
  }

  std::vector<std::uint32_t> ids;
};

template <typename Nearest>
void expectSame(const Nearest& found, const Nearest& expected, const auto& p) {
  ASSERT_EQ(found.triangle, expected.triangle) << p;
  ASSERT_EQ(found.distanceSquared, expected.distanceSquared) << p;
  ASSERT_EQ(found.agreedSide(), expected.agreedSide()) << p;
}

/// Points around the surface, on it, as near to it as numbers go, and far away.
template <typename T>
std::vector<Vec3<T>> probes(const TriangleSurface<T>& surface, int count) {
  RandomPoints<T> random(1, /*seed=*/5);
  std::vector<Vec3<T>> points;
  for (int i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint32_t>(i * 7919L % std::ssize(surface.triangles));
    const auto t = surface.triangle(id);
    const auto w = abs(random.next());
    const T sum = w.x + w.y + w.z;
    const auto on = (w.x / sum) * t.a + (w.y / sum) * t.b + (w.z / sum) * t.c;
    points.push_back(on);
    points.push_back(i % 2 == 0 ? t.a : T(0.5) * (t.a + t.b));
    const T offset = std::ldexp(surface.size, -(i % 50));
    points.push_back(on + offset * random.next());
    points.push_back(std::ldexp(surface.size, i % 60) * random.next());
    points.push_back((surface.size * T(0.7)) * random.next());
  }
  return points;
}

template <typename T>
void expectAnswersOfAll(const Searched<T>& mesh, const std::vector<Vec3<T>>& points) {
  std::vector<typename Searched<T>::Nearest> together;
  for (const auto& p : points) together.push_back(mesh.surface.nothing(p));
  mesh.search.nearest(mesh.surface, std::span<const Vec3<T>>(points), std::span(together));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto expected = mesh.expected(points[i]);
    expectSame(mesh.found(points[i]), expected, points[i]);
    expectSame(together[i], expected, points[i]);
  }
}

template <typename T>
void expectAnswersOfAll(const PolygonSoup& soup, int count = scaled(60)) {
  const Searched<T> mesh(soup);
  expectAnswersOfAll(mesh, probes(mesh.surface, count));
}

/// Points in blocks, as fill() asks for them, slightly turned: their searches share most.
template <typename T>
std::vector<Vec3<T>> block(const Vec3<T>& at, T spacing) {
  std::vector<Vec3<T>> points;
  for (int n = 0; n < 130; ++n) {  // two groups, and a brick that is not full
    const auto bit = [&](int k) { return static_cast<T>(n >> k & 1); };
    const T x = bit(0) + 2 * bit(3) + 4 * bit(6);
    const T y = bit(1) + 2 * bit(4) + 4 * bit(7);
    const T z = bit(2) + 2 * bit(5);
    points.push_back(at + spacing * Vec3<T>{x - T(0.1) * y, y + T(0.1) * x, z});
  }
  return points;
}

template <typename T>
void expectAnswersInBlocks(const PolygonSoup& soup) {
  const Searched<T> mesh(soup);
  const auto places = probes(mesh.surface, 2);
  for (const auto& place : places) {
    // From blocks larger than the surface to those within its rounding.
    for (const int k : {-3, 0, 3, 5, 7, 10, 16, 30, 50}) {
      SCOPED_TRACE(k);
      expectAnswersOfAll(mesh, block(place, std::ldexp(mesh.surface.size, -k)));
    }
  }
}

template <typename T>
class TriangleSearchTest : public ::testing::Test {};
TYPED_TEST_SUITE(TriangleSearchTest, Precisions);

TYPED_TEST(TriangleSearchTest, OfSmoothSurfaces) {
  for (const int level : {0, 2, 4})
    expectAnswersOfAll<TypeParam>(tessellation::icosphere(1, level));
}

TYPED_TEST(TriangleSearchTest, OfOneTriangleAndOfAFew) {
  expectAnswersOfAll<TypeParam>(makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  expectAnswersOfAll<TypeParam>(makeSoup({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}));
  expectAnswersOfAll<TypeParam>(triangulated(cube()));
  expectAnswersOfAll<TypeParam>(randomTriangles(17, 1, 1));
}

TYPED_TEST(TriangleSearchTest, OfNeedlesAndSizesOfAllKinds) {
  expectAnswersOfAll<TypeParam>(randomTriangles(500, 1, 0.1));
  expectAnswersOfAll<TypeParam>(randomTriangles(500, 1, 3));
  expectAnswersOfAll<TypeParam>(randomTriangles(500, 1e-6, 1));  // all through one place
}

TYPED_TEST(TriangleSearchTest, OfTrianglesEquallyNear) {
  // More candidates than a search holds, all at the same distance; the lowest id wins.
  auto soup = makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {});
  for (int i = 0; i < 300; ++i) soup.addPolygon(std::array{0U, 1U, 2U});
  expectAnswersOfAll<TypeParam>(soup, 20);
  // A finely cut cylinder seen from its axis.
  expectAnswersOfAll<TypeParam>(triangulated(prism(
                                    [] {
                                      std::vector<std::pair<double, double>> circle;
                                      for (int i = 0; i < 500; ++i) {
                                        const double angle = 2 * std::numbers::pi * i / 500;
                                        circle.emplace_back(std::cos(angle), std::sin(angle));
                                      }
                                      return circle;
                                    }(),
                                    8)),
                                20);
}

TYPED_TEST(TriangleSearchTest, OfSurfacesFarFromTheOriginAndAtExtremeSizes) {
  using T = TypeParam;
  const auto changed = [](double scale, const Vec3<double>& offset) {
    auto soup = tessellation::icosphere(1, 3);
    for (auto& p : soup.points) p = scale * p + offset;
    return soup;
  };
  const double far = sizeof(T) == sizeof(float) ? 1e3 : 1e9;
  expectAnswersOfAll<T>(changed(1, {far, -far, far}));
  for (const double scale : {1e-12, 1e12}) expectAnswersOfAll<T>(changed(scale, {}));
  // Small features beside a large one: single precision has to zoom in.
  auto soup = tessellation::icosphere(1, 2);
  for (const double scale : {1e-3, 1e-6, 1e-9}) {
    const auto base = static_cast<std::uint32_t>(soup.points.size());
    const auto small = changed(scale, {0.3, 0.2, 0.1});
    soup.points.insert(soup.points.end(), small.points.begin(), small.points.end());
    for (std::size_t i = 0; i < small.polygonCount(); ++i) {
      const auto c = small.polygon(i);
      soup.addPolygon(std::array{base + c[0], base + c[1], base + c[2]});
    }
  }
  expectAnswersOfAll<T>(soup);
}

TYPED_TEST(TriangleSearchTest, OfBlocksOfPoints) {
  using T = TypeParam;
  expectAnswersInBlocks<T>(triangulated(cube()));
  expectAnswersInBlocks<T>(tessellation::icosphere(1, scaled(60) < 60 ? 2 : 3));
  expectAnswersInBlocks<T>(makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
  expectAnswersInBlocks<T>(randomTriangles(300, 1, 0.1));
  expectAnswersInBlocks<T>(randomTriangles(100, 1, 3));
}

TYPED_TEST(TriangleSearchTest, OfBlocksOfPointsAtFineSurfaces) {
  using T = TypeParam;
  // So fine that points share leaves of the tree, or none, but not triangles.
  const Searched<T> mesh(tessellation::icosphere(1, 6));
  for (const auto& place : probes(mesh.surface, scaled(4))) {
    for (const int k : {1, 3, 4, 5, 6, 8}) {
      const auto points = block(place, std::ldexp(mesh.surface.size, -k));
      std::vector<typename Searched<T>::Nearest> together;
      for (const auto& p : points) together.push_back(mesh.surface.nothing(p));
      mesh.search.nearest(mesh.surface, std::span<const Vec3<T>>(points), std::span(together));
      for (std::size_t i = 0; i < points.size(); ++i) {
        expectSame(together[i], mesh.found(points[i]), points[i]);
      }
    }
  }
}

TYPED_TEST(TriangleSearchTest, OfSliversWhosePlanesAreNearerThanTheirEdges) {
  using T = TypeParam;
  // Two plates of ribs thirty times as long as they are wide; ribs of one are above edges of the
  // other. In the middle between them planes of one are nearer than edges of the other, though
  // these are nearer than the former's edges.
  PolygonSoup soup;
  soup.patchNames = {"plates"};
  constexpr std::uint32_t kRibs = 120;
  for (const double z : {0.0, 0.2001}) {
    const auto base = static_cast<std::uint32_t>(soup.points.size());
    for (std::uint32_t i = 0; i <= kRibs; ++i) {
      for (const double y : {0.0, 1.0}) soup.points.push_back({i / 30.0 + z / 12.006, y, z});
    }
    for (std::uint32_t i = 0; i < kRibs; ++i) {
      const auto at = base + 2 * i;
      soup.addPolygon(std::array{at, at + 2, at + 1});
      soup.addPolygon(std::array{at + 1, at + 2, at + 3});
    }
  }
  const Searched<T> mesh(soup);
  const T scale = mesh.surface.scale;
  std::vector<Vec3<T>> points;
  RandomPoints<T> random(1, /*seed=*/3);
  for (int i = 0; i < scaled(400); ++i) {
    const auto p = random.next();
    const auto x = (static_cast<T>(i % 240) + T(0.1) * p.x) / 60;
    points.push_back(scale * Vec3<T>{x, T(0.5) * (p.y + 1), T(0.1) + T(1e-4) * p.z});
  }
  expectAnswersOfAll(mesh, points);
  expectAnswersInBlocks<T>(soup);
}

/// A sector of a cone about z, or of a ring where `inner` is not 0, of n slivers up to `angle`.
PolygonSoup fan(std::uint32_t n, double angle, double inner) {
  PolygonSoup soup;
  soup.patchNames = {"fan"};
  for (std::uint32_t i = 0; i <= n; ++i) {
    const double at = angle * i / n;
    for (const double r : {inner, 1.0}) {
      soup.points.push_back({r * std::cos(at), r * std::sin(at), 1 - r});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t at = 2 * i;
    const std::uint32_t tip = inner == 0 ? 0 : at;
    soup.addPolygon(std::array{tip, at + 1, at + 3});
  }
  return soup;
}

TYPED_TEST(TriangleSearchTest, OfFansOfSlivers) {
  using T = TypeParam;
  expectAnswersOfAll<T>(bipyramid(2000), scaled(20));
  expectAnswersInBlocks<T>(bipyramid(300));
  // Finer than single precision tells apart: a full circle of these would be 10^6 and more.
  for (const double angle : {0.02, 1e-4}) {
    for (const double inner : {0.0, 0.2}) {
      const Searched<T> mesh(fan(3000, angle, inner));
      EXPECT_FALSE(mesh.hulls.hulls.empty());
      auto points = probes(mesh.surface, scaled(8));
      RandomPoints<T> random(1, /*seed=*/7);
      for (int i = 0; i < scaled(60); ++i) {  // off the middle of the fan
        const auto p = random.next();
        const T r = T(0.6) + T(0.3) * p.x;
        const T at = static_cast<T>(angle) * T(0.5) * (1 + p.y);
        const T away = T(0.5) * p.z;
        const T along = r + away;
        points.push_back(mesh.surface.scale *
                         Vec3<T>{along * std::cos(at), along * std::sin(at), 1 - r + away});
      }
      expectAnswersOfAll(mesh, points);
    }
  }
}

TYPED_TEST(TriangleSearchTest, OfNoPointsAndOfFewerThanTakeTurns) {
  using T = TypeParam;
  const Searched<T> mesh(tessellation::icosphere(1, 2));
  const auto points = probes(mesh.surface, 4);
  for (std::size_t count = 0; count <= points.size(); ++count) {
    std::vector<typename Searched<T>::Nearest> bests(count);
    for (std::size_t i = 0; i < count; ++i) bests[i] = mesh.surface.nothing(points[i]);
    mesh.search.nearest(mesh.surface, std::span(points).first(count), std::span(bests));
    for (std::size_t i = 0; i < count; ++i) {
      expectSame(bests[i], mesh.expected(points[i]), points[i]);
    }
  }
}

TYPED_TEST(TriangleSearchTest, OfFlatSurfacesWhoseHeightsUnderflow) {
  using T = TypeParam;
  // Ways to the surface are so short that their squares vanish in single precision, not all of
  // their products with larger numbers.
  const double tilt = 0x1p-67;
  const Searched<T> mesh(
      makeSoup({{0, 0, 0}, {0, tilt, 0.25}, {0, 0, 0}, {0, 0, 0}, {-1, 0, 0}, {0, 0, 0}},
               {{1, 4, 3}, {1, 5, 4}, {0, 5, 2}, {1, 2, 5}}));
  std::vector<Vec3<T>> points;
  for (int n = 0; n < 128; ++n) {
    const Vec3<double> part{n % 8 / 64.0, n / 8 % 4 / 64.0, n / 32 / 64.0};
    points.emplace_back(Vec3<double>{0.5 * part.x - 1, 0.25 * tilt * part.y, part.z / 16});
  }
  expectAnswersOfAll(mesh, points);
}

}  // namespace
}  // namespace cutwater::test
