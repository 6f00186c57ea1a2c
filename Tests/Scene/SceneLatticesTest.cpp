#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using Lattice = PeriodicLattice<double>;

std::string latticeOf(const std::string& name) {
  return "[it]\nlattice = \"" + name + "\"\ncell = [1, 1, 1.5]\n";
}

class SceneLatticesTest : public SceneTest {
 protected:
  void SetUp() override {
    std::ofstream(folder / "beams.csv") << "node,0,0,0\nnode,1,0,0\nnode,9,0,0\n"
                                           "beam,0,1,0.1,0.2\nbeam,1,2,0.2,0.1\nball,2,0.3\n";
    std::ofstream(folder / "balls.csv") << "x,y,z,r\n0,0,0,1\n1,2,0.5,0.75\n";
  }
};

TEST_F(SceneLatticesTest, HasEveryUnitCell) {
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    expectIt(read(latticeOf(cell.name()) + "radius = 0.05"), Lattice(cell, {1, 1, 1.5}, 0.05));
  }
  expectIt(read(latticeOf("re-entrant") + "radius = 0.05\nheight = 0.8"),
           Lattice(UnitCell::reentrant(0.8), {1, 1, 1.5}, 0.05));
  EXPECT_EQ(refusal(latticeOf("octet") + "radius = 0.05\nheight = 0.8"),
            "line 5: lattice: only re-entrant cells have a \"height\"");
  const auto unknown = refusal(latticeOf("octett") + "radius = 0.05");
  EXPECT_TRUE(unknown.starts_with("line 2: \"lattice\" of lattice: need one of \"simple cubic\", "))
      << unknown;
  EXPECT_TRUE(unknown.ends_with("found \"octett\"; is it \"octet\"?")) << unknown;
}

TEST_F(SceneLatticesTest, MayEnd) {
  expectIt(
      read(latticeOf("BCC") + "radius = 0.05\ncount = [2, 3, 1]"),
      PeriodicLattice<double>(UnitCell::bcc(), {.period = {1, 1, 1.5}, .count = {2, 3, 1}}, 0.05));
  expectIt(
      read(latticeOf("BCC") + "radius = 0.05\ncount = [2, 0, 0]"),
      PeriodicLattice<double>(UnitCell::bcc(), {.period = {1, 1, 1.5}, .count = {2, 0, 0}}, 0.05));
}

TEST_F(SceneLatticesTest, MayBeGraded) {
  using Radius = Thickness<double>;
  expectIt(read(latticeOf("octet") + "radius = { at_center = 0.1, at_corners = 0.05 }"),
           Lattice(UnitCell::octet(), {1, 1, 1.5}, Radius::byDistanceToCellCenter(0.1, 0.05)));
  const auto near =
      latticeOf("octet") + "radius = { near = \"ball\", start = 0.1, end = 0.05, over = 0.5 }\n";
  const Solid<double> ball = Sphere<double>({}, 2);
  expectIt(read("solid = \"it\"\n" + near + "[ball]\nshape = \"sphere\"\nradius = 2\n"),
           Lattice(UnitCell::octet(), {1, 1, 1.5},
                   Radius::byDistanceTo(ball, {.start = 0.1, .end = 0.05, .over = 0.5})));
  EXPECT_EQ(refusal(near), "line 4: there is no solid \"ball\"");
  EXPECT_EQ(refusal(latticeOf("octet") + "radius = { at_center = 0.1 }"),
            "line 4: a radius by the place in the cell needs \"at_corners\", a number above 0");
  EXPECT_EQ(refusal(latticeOf("octet") + "radius = -1"),
            "line 4: \"radius\" of lattice: need a number above 0, or a table, found -1");
}

TEST_F(SceneLatticesTest, ReadsTables) {
  const auto graph = readBeams(folder / "beams.csv");
  expectIt(read("[it]\nbeams = \"beams.csv\""), BeamLattice<double>(graph));
  expectIt(read("[it]\nbeams = \"beams.csv\"\nscale = 0.5"),
           BeamLattice<double>(readBeams(folder / "beams.csv", {.scale = 0.5})));
  const auto clipped = beamsWithin(graph, Sphere<double>({}, 2));
  ASSERT_EQ(clipped.beams.size(), 2U);
  ASSERT_EQ(clipped.balls.size(), 0U);
  expectIt(read("solid = \"it\"\n[it]\nbeams = \"beams.csv\"\nwithin = \"ball\"\n"
                "[ball]\nshape = \"sphere\"\nradius = 2\n"),
           BeamLattice<double>(clipped));
  expectIt(read("[it]\nballs = \"balls.csv\""), PackedBed<double>(readBalls(folder / "balls.csv")));
  expectIt(read("[it]\nballs = \"balls.csv\"\nscale = 0.5"),
           PackedBed<double>(readBalls(folder / "balls.csv", {.scale = 0.5})));
  EXPECT_TRUE(refusal("\n[it]\nballs = \"beams.csv\"").starts_with("line 2: [it]: "));
  EXPECT_EQ(namesOf(scene::latticeForms()),
            (std::vector<std::string>{"balls", "beams", "conformal", "lattice"}));
}

}  // namespace
}  // namespace cutwater::test
