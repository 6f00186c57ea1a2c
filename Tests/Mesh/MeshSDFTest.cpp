#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class MeshSDFTest : public ::testing::Test {};
TYPED_TEST_SUITE(MeshSDFTest, Precisions);

/// Both ways to ask, which must agree to the bit.
template <typename T>
class Both {
 public:
  explicit Both(const PolygonSoup& soup) : tree_(soup), brute_(DcelMesh<T>(soup)) {}

  T signedDistance(const Vec3<T>& p) const {
    const T distance = tree_.signedDistance(p);
    EXPECT_EQ(distance, brute_.signedDistance(p)) << p;
    return distance;
  }
  const MeshSDF<T>& tree() const { return tree_; }

 private:
  MeshSDF<T> tree_;
  DcelSDF<T> brute_;
};

/// The largest difference between a mesh and the solid it stands for, within `extent`.
double worstError(const PolygonSoup& soup, const SignedDistanceFunction<double>& solid,
                  double extent) {
  const MeshSDF<double> mesh(soup);
  RandomPoints<double> random(extent);
  double worst = 0;
  for (int i = 0; i < scaled(10'000); ++i) {
    const auto p = random.next();
    worst = std::max(worst, std::abs(mesh.signedDistance(p) - solid.signedDistance(p)));
  }
  return worst;
}

TYPED_TEST(MeshSDFTest, FlatFacedSolidsAreExact) {
  using T = TypeParam;
  const Both<T> mesh(tessellation::box({-1, -2, -3}, {3, 1, 2}, 3));
  const Cuboid<T> solid({-1, -2, -3}, {3, 1, 2});
  RandomPoints<T> random(5);
  for (int i = 0; i < scaled(2'000); ++i) {
    const auto p = random.next();
    EXPECT_NEAR(mesh.signedDistance(p), solid.signedDistance(p), tolerance<T>(5)) << p;
  }
  // On faces, edges and vertices, where the sign could go either way: exactly +0.
  for (const Vec3<T> p : {Vec3<T>{3, 0, 0}, Vec3<T>{3, 1, 0}, Vec3<T>{3, 1, 2}}) {
    EXPECT_EQ(mesh.signedDistance(p), T(0));
    EXPECT_FALSE(std::signbit(mesh.signedDistance(p)));
  }
}

TEST(MeshSDFConvergenceTest, CurvedSolidsConvergeAtSecondOrder) {
  const Sphere<double> sphere({0, 0, 0}, 1);
  const Torus<double> torus(2, 0.7);
  const double sphereErrors[] = {worstError(tessellation::icosphere(1, 2), sphere, 1.5),
                                 worstError(tessellation::icosphere(1, 3), sphere, 1.5),
                                 worstError(tessellation::icosphere(1, 4), sphere, 1.5)};
  const double torusErrors[] = {worstError(tessellation::torus(2, 0.7, 32, 16), torus, 3),
                                worstError(tessellation::torus(2, 0.7, 64, 32), torus, 3),
                                worstError(tessellation::torus(2, 0.7, 128, 64), torus, 3)};
  for (const auto* errors : {sphereErrors, torusErrors}) {
    for (int i = 0; i < 2; ++i) {
      const double order = std::log2(errors[i] / errors[i + 1]);
      EXPECT_NEAR(order, 2, 0.25) << errors[i] << " -> " << errors[i + 1];
    }
  }
  EXPECT_LT(sphereErrors[2], 0.005);
}

TEST(MeshSDFConvergenceTest, CapsulesAndConesStayWithinTheSagOfTheirChords) {
  const double sag = 1 - std::cos(3.14159265358979 / 128);
  const auto capsule = tessellation::capsule(1, 2, 128, 32);
  EXPECT_LT(worstError(capsule, Capsule<double>({0, 0, 0}, {0, 0, 2}, 1), 3), 2 * sag);
  const auto cone = tessellation::cone(1, 2, 128);
  EXPECT_LT(worstError(cone, Cone<double>({0, 0, 2}, {0, 0, 0}, 1), 3), sag);
}

TYPED_TEST(MeshSDFTest, ClosestPointTellsFaceFeatureBarycentricsAndPatch) {
  using T = TypeParam;
  auto soup = tessellation::box({0, 0, 0}, {2, 2, 2});  // six quads
  soup.patchNames = {"sides", "top"};
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    bool isTop = true;
    for (const auto v : soup.polygon(i)) isTop = isTop && soup.points[v].z == 2;
    soup.patches[i] = isTop ? 1 : 0;
  }
  const MeshSDF<T> mesh(soup);
  EXPECT_EQ(mesh.triangleCount(), 12U);
  EXPECT_EQ(mesh.patchNames(), soup.patchNames);

  const auto face = mesh.closestPoint({T(0.5), T(0.75), 3});
  EXPECT_EQ(face.distance, T(1));
  EXPECT_EQ(face.feature, Feature::Face);
  EXPECT_EQ(face.owner.patch, 1U);
  EXPECT_EQ(soup.patches[face.owner.face], 1U);
  EXPECT_TRUE(face.exact);
  EXPECT_LE(length(face.point - Vec3<T>{T(0.5), T(0.75), 2}), tolerance<T>(2));
  EXPECT_EQ(face.normal, (Vec3<T>{0, 0, 1}));
  const auto [a, b, c] = mesh.triangle(face.triangle);
  const auto& w = face.barycentric;
  EXPECT_LE(length(w.x * a + w.y * b + w.z * c - face.point), tolerance<T>(2));

  const auto edge = mesh.closestPoint({3, T(0.5), 3});
  EXPECT_EQ(edge.feature, Feature::Edge);
  EXPECT_LE(length(edge.normal - normalized(Vec3<T>{1, 0, 1})), tolerance<T>(1));
  const auto vertex = mesh.closestPoint({3, 3, 3});
  EXPECT_EQ(vertex.feature, Feature::Vertex);
  EXPECT_EQ(vertex.point, (Vec3<T>{2, 2, 2}));
  EXPECT_LE(length(vertex.normal - normalized(Vec3<T>{1, 1, 1})), tolerance<T>(1));
}

TYPED_TEST(MeshSDFTest, CrossingsAlternateAndKnowTheirFaces) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::torus(2, T(0.5), 64, 32));
  std::vector<T> positions;
  bool entering = true;
  const auto count =
      mesh.crossings({{-4, T(0.1), T(0.1)}, {4, T(0.1), T(0.1)}}, [&](const Crossing<T>& c) {
        EXPECT_EQ(c.entering, entering);
        EXPECT_NE(c.owner.face, kNone);
        entering = !entering;
        positions.push_back(c.point.x);
        return true;
      });
  EXPECT_EQ(count.found, 4U);
  ASSERT_EQ(positions.size(), 4U);
  EXPECT_NEAR(positions[0], -2.49, 0.02);
  EXPECT_NEAR(positions[1], -1.51, 0.02);
  EXPECT_NEAR(positions[3], 2.49, 0.02);
}

TYPED_TEST(MeshSDFTest, IsRightAtAnySizeAndFarFromTheOrigin) {
  using T = TypeParam;
  const auto soup = tessellation::icosphere(1, 3);
  const MeshSDF<T> mesh(soup);
  const T exponents[] = {T(-20), T(20)};
  for (const T exponent : exponents) {
    auto scaledSoup = soup;
    const T factor = std::ldexp(T(1), static_cast<int>(exponent) * 3);  // about 1e-18, 1e18
    for (auto& p : scaledSoup.points) p = Vec3<double>(factor * Vec3<T>(p));
    const MeshSDF<T> other(scaledSoup);
    RandomPoints<T> random(2);
    for (int i = 0; i < 500; ++i) {
      const auto p = random.next();
      ASSERT_EQ(other.signedDistance(factor * p), factor * mesh.signedDistance(p)) << p;
    }
  }
  auto farSoup = soup;
  const double far = sizeof(T) == sizeof(float) ? 1e3 : 1e8;
  for (auto& p : farSoup.points) p += Vec3<double>{far, -far, far};
  const MeshSDF<T> farMesh(farSoup);
  const Vec3<T> shift{T(far), T(-far), T(far)};
  EXPECT_NEAR(farMesh.signedDistance(shift), mesh.signedDistance({0, 0, 0}), tolerance<T>(T(far)));
  EXPECT_NEAR(farMesh.signedDistance(shift + Vec3<T>{3, 0, 0}), mesh.signedDistance({3, 0, 0}),
              tolerance<T>(T(far)));
}

TYPED_TEST(MeshSDFTest, MovesLikeAnyShapeAndSharesItsMemory) {
  using T = TypeParam;
  const MeshSDF<T> mesh(tessellation::box({0, 0, 0}, {1, 2, 3}));
  Solid<T> moved = mesh;
  moved.rotate(90, 2);
  moved.translate({10, 0, 0});
  EXPECT_NEAR(moved.signedDistance({9, T(0.5), 1}), T(-0.5), tolerance<T>(10));
  EXPECT_NEAR(mesh.signedDistance({2, 1, 1}), T(1), tolerance<T>(3));
}

TYPED_TEST(MeshSDFTest, RefusesWhatIsNotWatertightIfAskedToAndSaysWhy) {
  using T = TypeParam;
  auto open = tessellation::box({0, 0, 0}, {1, 1, 1});
  open.offsets.pop_back();
  open.corners.resize(open.offsets.back());
  open.patches.pop_back();
  try {
    const MeshSDF<T> mesh(open, {.requireWatertight = true});
    FAIL() << "an open box was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Topology);
    EXPECT_NE(std::string(error.what()).find("4 open edges"), std::string::npos) << error.what();
  }
  EXPECT_THROW(MeshSDF<T>(PolygonSoup{}), Error);
}

TYPED_TEST(MeshSDFTest, RefusesPatchNamesThatWouldEndEarly) {
  using T = TypeParam;
  auto soup = tessellation::box({0, 0, 0}, {1, 1, 1});
  soup.patchNames = {"", std::string("a\0b", 3)};
  try {
    const MeshSDF<T> mesh(soup);
    FAIL() << "taken as " << mesh.patchNames().size() << " names";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Argument);
    EXPECT_NE(std::string(error.what()).find("patch = 1"), std::string::npos) << error.what();
  }
  EXPECT_THROW(MeshSDF<T>{DcelMesh<T>(soup)}, Error);
}

// In single precision squares of such lengths overflow; the surface is scaled before.
TYPED_TEST(MeshSDFTest, AnswersForCoordinatesUpToTheLargestNumbers) {
  using T = TypeParam;
  for (const T size : {T(0x1p40), T(0x1p64), T(0x1p100), T(0x1p126)}) {
    const auto length = static_cast<double>(size);
    const MeshSDF<T> mesh(tessellation::box({0, 0, 0}, {length, length, length}));
    EXPECT_EQ(mesh.signedDistance({size / 2, size / 2, size / 4}), -size / 4);
    const auto hit = mesh.closestPoint({size / 2, size / 2, size * T(1.5)});
    EXPECT_EQ(hit.distance, size / 2);
    EXPECT_EQ(hit.point, (Vec3<T>{size / 2, size / 2, size}));
    EXPECT_LT(hit.triangle, mesh.triangleCount());
  }
}

TYPED_TEST(MeshSDFTest, IgnoresFacesWithRepeatedCorners) {
  using T = TypeParam;
  auto soup = tessellation::box({0, 0, 0}, {1, 1, 1});
  const auto first = soup.corners[0];
  const auto second = soup.corners[1];
  soup.addPolygon(std::array{first, second, first});
  soup.addPolygon(std::array{first, first, first});
  EXPECT_EQ(MeshSDF<T>(soup).signedDistance({3, T(0.5), T(0.5)}), T(2));
}

PolygonSoup boxWithoutLid() {
  auto open = tessellation::box({0, 0, 0}, {1, 1, 1});
  PolygonSoup result;
  result.points = open.points;
  for (std::size_t i = 0; i < open.polygonCount(); ++i) {
    const auto isAbove = [&](std::uint32_t v) { return open.points[v].z == 1; };
    if (!std::ranges::all_of(open.polygon(i), isAbove)) result.addPolygon(open.polygon(i));
  }
  return result;
}

TYPED_TEST(MeshSDFTest, TheGradientPointsAwayFromOpenSurfaces) {
  using T = TypeParam;
  PolygonSoup square;
  square.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.addPolygon(std::array{0U, 1U, 2U, 3U});
  const MeshSDF<T> sheet(square);  // everywhere outside
  EXPECT_EQ(sheet.gradient({T(0.5), T(0.25), -2}), (Vec3<T>{0, 0, -1}));
  EXPECT_EQ(sheet.gradient({T(0.5), T(0.25), 2}), (Vec3<T>{0, 0, 1}));
  EXPECT_EQ(sheet.gradient({T(0.5), T(0.25), 0}), (Vec3<T>{0, 0, 1}));
  const MeshSDF<T> mesh(boxWithoutLid());
  const Vec3<T> beside = normalized(Vec3<T>{2, 0, 1});
  EXPECT_LE(length(mesh.gradient({3, T(0.5), 2}) - beside), tolerance<T>(1));
  const Vec3<T> within{T(0.5), T(0.5), T(0.125)};
  EXPECT_LT(mesh.signedDistance(within), 0);
  EXPECT_EQ(mesh.gradient(within), (Vec3<T>{0, 0, -1}));
}

TYPED_TEST(MeshSDFTest, BehindAnOpenSurfaceByTheNearestFeatureIsNoBound) {
  using T = TypeParam;
  PolygonSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.addPolygon(std::array{0U, 1U, 2U});
  const MeshSDF<T> mesh(triangle, {.signs = SignScheme::NearestFeature});
  const Vec3<T> behind{T(0.25), T(0.25), -5};
  EXPECT_EQ(mesh.signedDistance(behind), T(-5));
  EXPECT_TRUE(mesh.boundingBox().contains(behind));
  EXPECT_TRUE(MeshSDF<T>::view(mesh.toBytes()).boundingBox().contains(behind));
  EXPECT_EQ(mesh.surfaceBox(), (Box<T>{{0, 0, 0}, {1, 1, 0}}));
}

TYPED_TEST(MeshSDFTest, CanBeSignedByNearestWithoutBeingMadeAnew) {
  using T = TypeParam;
  MeshSDF<T> mesh(boxWithoutLid());
  ASSERT_EQ(mesh.signReport().scheme, SignScheme::WindingNumber);
  mesh.translate({T(0.5), 0, T(0.25)});
  const auto nearest = mesh.signedByNearest();
  MeshSDF<T> anew(boxWithoutLid(), {.signs = SignScheme::NearestFeature});
  anew.setPlacement(mesh.placement());
  EXPECT_EQ(nearest.signReport().scheme, SignScheme::NearestFeature);
  EXPECT_EQ(nearest.signReport().unbalancedEdges, mesh.signReport().unbalancedEdges);
  EXPECT_EQ(nearest.boundingBox(), anew.boundingBox());
  EXPECT_EQ(nearest.guarantee().outside, anew.guarantee().outside);
  RandomPoints<T> random(2);
  std::size_t others = 0;
  for (int i = 0; i < scaled(2000); ++i) {
    const auto p = random.next();
    const T distance = nearest.signedDistance(p);
    ASSERT_EQ(distance, anew.signedDistance(p)) << p;
    ASSERT_EQ(std::abs(distance), std::abs(mesh.signedDistance(p))) << p;
    others += (distance < 0) != (mesh.signedDistance(p) < 0) ? 1 : 0;  // before the hole
  }
  EXPECT_GT(others, 0U);
  EXPECT_EQ(mesh.signReport().scheme, SignScheme::WindingNumber);
}

}  // namespace
}  // namespace cutwater::test
