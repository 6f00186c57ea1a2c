// MeshSDF::refitted(): held against a MeshSDF made anew, to the bit.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include "Support/DamagedSoups.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RefitTest : public ::testing::Test {};
TYPED_TEST_SUITE(RefitTest, Precisions);

template <typename T, typename Motion>
std::vector<Vec3<T>> movedPoints(const PolygonSoup& soup, Motion motion) {
  std::vector<Vec3<T>> result;
  for (const auto& p : soup.points) result.push_back(static_cast<Vec3<T>>(motion(p)));
  return result;
}

template <typename T>
PolygonSoup soupAt(PolygonSoup soup, const std::vector<Vec3<T>>& positions) {
  soup.points.assign(positions.begin(), positions.end());
  return soup;
}

/// Refits a mesh of triangles, compares it with one made anew, and moves it back.
template <typename T, typename Motion>
MeshSDF<T> expectFollows(const PolygonSoup& polygons, Motion motion,
                         const MeshSDFOptions& options = {}) {
  const auto soup = triangulated(polygons);
  const MeshSDF<T> before(soup, options);
  const auto moved = movedPoints<T>(soup, motion);
  const auto after = before.refitted(moved);
  expectSame(after, MeshSDF<T>(soupAt(soup, moved), options), Trees::Different);
  expectSame(after.refitted(movedPoints<T>(soup, [](const auto& p) { return p; })), before,
             Trees::Different);
  return after;
}

Vec3<double> stretched(const Vec3<double>& p) {
  return {3 * p.x + 0.5, 0.5 * p.y - 1, 1.25 * p.z};
}

/// A beam along x bends upwards, to an arc of radius 2.
Vec3<double> bent(const Vec3<double>& p) {
  const double angle = p.x / 2;
  return {(2 - p.z) * std::sin(angle), p.y, 2 - (2 - p.z) * std::cos(angle)};
}

Vec3<double> waving(const Vec3<double>& p) {
  return p + 0.1 * Vec3<double>{std::sin(3 * p.y), std::sin(2 * p.z + 1), std::sin(4 * p.x)};
}

TYPED_TEST(RefitTest, FollowsASphereThatBecomesAnEllipsoid) {
  using T = TypeParam;
  const auto after = expectFollows<T>(tessellation::icosphere(1, 4), stretched);
  EXPECT_TRUE(after.signReport().isSound());
  EXPECT_NEAR(after.signedDistance({T(0.5), -1, 0}), T(-0.5), T(0.01));
}

TYPED_TEST(RefitTest, FollowsABeamThatBends) {
  using T = TypeParam;
  const auto beam = tessellation::box({-3, -0.25, -0.25}, {3, 0.25, 0.25}, 24);
  const auto after = expectFollows<T>(beam, bent, {.findSelfIntersections = true});
  EXPECT_TRUE(after.signReport().isSound());
  EXPECT_LT(after.signedDistance(static_cast<Vec3<T>>(bent({2.5, 0, 0}))), 0);
  EXPECT_GT(after.signedDistance({T(2.5), 0, 0}), 0);
}

TYPED_TEST(RefitTest, FollowsOpenSurfaces) {
  using T = TypeParam;
  EXPECT_FALSE(expectFollows<T>(bowl(24), waving).signReport().isClosed());
  expectFollows<T>(bowl(16), stretched, {.signs = SignScheme::NearestFeature});
  expectFollows<T>(twistedBand(60, 0.25, 1), waving);
  // A bowl pressed flat, and one turned over: what it encloses is told by its rim.
  expectFollows<T>(bowl(24), [](Vec3<double> p) { return Vec3<double>{p.x, p.y, 0.01 * p.z}; });
  expectFollows<T>(bowl(24), [](Vec3<double> p) { return Vec3<double>{p.x, p.y, -p.z}; });
}

TYPED_TEST(RefitTest, SeesShellsMeetAndLeaveEachOther) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 2);
  const auto apart = together(ball, moved(ball, {3, 0, 0}));
  const auto closer = [](const Vec3<double>& p) {
    return p.x < 1.5 ? p : p - Vec3<double>{2, 0, 0};
  };
  EXPECT_TRUE(MeshSDF<T>(apart).signReport().isSound());
  EXPECT_FALSE(expectFollows<T>(apart, closer).signReport().isSound());
  // A cavity that leaves the ball around it is a ball that stands inside out.
  const auto hollow = together(ball, insideOut(tessellation::icosphere(0.5, 2)));
  const auto leaving = [](const Vec3<double>& p) {
    return length(p) > 0.75 ? p : p + Vec3<double>{3, 0, 0};
  };
  EXPECT_EQ(MeshSDF<T>(hollow).signReport().turnedShells, 0U);
  EXPECT_EQ(expectFollows<T>(hollow, leaving).signReport().turnedShells, 1U);
  expectFollows<T>(insideOut(hollow), leaving);
}

// Three balls in a box that keeps the scale. Two meet; the third moves into the second and, when
// moved back, out of it; and the first, which meets the second, moves farther in.
TYPED_TEST(RefitTest, CountsPairsAnewWhereTrianglesMove) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 2);
  const auto three = together(together(ball, moved(ball, {1.5, 0.1, 0.2})), moved(ball, {5, 0, 0}));
  const auto all = together(three, insideOut(tessellation::box({-9, -9, -9}, {9, 9, 9}, 2)));
  const auto count = [](const MeshSDF<T>& mesh) { return mesh.signReport().selfIntersections; };
  const auto known = count(MeshSDF<T>(all));
  const auto third = expectFollows<T>(all, [](Vec3<double> p) {
    return p.x > 3.5 && p.x < 8 ? p - Vec3<double>{2, 0, 0} : p;
  });
  EXPECT_GT(count(third), known);
  const auto first = expectFollows<T>(all, [](Vec3<double> p) {
    return p.x < -0.5 && p.x > -8 ? p + Vec3<double>{0.25, 0, 0} : p;
  });
  EXPECT_EQ(count(first), known) << "the cap that moves is away from the second ball";
  const auto parted = expectFollows<T>(all, [](Vec3<double> p) {
    return length(p) < 1.001 ? p - Vec3<double>{3, 0, 0} : p;
  });
  EXPECT_LT(count(parted), known);
}

// Of balls that are apart, which is proven, only those that have moved are looked at.
TYPED_TEST(RefitTest, FindsWhereOneOfManyMovesIntoAnother) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 2);
  const auto three = together(together(ball, moved(ball, {3, 0.1, 0.2})), moved(ball, {6, 0, 0}));
  const auto all = together(three, insideOut(tessellation::box({-9, -9, -9}, {9, 9, 9}, 2)));
  const MeshSDF<T> before(all);
  ASSERT_TRUE(before.signReport().isProven);
  const auto by = [&](double way) {
    return expectFollows<T>(all,
                            [&](Vec3<double> p) {
                              return p.x > 4.5 && p.x < 8 ? p - Vec3<double>{way, 0, 0} : p;
                            })
        .signReport();
  };
  EXPECT_GT(by(2).selfIntersections, 0U);
  EXPECT_EQ(by(0.5).selfIntersections, 0U);
  EXPECT_TRUE(by(0.5).isProven);
}

TYPED_TEST(RefitTest, TurnsWhatMotionTurnsInsideOut) {
  using T = TypeParam;
  const auto mirrored = [](const Vec3<double>& p) { return Vec3<double>{-p.x, p.y, p.z}; };
  const auto ball = triangulated(tessellation::icosphere(1, 2));
  EXPECT_EQ(expectFollows<T>(ball, mirrored).signReport().turnedShells, 1U);
  EXPECT_EQ(expectFollows<T>(insideOut(ball), mirrored).signReport().turnedShells, 0U);
  EXPECT_EQ(expectFollows<T>(flipped(ball, 7), mirrored).signReport().turnedFaces, 1U);
  expectFollows<T>(onlyFaces(flipped(insideOut(ball), 9), [](std::size_t i) { return i != 4; }),
                   mirrored);
}

TYPED_TEST(RefitTest, FollowsDamagedSurfaces) {
  using T = TypeParam;
  const auto box = tessellation::box({0, 0, 0}, {1, 1, 1}, 2);
  expectFollows<T>(weldedTogether(box, moved(box, {1, 1, 0})), waving);  // four faces at an edge
  expectFollows<T>(weldedTogether(box, box), waving);                    // every face twice
  expectFollows<T>(unwelded(box), waving);
  auto unused = tessellation::box({0, 0, 0}, {1, 1, 1}, 2);
  unused.points.push_back({9, 9, 9});
  expectFollows<T>(unused, waving);
}

TYPED_TEST(RefitTest, FollowsIntoAPlaneAndIntoAPoint) {
  using T = TypeParam;
  const auto flat = [](const Vec3<double>& p) { return Vec3<double>{p.x, p.y, 0}; };
  const auto nowhere = [](const Vec3<double>&) { return Vec3<double>{1, 2, 3}; };
  const auto ball = triangulated(tessellation::icosphere(1, 1));
  EXPECT_FALSE(expectFollows<T>(ball, flat).signReport().isSound());
  expectFollows<T>(ball, nowhere);
  expectFollows<T>(bowl(16), flat);
  const MeshSDF<T> strict(ball, {.requireWatertight = true});
  const auto pressed = movedPoints<T>(ball, flat);
  EXPECT_THROW(MeshSDF<T>(soupAt(ball, pressed), {.requireWatertight = true}), Error);
  EXPECT_THROW((void)strict.refitted(pressed), Error);
}

TYPED_TEST(RefitTest, FollowsToOtherScales) {
  using T = TypeParam;
  for (const double factor : {1e-12, 1e12}) {
    expectFollows<T>(tessellation::icosphere(1, 2),
                     [factor](const Vec3<double>& p) { return factor * waving(p); });
  }
}

TYPED_TEST(RefitTest, PolygonsStayCutAsTheyAre) {
  using T = TypeParam;
  const auto quads = tessellation::torus(2, 0.5, 24, 12);
  const auto positions = movedPoints<T>(quads, waving);
  const auto after = MeshSDF<T>(quads).refitted(positions);
  const MeshSDF<T> fresh(soupAt(triangulated(quads), positions));
  std::vector<std::uint32_t> polygonOf;
  for (const auto polygon : triangulate(quads).polygons) polygonOf.push_back(polygon);
  for (const auto& p : probesOf(fresh)) {
    const auto expected = fresh.closestPoint(p);
    const auto found = after.closestPoint(p);
    EXPECT_EQ(found.distance, expected.distance) << p;
    EXPECT_EQ(found.triangle, expected.triangle) << p;
    EXPECT_EQ(found.owner.face, polygonOf[expected.owner.face]) << p;
  }
}

TYPED_TEST(RefitTest, LeavesTheOldSurfaceAndKeepsThePlacement) {
  using T = TypeParam;
  const auto soup = triangulated(tessellation::icosphere(1, 2));
  MeshSDF<T> mesh(soup);
  mesh.rotate(30, 2);
  mesh.translate({1, 2, 3});
  const auto copy = mesh;
  const auto after = mesh.refitted(movedPoints<T>(soup, stretched));
  EXPECT_EQ(after.placement(), mesh.placement());
  expectSame(mesh, copy);
  auto expected = MeshSDF<T>(soupAt(soup, movedPoints<T>(soup, stretched)));
  expected.setPlacement(mesh.placement());
  expectSame(after, expected, Trees::Different);
}

TYPED_TEST(RefitTest, RefusesWhatIsNoMotion) {
  using T = TypeParam;
  const auto soup = tessellation::icosphere(1, 1);
  const MeshSDF<T> mesh(soup);
  auto positions = movedPoints<T>(soup, [](const auto& p) { return p; });
  positions.back().y = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW((void)mesh.refitted(positions), Error);
  positions.back().y = std::numeric_limits<T>::infinity();
  EXPECT_THROW((void)mesh.refitted(positions), Error);
  positions.pop_back();
  EXPECT_THROW((void)mesh.refitted(positions), Error);
  EXPECT_THROW((void)mesh.refitted({}), Error);
}

}  // namespace
}  // namespace cutwater::test
