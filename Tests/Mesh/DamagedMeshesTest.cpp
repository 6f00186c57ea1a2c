#include "DamageChecks.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DamagedMeshesTest : public ::testing::Test {};
TYPED_TEST_SUITE(DamagedMeshesTest, Precisions);

TYPED_TEST(DamagedMeshesTest, UnweldedTriangles) {
  using T = TypeParam;
  auto soup = unwelded(sphere());
  const auto mesh = expectMesh<T>(
      soup, {.unbalancedEdges = 960, .shells = 320, .mostDoubtful = 0, .meant = ball()});
  EXPECT_LT(mesh.signedDistance({0, 0, 0}), T(-0.96));
  EXPECT_EQ(weldExactly(soup), 960U - 162U);
  expectMesh<T>(soup, {.meant = ball()});
}

TYPED_TEST(DamagedMeshesTest, JitteredCopies) {
  using T = TypeParam;
  for (const double jitter : {1e-7, 1e-5}) {
    const auto soup = jittered(unwelded(sphere()), 2 * std::sqrt(3.0) * jitter);
    expectMesh<T>(
        soup,
        {.unbalancedEdges = 960, .shells = 320, .mostDoubtful = 0.01, .meant = ball({}, 1e-3)});
  }
}

TYPED_TEST(DamagedMeshesTest, NonPlanarQuads) {
  using T = TypeParam;
  // Twisted by 90 degrees from bottom to top; no side is plane.
  const auto twisted = withPoints(tessellation::box({-1, -1, -1}, {1, 1, 1}, 4), [](const auto& p) {
    const double angle = std::numbers::pi / 4 * (p.z + 1);
    return Vec3<double>{std::cos(angle) * p.x - std::sin(angle) * p.y,
                        std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  });
  const auto meant = [](const Vec3<double>& p) -> std::optional<bool> {
    const double angle = std::numbers::pi / 4 * (p.z + 1);
    const double x = std::cos(angle) * p.x + std::sin(angle) * p.y;
    const double y = std::cos(angle) * p.y - std::sin(angle) * p.x;
    const double most = std::max(std::max(std::abs(x), std::abs(y)), std::abs(p.z));
    if (most > 0.9 && most < 1.1) return std::nullopt;
    return most < 1;
  };
  expectMesh<T>(twisted, {.meant = meant});
}

TYPED_TEST(DamagedMeshesTest, BothSidesOfAFinAreOutside) {
  using T = TypeParam;
  const auto soup = weldedTogether(
      plainBox({0, 0, 0}, {1, 1, 1}),
      makeSoup({{1, 1, 0}, {1, 1, 1}, {1.5, 1.5, 1}, {1.5, 1.5, 0}}, {{0, 1, 2}, {0, 2, 3}}));
  const auto mesh = expectMesh<T>(soup, {.unbalancedEdges = 4,
                                         .leastDoubtful = 0.005,
                                         .mostDoubtful = 0.3,
                                         .meant = boxes({{{0, 0, 0}, {1, 1, 1}}})});
  for (const T beside : {T(0x1p-18), T(0.01), T(-0.01), T(-0x1p-18)}) {
    EXPECT_GT(mesh.signedDistance({T(1.25) + beside, T(1.25) - beside, T(0.5)}), 0) << beside;
  }
}

TYPED_TEST(DamagedMeshesTest, ASmallHoleIsClosed) {
  using T = TypeParam;
  const auto soup = onlyFaces(sphere(), [](std::size_t i) { return i != 100; });
  const auto hole = middleOf(sphere(), 100);
  const auto mesh = expectMesh<T>(soup, {.unbalancedEdges = 3,
                                         .mostDoubtful = 0.02,
                                         .meant = [=](const auto& p) -> std::optional<bool> {
                                           if (length(p - hole) < 0.3) return std::nullopt;
                                           return ball()(p);
                                         }});
  EXPECT_LT(mesh.signedDistance(Vec3<T>(0.9 * hole)), 0);
  EXPECT_GT(mesh.signedDistance(Vec3<T>(1.1 * hole)), 0);
}

TYPED_TEST(DamagedMeshesTest, ALargeHoleIsClosedBySomething) {
  using T = TypeParam;
  // The 60 faces nearest to the pole.
  const auto whole = sphere();
  std::vector<double> heights;
  for (std::size_t i = 0; i < whole.polygonCount(); ++i) heights.push_back(middleOf(whole, i).z);
  std::ranges::nth_element(heights, heights.end() - 60);
  const double rim = *(heights.end() - 60);
  const auto soup = onlyFaces(whole, [&](std::size_t i) { return middleOf(whole, i).z < rim; });
  const MeshSDF<T> mesh(soup);
  EXPECT_GE(mesh.triangleCount(), 250U);
  EXPECT_LE(mesh.triangleCount(), 262U);
  expectMesh<T>(soup, {.unbalancedEdges = mesh.signReport().unbalancedEdges,
                       .leastDoubtful = 0.05,
                       .mostDoubtful = 0.5,
                       .meant = [=](const auto& p) -> std::optional<bool> {
                         // What the cap cuts off is anybody's.
                         return p.z > rim - 0.3 ? std::nullopt : ball()(p);
                       }});
}

TYPED_TEST(DamagedMeshesTest, AHemisphereIsHalfABall) {
  using T = TypeParam;
  const auto mesh =
      expectMesh<T>(bowl(24), {.unbalancedEdges = 24, .leastDoubtful = 0.3, .mostDoubtful = 0.9});
  // From the middle of the hole, at height 0, a hemisphere spans half of all directions; the sheet
  // that closes it hangs on the rim like a soap film, and here they are the same plane.
  EXPECT_LT(mesh.signedDistance({0, 0, T(-0.5)}), 0);
  EXPECT_LT(mesh.signedDistance({0, 0, T(-0.001)}), 0);
  EXPECT_GT(mesh.signedDistance({0, 0, 0}), 0);
  EXPECT_GT(mesh.signedDistance({T(0.3), T(-0.6), 0}), 0);
  EXPECT_GT(mesh.signedDistance({0, 0, T(0.001)}), 0);
  EXPECT_GT(mesh.signedDistance({0, 0, T(0.8)}), 0);
}

TYPED_TEST(DamagedMeshesTest, FlippedFacesAreTurned) {
  using T = TypeParam;
  auto soup = sphere();
  for (const std::size_t i : {3U, 77U, 78U, 200U, 201U, 202U}) soup = flipped(soup, i);
  expectMesh<T>(soup, {.turnedFaces = 6, .meant = ball()});
  expectMesh<T>(insideOut(soup), {.turnedFaces = 6, .turnedShells = 1, .meant = ball()});
}

TYPED_TEST(DamagedMeshesTest, AMeshInsideOutIsTurned) {
  using T = TypeParam;
  expectMesh<T>(insideOut(sphere()), {.turnedShells = 1, .meant = ball()});
  // Open ones, too, if they are nearly closed.
  const auto open = onlyFaces(sphere(), [](std::size_t i) { return i != 100; });
  const auto mesh = expectMesh<T>(insideOut(open),
                                  {.unbalancedEdges = 3, .turnedShells = 1, .mostDoubtful = 0.02});
  EXPECT_LT(mesh.signedDistance({0, 0, 0}), 0);
}

TYPED_TEST(DamagedMeshesTest, AMoebiusStripIsAnswered) {
  using T = TypeParam;
  const auto mesh =
      expectMesh<T>(twistedBand(48, 0.3, 1),
                    {.unbalancedEdges = 97,  // The seam is where the search for neighbours ends.
                     .turnedFaces = 47,
                     .unorientable = 1,
                     .leastDoubtful = 0.02,
                     .mostDoubtful = 0.9});
  EXPECT_GT(mesh.signedDistance({0, 0, 5}), 0);
  // Two half turns make it orientable, and no more of a solid.
  expectMesh<T>(twistedBand(48, 0.3, 2),
                {.unbalancedEdges = 96, .leastDoubtful = 0.02, .mostDoubtful = 0.9});
}

TYPED_TEST(DamagedMeshesTest, SheetsEncloseNothing) {
  using T = TypeParam;
  const auto triangle = makeSoup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  const auto one = expectMesh<T>(triangle, {.unbalancedEdges = 3, .mostDoubtful = 1});
  EXPECT_EQ(one.signedDistance({T(0.25), T(0.25), 2}), T(2));
  EXPECT_EQ(one.signedDistance({T(0.25), T(0.25), -2}), T(2));
  EXPECT_GT(one.signedDistance({T(0.25), T(0.25), T(-0.125)}), 0);

  PolygonSoup sheet =
      onlyFaces(tessellation::box({0, 0, 0}, {1, 1, 1}, 4), [](std::size_t) { return true; });
  sheet = onlyFaces(sheet, [&](std::size_t i) { return middleOf(sheet, i).z == 0; });
  const auto flat = expectMesh<T>(sheet, {.unbalancedEdges = 16, .mostDoubtful = 1});
  for (const T z : {T(-0.1), T(0.1)}) {
    EXPECT_GT(flat.signedDistance({T(0.4), T(0.3), z}), 0);
    EXPECT_GT(flat.signedDistance({T(0.5), T(0.5), T(0.001) * z}), 0);
  }
}

TYPED_TEST(DamagedMeshesTest, FacesWithoutAreaAndUnusedVertices) {
  using T = TypeParam;
  auto soup = sphere();
  soup.points.push_back({5, 5, 5});
  soup.points.push_back({-9, 0, 0});
  const auto mesh = expectMesh<T>(soup, {.meant = ball()});
  EXPECT_LE(mesh.boundingBox().upper.x, T(1.01));

  // A corner on the middle of an edge: the face beyond it is a needle without area, and closes.
  auto split = plainBox({0, 0, 0}, {1, 1, 1});
  const auto first = split.polygon(0);
  const std::array corners{first[0], first[1], first[2]};
  split.points.push_back(0.5 * (split.points[corners[0]] + split.points[corners[1]]));
  const auto middle = static_cast<std::uint32_t>(split.points.size() - 1);
  split = onlyFaces(split, [](std::size_t i) { return i != 0; });
  split.addPolygon(std::array{corners[0], middle, corners[2]});
  split.addPolygon(std::array{middle, corners[1], corners[2]});
  split.addPolygon(std::array{corners[0], corners[1], middle});
  expectMesh<T>(split, {.meant = boxes({{{0, 0, 0}, {1, 1, 1}}})});

  // Without that needle there is a hole of no area: a crack along the edge.
  split = onlyFaces(split, [&](std::size_t i) { return i + 1 < split.polygonCount(); });
  expectMesh<T>(split, {.unbalancedEdges = 3, .meant = boxes({{{0, 0, 0}, {1, 1, 1}}})});
}

}  // namespace
}  // namespace cutwater::test
