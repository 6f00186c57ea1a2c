#include <Cutwater/Mesh/MeshSDF.hpp>

#include <functional>
#include <random>

#include "Mesh/WindingSurfaces.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Surfaces whose signs are decided by winding numbers.
std::vector<NamedSurface> surfaces() {
  const auto open = onlyFaces(ballOf(), [](std::size_t i) { return i % 640 > 4; });
  return {
      {"balls that overlap", together(ballOf(), ballOf({0.7, 0.3, 0.2}))},
      {"nested balls", together(ballOf(), ballOf({}, 0.5))},
      {"a ball twice", together(ballOf(), ballOf())},
      {"inside out within",
       together(together(ballOf(), ballOf({}, 0.7)), insideOut(ballOf({}, 0.4)))},
      {"jittered a little", jittered(ballOf(), 0.1)},
      {"jittered much", jittered(ballOf(), 0.3)},
      {"blocks through each other",
       together(blockOf({0, 0, 0}, {1, 1, 1}), blockOf({0.4, 0.3, 0.2}, {1.6, 0.8, 0.7}))},
      {"blocks with a part of a face in common",
       weldedTogether(blockOf({0, 0, 0}, {1, 1, 1}), blockOf({1, 0.3, 0.25}, {2, 1.2, 1.5}))},
      {"blocks with an edge in common, and one across",
       together(weldedTogether(blockOf({0, 0, 0}, {1, 1, 1}), blockOf({1, 1, 0}, {2, 2, 1})),
                blockOf({-0.2, -0.2, 0.4}, {2.2, 2.2, 0.6}))},
      {"blocks with a corner in common, and one across",
       together(weldedTogether(blockOf({0, 0, 0}, {1, 1, 1}), blockOf({1, 1, 1}, {2, 2, 2})),
                blockOf({0.9, 0.9, 0.7}, {1.1, 1.1, 1.4}, 1))},
      {"a wedge within a block, in one of its corners",
       weldedTogether(makeSoup({{1, 1, 1}, {0.4, 0.6, 0.6}, {0.6, 0.4, 0.6}, {0.6, 0.6, 0.4}},
                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}),
                      blockOf({0, 0, 0}, {1, 1, 1}, 1))},
      {"sheets closer than rounding",
       together(together(ballOf(), ballOf({}, 1 + 1e-15)),
                together(ballOf({}, 1 + 4e-14), ballOf({}, 1 - 3e-13)))},
      {"a ball with holes", open},
      {"a sieve", sieveOf(ballOf(), 10)},
      {"a bowl", bowl(24)},
      {"a bowl with a ball through its cap", together(bowl(24), ballOf({0, 0.2, 0.05}, 0.5))},
      {"a bowl with a ball below its cap", together(bowl(24), ballOf({0, 0.1, -0.5}, 0.45))},
      {"a bowl upside down in a ball, with holes",
       together(sieveOf(ballOf({}, 1.5), 200), insideOut(bowl(16)))},
      {"a twisted band", twistedBand(40, 0.3, 1)},
      {"loose triangles", test::randomTriangles(200, 1, 0.4)},
  };
}

/// Calls visit(point) for points near the triangles: near, on, and within rounding of corners,
/// edges and faces.
template <typename T>
void nearTriangles(const MeshSDF<T>& mesh, int count,
                   const std::function<void(const Vec3<T>&)>& visit) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint32_t>(random() % mesh.triangleCount());
    const auto t = mesh.triangle(id);
    double b = share(random);
    double c = share(random);
    if (b + c > 1) b = 1 - b, c = 1 - c;
    if (i % 8 == 0) b = 0;            // on an edge
    if (i % 4 == 1) b = c = 0;        // on a corner
    if (i % 8 == 4) b = c = 1.0 / 3;  // in the middle
    const auto on =
        Vec3<double>(t[0]) + b * Vec3<double>(t[1] - t[0]) + c * Vec3<double>(t[2] - t[0]);
    const double size = i % 64 == 63 ? 0 : std::pow(10, -17 * share(random) * share(random));
    const Vec3<double> way{share(random) - 0.5, share(random) - 0.5, share(random) - 0.5};
    visit(Vec3<T>(on + size * way));
  }
}

template <typename T>
class FrontWindingsTest : public ::testing::Test {};
TYPED_TEST_SUITE(FrontWindingsTest, Precisions);

TYPED_TEST(FrontWindingsTest, ValuesAreThoseWithoutThem) {
  using T = TypeParam;
  for (const auto& [name, soup] : surfaces()) {
    const MeshSDF<T> mesh(soup);
    ASSERT_EQ(mesh.signReport().scheme, SignScheme::WindingNumber) << name;
    const MeshSDF<T> plain(soup,
                           {.signs = SignScheme::WindingNumber, .findSelfIntersections = false});
    int different = 0;
    nearTriangles<T>(mesh, scaled(4000), [&](const Vec3<T>& p) {
      different += mesh.signedDistance(p) == plain.signedDistance(p) ? 0 : 1;
    });
    EXPECT_EQ(different, 0) << name;
  }
}

/// Of points near triangles, the share at which the winding number is known without a way out.
template <typename T>
double shareKnown(const PolygonSoup& soup) {
  const MeshSDF<T> mesh(soup);
  const auto index = indexOf<T>(soup);
  int known = 0;
  int points = 0;
  nearTriangles<T>(mesh, scaled(2000), [&](const Vec3<T>& point) {
    const Vec3<T> p = index.surface().scale * point;
    const auto beside = index.windingBeside(p, index.nearest(p));
    ++points;
    known += beside ? 1 : 0;
    if (!beside) return;
    EXPECT_EQ(*beside, index.winding()->closedWinding(index.surface(), index.trianglesAlong(),
                                                      Vec3<double>(p)));
  });
  return static_cast<double>(known) / points;
}

TYPED_TEST(FrontWindingsTest, AreKnownAtMostPoints) {
  using T = TypeParam;
  for (const auto& [name, soup] : surfaces()) EXPECT_GT(shareKnown<T>(soup), 0.5) << name;
  // Points on corners and edges, and on the surface, are among them.
  EXPECT_GT(shareKnown<T>(together(ballOf(), ballOf({0.7, 0.3, 0.2}))), 0.85);
  EXPECT_GT(shareKnown<T>(together(ballOf(), ballOf({}, 0.5))), 0.85);
  EXPECT_GT(shareKnown<T>(bowl(48)), 0.75);
}

/// The share of triangles that are clear.
template <typename T>
double shareClear(const PolygonSoup& soup) {
  const auto index = indexOf<T>(soup);
  const auto fronts = index.block().template array<std::uint8_t>(index.layout().fronts);
  const auto clear = std::ranges::count_if(fronts, [](std::uint8_t byte) { return byte % 2 != 0; });
  return static_cast<double>(clear) / static_cast<double>(index.surface().triangles.size());
}

TYPED_TEST(FrontWindingsTest, TrianglesAreClearAwayFromContacts) {
  using T = TypeParam;
  EXPECT_EQ(shareClear<T>(ballOf()), 0);  // sound: nothing is kept
  EXPECT_EQ(shareClear<T>(together(ballOf(), ballOf({}, 0.5))), 1);
  EXPECT_EQ(shareClear<T>(together(ballOf(), ballOf())), 0);
  EXPECT_EQ(shareClear<T>(unwelded(ballOf())), 0);
  EXPECT_EQ(shareClear<T>(together(ballOf(), ballOf({}, 1 + 1e-15))), 0);
  const double overlapping = shareClear<T>(together(ballOf(), ballOf({0.7, 0.3, 0.2})));
  EXPECT_GT(overlapping, 0.6);
  EXPECT_LT(overlapping, 0.9);
  // Blocks of 192 triangles. All triangles at the edge are not clear: four faces of 8 * 4 * 2, of
  // which those in the first two rows, with two corners more at each end.
  const auto edge = weldedTogether(blockOf({0, 0, 0}, {1, 1, 1}), blockOf({1, 1, 0}, {2, 2, 1}));
  const double atEdge = shareClear<T>(together(edge, blockOf({-5, -5, -5}, {5, 5, 5})));
  EXPECT_GT(atEdge, 0.8);
  EXPECT_LT(atEdge, 1);
}

/// The winding number of triangles in front of which it is too large for a byte is found otherwise.
TYPED_TEST(FrontWindingsTest, ManyShellsAreCounted) {
  using T = TypeParam;
  PolygonSoup shells;
  for (int i = 0; i < 70; ++i) shells = together(shells, ballOf({}, 1 + i, 0));
  const MeshSDF<T> mesh(shells);
  EXPECT_LT(mesh.signedDistance({0, 0, T(0.1)}), 0);
  EXPECT_LT(mesh.signedDistance({0, 0, T(40)}), 0);
  EXPECT_GT(mesh.signedDistance({0, 0, T(71)}), 0);
  const auto index = indexOf<T>(shells);
  const Vec3<T> p = index.surface().scale * Vec3<T>{0, 0, T(0.1)};
  EXPECT_EQ(index.windingBeside(p, index.nearest(p)), std::nullopt);
}

}  // namespace
}  // namespace cutwater::test
