// The code of Docs/lattices.md.
#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>
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

  // An array of 20 x 20 x 4 cells, from the origin, with round ends of struts at its sides.
  const PeriodicLattice<double> core(UnitCell::bccz(), {.period = {5, 5, 8}, .count = {20, 20, 4}},
                                     0.4);
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

TEST(DocsTest, GradedLattices) {
  // [DOCS
  // Struts of 0.8 mm at the surface of a part, of 0.3 mm from 10 mm below it on.
  const Solid<double> part = Sphere<double>({0, 0, 0}, 40);
  const auto radius = Thickness<double>::byDistanceTo(part, {.start = 0.8, .end = 0.3, .over = 10});
  const PeriodicLattice<double> graded(UnitCell::octet(), {5, 5, 5}, radius);
  const Solid<double> infill = part & graded;

  // Knots at the centres of cells; and a radius of one's own, with its Lipschitz constant.
  const auto knots = Thickness<double>::byDistanceToCellCenter(0.8, 0.3);
  const auto tapered =
      Thickness<double>::by([](const Vec3<double>& p) { return 0.5 + 0.005 * p.z; },
                            {.lipschitz = 0.005, .least = 0.3, .most = 0.7});
  // DOCS]
  EXPECT_DOUBLE_EQ(graded.signedDistance({5, 0, 0}), -0.3 / 1.05);
  EXPECT_DOUBLE_EQ(graded.signedDistance({40, 0, 0}), -0.8 / 1.05);
  EXPECT_EQ(infill.guarantee().outside, Quality::LowerBound);
  EXPECT_DOUBLE_EQ(knots.at({}, {0.5, 0.5, 0.5}), 0.8);
  EXPECT_DOUBLE_EQ(tapered.at({0, 0, 20}, {}), 0.6);
}

TEST(DocsTest, ConformalLattices) {
  // [DOCS
  // A pipe along a curve: 2 cells through its wall, 16 round it, 24 along it.
  const std::vector<Vec3<double>> points{{0, 0, 0}, {0, 0, 40}, {30, 0, 60}, {60, 20, 60}};
  const Spine spine(points);
  const PipeMapping pipe({.innerRadius = 8, .outerRadius = 12, .length = spine.length()});
  const auto cells = HexahedralCells({2, 16, 24}, AlongSpine(spine, pipe))
                         .withNoise({.amplitude = 0.1, .seed = 1, .unit = NoiseUnit::ShortestEdge});
  const BeamLattice<double> wall(beamsOf(UnitCell::bcc(), cells, 0.3));
  // DOCS]
  EXPECT_EQ(cells.closed(), (std::array<bool, 3>{false, true, false}));
  EXPECT_NEAR(wall.signedDistance(cells.at({1.5, 0.5, 3.5})), -0.3, 1e-14);

  // [DOCS
  // Any mapping of the unit cube: u.x, u.y, u.z in [0, 1].
  const auto bump = [](const Vec3<double>& u) {
    const double rise = 4 * u.x * (1 - u.x) * u.y * (1 - u.y);
    return Vec3<double>{20 * u.x, 20 * u.y, 3 * u.z + 2 * rise};
  };
  const auto sheet = beamsOf(UnitCell::kelvin(), HexahedralCells({10, 10, 1}, bump),
                             Thickness<double>::byDistanceToCellCenter(0.1, 0.2));
  // DOCS]
  EXPECT_GT(sheet.beams.size(), 2400U);
}

TEST(DocsTest, LatticesWithinParts) {
  // [DOCS
  const Solid<double> part = Sphere<double>({0, 0, 0}, 20);
  auto graph = beamsOf(UnitCell::octet(), {{5, 5, 5}, {10, 10, 10}}, 0.4);
  for (auto& node : graph.nodes) node = node - Vec3<double>{25, 25, 25};
  graph = beamsWithin(graph, part);  // memory follows the part
  const Solid<double> clipped = BeamLattice<double>(graph) & part;
  // DOCS]
  EXPECT_LT(graph.beams.size(), 18000U);
  EXPECT_LT(clipped.signedDistance({0, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(clipped.signedDistance({0, 0, 30}), 10);
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
