#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Detail/Shells.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <algorithm>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

PolygonSoup cubeBetween(double lower, double upper, bool insideOut = false) {
  auto soup = triangulated(tessellation::box({lower, lower, lower}, {upper, upper, upper}));
  for (std::size_t i = 0; insideOut && i < soup.polygonCount(); ++i) {
    std::swap(soup.corners[3 * i], soup.corners[3 * i + 1]);
  }
  return soup;
}

PolygonSoup together(std::initializer_list<PolygonSoup> parts) {
  PolygonSoup all;
  all.patchNames = {"all"};
  for (const auto& part : parts) {
    const auto shift = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (std::size_t i = 0; i < part.polygonCount(); ++i) {
      const auto c = part.polygon(i);
      all.addPolygon(std::array{c[0] + shift, c[1] + shift, c[2] + shift});
    }
  }
  return all;
}

double at(const PolygonSoup& soup, double x) {
  return MeshSDF<double>(soup).signedDistance({x, x, x});
}

std::size_t turned(const PolygonSoup& soup) {
  const auto found = orientShells(DcelMesh<double>(soup));
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(found.turned, true)),
            12 * found.turnedShells());
  EXPECT_EQ(MeshSDF<double>(soup).signReport().turnedShells, found.turnedShells());
  return found.turnedShells();
}

TEST(ShellsTest, LeavesGoodSurfacesAlone) {
  EXPECT_EQ(turned(cubeBetween(0, 1)), 0U);
  EXPECT_EQ(turned(together({cubeBetween(0, 1), cubeBetween(3, 4)})), 0U);
  const auto hollow = together({cubeBetween(0, 10), cubeBetween(4, 6, true)});
  EXPECT_EQ(turned(hollow), 0U);
  EXPECT_EQ(at(hollow, 5), 1.0);   // in the cavity
  EXPECT_EQ(at(hollow, 2), -2.0);  // in the wall
}

TEST(ShellsTest, TurnsEachShellThatIsInsideOut) {
  EXPECT_EQ(turned(cubeBetween(0, 1, true)), 1U);
  EXPECT_EQ(at(cubeBetween(0, 1, true), 0.5), -0.5);
  const auto mixed = together({cubeBetween(0, 1), cubeBetween(3, 5, true), cubeBetween(7, 8)});
  EXPECT_EQ(turned(mixed), 1U);
  for (const double x : {0.5, 4.0, 7.5}) EXPECT_LT(at(mixed, x), 0);
  for (const double x : {-0.5, 2.0, 6.0}) EXPECT_GT(at(mixed, x), 0);
}

TEST(ShellsTest, TurnsCavitiesWithTheirShell) {
  const auto hollow = together({cubeBetween(0, 10, true), cubeBetween(4, 6)});
  EXPECT_EQ(turned(hollow), 2U);
  EXPECT_EQ(at(hollow, 5), 1.0);
  EXPECT_EQ(at(hollow, 2), -2.0);
}

TEST(ShellsTest, ANeighbourInTheSameBoundingBoxIsNoCavity) {
  // A ring that is inside out, and a proper cube in its hole: within its box, not within it.
  auto ring = triangulated(tessellation::torus(4, 1, 24, 12));
  for (std::size_t i = 0; i < ring.polygonCount(); ++i) {
    std::swap(ring.corners[3 * i], ring.corners[3 * i + 1]);
  }
  const auto both = together({ring, cubeBetween(-0.5, 0.5)});
  EXPECT_EQ(orientShells(DcelMesh<double>(both)).turnedShells(), 1U);
  const MeshSDF<double> mesh(both);
  EXPECT_LT(mesh.signedDistance({0, 0, 0}), 0);
  EXPECT_LT(mesh.signedDistance({4, 0, 0}), 0);
  EXPECT_GT(mesh.signedDistance({1.5, 0, 0}), 0);
}

/// The box's image under a map that mirrors: inside out, although rounding hides it.
TEST(ShellsTest, TurnsASheetOfAFewUlps) {
  auto sheet = tessellation::box({0, 0, 0}, {1, 1, 1});
  sheet.points = {{0, 0, 1},
                  {0, 0, 0x1.0000000000008p+0},
                  {0x1.f0a3b382e668dp-5, 0x1.42d550f1e0258p-8, 0x1.48f65c01743f7p+0},
                  {0x1.f0a3b382e668dp-5, 0x1.42d550f1e0258p-8, 0x1.48f65c01743efp+0},
                  {1, 0x1.999999999999ap-4, 0x1.7ac23da4d7fe4p+0},
                  {0x1.0f851d9c17334p+0, 0x1.adc6eea8b79cp-4, 0x1.c3b899a64c3d3p+0},
                  {0x1.0f851d9c17334p+0, 0x1.adc6eea8b79cp-4, 0x1.c3b899a64c3dbp+0},
                  {1, 0x1.999999999999ap-4, 0x1.7ac23da4d7fecp+0}};
  EXPECT_EQ(orientShells(DcelMesh<double>(triangulated(sheet))).turnedShells(), 1U);
}

}  // namespace
}  // namespace cutwater::test
