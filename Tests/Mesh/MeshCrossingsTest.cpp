#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MeshCrossingsTest : public ::testing::Test {};
TYPED_TEST_SUITE(MeshCrossingsTest, Precisions);

template <typename T>
std::vector<Crossing<T>> crossingsOf(const SignedDistanceFunction<T>& solid,
                                     const Segment<T>& segment) {
  std::vector<Crossing<T>> found;
  const auto count = solid.crossings(segment, [&](const Crossing<T>& c) {
    found.push_back(c);
    return true;
  });
  EXPECT_EQ(count.found, found.size());
  return found;
}

/// Ordered, alternating, and consistent with the signs at the ends.
template <typename T>
void expectConsistent(const SignedDistanceFunction<T>& solid, const Segment<T>& segment) {
  const auto found = crossingsOf(solid, segment);
  bool inside = solid.signedDistance(segment.start) < 0;
  T last = 0;
  for (const auto& c : found) {
    ASSERT_GE(c.parameter, last);
    ASSERT_LE(c.parameter, T(1));
    ASSERT_EQ(c.entering, !inside) << segment.start << segment.end;
    inside = !inside;
    last = c.parameter;
  }
  ASSERT_EQ(inside, solid.signedDistance(segment.end) < 0) << segment.start << segment.end;
}

/// Without the top of its box.
PolygonSoup withoutLid(const PolygonSoup& soup) {
  double top = -Box<double>::kMost;
  for (const auto& p : soup.points) top = std::max(top, p.z);
  PolygonSoup open;
  open.points = soup.points;
  open.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    if (!std::ranges::all_of(corners, [&](auto c) { return soup.points[c].z == top; })) {
      open.addPolygon(corners, soup.patches[i]);
    }
  }
  return open;
}

TYPED_TEST(MeshCrossingsTest, TellsWhereAndWhichFace) {
  using T = TypeParam;
  const MeshSDF<T> box(tessellation::box({-1, -1, -1}, {1, 1, 1}));
  const auto found = crossingsOf<T>(box, {{-3, T(0.25), T(0.5)}, {5, T(0.25), T(0.5)}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].parameter, T(0.25));
  EXPECT_EQ(found[1].parameter, T(0.5));
  EXPECT_EQ(found[0].point, (Vec3<T>{-1, T(0.25), T(0.5)}));
  EXPECT_EQ(found[0].normal, (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(found[1].normal, (Vec3<T>{1, 0, 0}));
  EXPECT_TRUE(found[0].entering);
  EXPECT_NE(found[0].owner.face, found[1].owner.face);
}

TYPED_TEST(MeshCrossingsTest, ThroughVerticesAlongEdgesAndInFaces) {
  using T = TypeParam;
  const MeshSDF<T> box(tessellation::box({0, 0, 0}, {2, 2, 2}, 2));
  EXPECT_EQ(crossingsOf<T>(box, {{-1, -1, -1}, {3, 3, 3}}).size(), 2U);  // corner to corner
  EXPECT_EQ(crossingsOf<T>(box, {{-1, 1, 1}, {3, 1, 1}}).size(),
            2U);  // through vertices inside faces
  EXPECT_EQ(crossingsOf<T>(box, {{1, 1, 1}, {3, 3, 3}}).size(), 1U);
  // On the surface counts as outside, so a segment that stays on it crosses nothing or twice.
  for (const Segment<T>& grazing :
       {Segment<T>{{-1, 0, 0}, {3, 0, 0}}, Segment<T>{{-1, 1, 2}, {3, 1, 2}},
        Segment<T>{{-1, T(0.5), 0}, {3, T(0.5), 0}}, Segment<T>{{-1, 1, 1}, {1, -1, 1}}}) {
    expectConsistent<T>(box, grazing);
    EXPECT_EQ(crossingsOf<T>(box, grazing).size() % 2, 0U);
  }
}

TYPED_TEST(MeshCrossingsTest, EverySegmentOfALatticeIsConsistent) {
  using T = TypeParam;
  auto soup = tessellation::box({0, 0, 0}, {3, 3, 3});
  soup = together(soup, flipped(tessellation::box({4, 0, 0}, {6, 2, 4}), 0));
  const MeshSDF<T> boxes(soup);
  std::mt19937 engine(2);
  const auto lattice = [&] {
    return Vec3<T>{T(int(engine() % 9) - 1), T(int(engine() % 6) - 1), T(int(engine() % 6) - 1)};
  };
  for (int i = 0; i < scaled(5'000); ++i) expectConsistent<T>(boxes, {lattice(), lattice()});
}

TYPED_TEST(MeshCrossingsTest, RandomSegmentsAgreeWithASphere) {
  using T = TypeParam;
  const MeshSDF<T> sphere(tessellation::icosphere(1, 4));
  const DcelSDF<T> plain{DcelMesh<T>(tessellation::icosphere(1, 4))};
  RandomPoints<T> random(2);
  for (int i = 0; i < 300; ++i) {
    const Segment<T> segment{random.next(), random.next()};
    expectConsistent<T>(sphere, segment);
    const auto found = crossingsOf<T>(sphere, segment);
    for (const auto& c : found) {
      EXPECT_NEAR(length(c.point), 1, 0.005);
      EXPECT_GT(dot(c.normal, c.point), T(0.99));
    }
    if (i % 10 != 0) continue;
    EXPECT_EQ(found.size(), crossingsOf<T>(plain, segment).size());
  }
}

TYPED_TEST(MeshCrossingsTest, OverlapsAreNoSurface) {
  using T = TypeParam;
  const MeshSDF<T> both(
      together(tessellation::box({0, 0, 0}, {2, 1, 1}), tessellation::box({1, 0, 0}, {3, 1, 1})));
  const auto found = crossingsOf<T>(both, {{-1, T(0.3), T(0.4)}, {4, T(0.3), T(0.4)}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].point.x, 0, 1e-6);
  EXPECT_NEAR(found[1].point.x, 3, 1e-6);
}

TYPED_TEST(MeshCrossingsTest, AHoleIsClosedByTheSheetOfHalf) {
  using T = TypeParam;
  // A box without lid at z = 1; along its axis half is reached exactly in the lid's plane.
  const MeshSDF<T> mesh(withoutLid(tessellation::box({-1, -1, -1}, {1, 1, 1})));
  ASSERT_FALSE(mesh.guarantee().continuous);
  const Segment<T> through{{T(0.1), T(0.2), -2}, {T(0.1), T(0.2), 2}};
  expectConsistent<T>(mesh, through);
  const auto found = crossingsOf<T>(mesh, through);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].point.z, -1, 1e-6);
  EXPECT_NEAR(found[1].point.z, 1, 0.01);
  EXPECT_GT(found[1].normal.z, T(0.9));
  RandomPoints<T> random(2);
  for (int i = 0; i < 100; ++i) expectConsistent<T>(mesh, {random.next(), random.next()});
}

TYPED_TEST(MeshCrossingsTest, StopsWhenToldAndAllowsForFarEnds) {
  using T = TypeParam;
  const MeshSDF<T> sphere(tessellation::icosphere(100, 2));
  int visits = 0;
  const auto count = sphere.crossings({{-200, 0, 0}, {200, 0, 0}}, [&](const Crossing<T>&) {
    ++visits;
    return false;
  });
  EXPECT_EQ(visits, 1);
  EXPECT_EQ(count.found, 1U);
  const T far = std::ldexp(T(1), 70);
  const auto found = crossingsOf<T>(sphere, {{T(10), 0, 0}, {far, 0, 0}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].parameter * far, 90, 10);
  EXPECT_NEAR(found[0].point.x, 100, 10);
  EXPECT_NEAR(sphere.signedDistance({far, far, 0}) / far, std::sqrt(2.0), 1e-6);
  EXPECT_EQ(crossingsOf<T>(sphere, {{0, 0, 0}, {0, 0, 0}}).size(), 0U);
}

TYPED_TEST(MeshCrossingsTest, OpenMeshesMissNoWall) {
  using T = TypeParam;
  const double far = sizeof(T) == sizeof(float) ? 100 : 1e7;
  for (const double offset : {0.0, far}) {
    const Vec3<T> origin{T(offset), T(offset), T(offset)};
    const Vec3<double> corner(origin);
    const MeshSDF<T> mesh(withoutLid(tessellation::box(corner, corner + Vec3<double>{1, 1, 1})));
    RandomPoints<T> random(1);
    for (int i = 0; i < 200; ++i) {
      const Vec3<T> a = random.next();
      const Vec3<T> b = random.next();
      const Segment<T> segment{origin + Vec3<T>{T(-1.5), T(0.5), T(0.2)} + T(0.1) * a,
                               origin + Vec3<T>{T(2.5), T(0.5), T(0.2)} + T(0.1) * b};
      expectConsistent<T>(mesh, segment);
      const auto found = crossingsOf<T>(mesh, segment);
      ASSERT_EQ(found.size(), 2U) << segment.start << segment.end;
      EXPECT_LT(found[0].normal.x, T(-0.999));
      EXPECT_GT(found[1].normal.x, T(0.999));
      EXPECT_NE(found[0].owner.face, found[1].owner.face);
    }
  }
}

TYPED_TEST(MeshCrossingsTest, ThinPlatesBesideAnOpenTriangle) {
  using T = TypeParam;
  // Each thinner than any point beside them can be told from them.
  const double thickness = sizeof(T) == sizeof(float) ? 1e-6 : 1e-14;
  auto soup = tessellation::box({1, 0, 0}, {1 + thickness, 1, 1});
  for (const double x : {2.0, 2.5}) {
    soup = together(soup, tessellation::box({x, 0, 0}, {x + thickness, 1, 1}));
  }
  soup = together(soup, makeSoup({{0, 9, 0}, {1, 9, 0}, {0, 9.5, 0}}, {{0, 1, 2}}));
  const MeshSDF<T> mesh(soup);
  std::size_t found = 0;
  const auto count = mesh.crossings({{T(-0.3), T(0.3), T(0.4)}, {T(3.2), T(0.7), T(0.6)}},
                                    [&](const Crossing<T>& c) {
                                      EXPECT_GT(std::abs(c.normal.x), T(0.999));
                                      EXPECT_EQ(c.entering, found % 2 == 0);
                                      ++found;
                                      return true;
                                    });
  EXPECT_EQ(found, 6U);
  EXPECT_EQ(count.unresolved, 0U);
}

TYPED_TEST(MeshCrossingsTest, InThePlaneOfAHoleRoundingCrossesNothing) {
  using T = TypeParam;
  const auto tray = withoutLid(tessellation::box({0, 0, 0}, {1, 1, T(0.7)}));
  const MeshSDF<T> mesh(tray);
  RandomPoints<T> random(3);
  for (int i = 0; i < 100; ++i) {
    const auto a = random.next();
    const auto b = random.next();
    EXPECT_EQ(crossingsOf<T>(mesh, {{T(-0.5), a.y, T(0.7)}, {T(1.5), b.y, T(0.7)}}).size(), 0U);
  }
}

TYPED_TEST(MeshCrossingsTest, FarEndsDoNotMoveTheLine) {
  using T = TypeParam;
  for (const auto& soup : {tessellation::box({0.5, 0.5, 0.5}, {1, 1, 1}),
                           withoutLid(tessellation::box({0.5, 0.5, 0.5}, {1, 1, 1}))}) {
    const MeshSDF<T> box(soup);
    for (const int exponent : {10, 30, 62, 90, 125}) {
      const T far = std::ldexp(T(1), exponent);
      for (const Segment<T>& segment :
           {Segment<T>{{-far, T(0.75), T(0.625)}, {far, T(0.75), T(0.625)}},
            Segment<T>{{-far, -far, T(0.625)}, {far, far, T(0.625)}}}) {
        expectConsistent<T>(box, segment);
        const auto found = crossingsOf<T>(box, segment);
        ASSERT_EQ(found.size(), 2U) << segment.start << segment.end;
        EXPECT_NEAR(found[0].point.x, 0.5, 1e-6);
        EXPECT_NEAR(found[1].point.x, 1, 1e-6);
        EXPECT_EQ(found[0].point.z, T(0.625));
      }
      const auto one = crossingsOf<T>(box, {{T(0.75), T(0.75), T(0.625)}, {far, far, far}});
      EXPECT_EQ(one.size(), 1U);
    }
  }
}

TYPED_TEST(MeshCrossingsTest, ASegmentWithoutLengthHasNone) {
  using T = TypeParam;
  const auto torus = tessellation::torus(1, 0.375, 8, 6);
  PolygonSoup open;
  open.points = torus.points;
  open.patchNames = torus.patchNames;
  for (std::size_t i = 7; i < torus.polygonCount(); ++i) open.addPolygon(torus.polygon(i));
  for (const auto signs : {SignScheme::NearestFeature, SignScheme::WindingNumber}) {
    MeshSDF<T> mesh(open, {.signs = signs});
    mesh.rotate(T(33), 2);
    for (const auto& vertex : open.points) {
      const auto p = mesh.placement().toWorld(Vec3<T>(vertex));
      EXPECT_EQ(crossingsOf<T>(mesh, {p, p}).size(), 0U);
      for (const auto& c : crossingsOf<T>(mesh, {p, {}})) EXPECT_NEAR(length(c.normal), 1, 1e-6);
    }
  }
}

}  // namespace
}  // namespace cutwater::test
