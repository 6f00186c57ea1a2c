// The code of Docs/lattices.md.
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellArray.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(DocsTest, LatticesWithoutMemory) {
  // [DOCS
  // Octet trusses of 5 mm in all of space, with struts of 0.4 mm; a ball of it.
  const PeriodicLattice<double> octet(UnitCell::octet(), {5, 5, 5}, 0.4);
  const Solid<double> ball = Sphere<double>({0, 0, 0}, 40) & octet;

  // A block of 20 x 20 x 4 cells, from the origin, with its ends as the struts have them.
  const CellArray<double> core(UnitCell::bccz(), {.period = {5, 5, 8}, .count = {20, 20, 4}}, 0.4);
  // DOCS]
  EXPECT_DOUBLE_EQ(ball.signedDistance({50, 0, 0}), 10);
  EXPECT_DOUBLE_EQ(octet.signedDistance({5, 0, 0}), -0.4);
  EXPECT_DOUBLE_EQ(core.signedDistance({-3, 0, 0}), 2.6);
}

TEST(DocsTest, CellsOfOnesOwn) {
  // [DOCS
  const std::vector<Vec3<double>> nodes{
      {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}};
  const std::vector<std::array<std::uint32_t, 2>> struts{{0, 1}, {0, 2}, {0, 3}, {0, 4}};
  const UnitCell cell("mine", nodes, struts);
  const double length = cell.lengthPerCell();    // 3 + sqrt(3) / 2
  const CellFold fold = cell.foldAt({1, 1, 1});  // None: one diagonal of eight is no mirror image
  // DOCS]
  EXPECT_DOUBLE_EQ(length, 3 + std::sqrt(0.75));
  EXPECT_EQ(fold, CellFold::None);
}

TEST(DocsTest, AnyGraphOfBeams) {
  // [DOCS
  BeamGraph graph;
  graph.nodes = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
  graph.beams.push_back({.nodes = {0, 1}, .radii = {1, 0.5}});  // the hull of two balls
  graph.beams.push_back({.nodes = {1, 2},
                         .radii = {0.5, 0.5},
                         .body = BeamBody::Frustum,
                         .caps = {BeamCap::Hemisphere, BeamCap::Butt}});
  graph.balls.push_back({.node = 2, .radius = 0.8});
  const BeamLattice<double> frame(graph);
  const auto nearest = frame.closestPoint({10, 5, 3});
  const std::uint32_t beam = nearest.owner.face;  // 1: the second beam
  // DOCS]
  EXPECT_EQ(beam, 1U);
  EXPECT_EQ(nearest.point, (Vec3<double>{10, 5, 0.5}));
}

}  // namespace
}  // namespace cutwater::test
