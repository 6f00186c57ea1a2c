#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>

#include <limits>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using Cells = HexahedralCells;

const std::vector<Vec3<double>> kCurve{{0, 0, -1}, {0, 0, 0}, {0.5, 0, 1}, {2, 0, 1.5}};
const std::string kSpine = "spine = [[0, 0, -1], [0, 0, 0], [0.5, 0, 1], [2, 0, 1.5]]\n";

std::string octetsIn(const std::string& cells, const std::string& fit) {
  return "[it]\nconformal = \"octet\"\nradius = 0.03\ncells = " + cells + "\nfit = { " + fit +
         " }\n";
}

BeamLattice<double> octets(const Cells& cells) {
  return BeamLattice<double>(beamsOf(UnitCell::octet(), cells, 0.03));
}

class SceneConformalTest : public SceneTest {};

TEST_F(SceneConformalTest, FitsEveryShape) {
  expectIt(
      read(octetsIn("[1, 8, 2]", "inner_radius = 1, outer_radius = 2, length = 3")),
      octets(Cells({1, 8, 2}, PipeMapping({.innerRadius = 1, .outerRadius = 2, .length = 3}))));
  expectIt(read(octetsIn("[1, 4, 2]",
                         "inner_radius = 1, outer_radius = 2, length = 3, "
                         "from_degrees = 10, to_degrees = 90")),
           octets(Cells({1, 4, 2}, PipeMapping({1, 2, 3, 10, 90}))));
  expectIt(read(octetsIn("[2, 2, 3]", "radius = 1.5, length = 2")),
           octets(Cells({2, 2, 3}, CylinderMapping(1.5, 2))));
  expectIt(
      read(octetsIn("[2, 2, 1]", "diameter = 3, center_thickness = 1, back_radius = 3")),
      octets(Cells({2, 2, 1}, LensMapping({.diameter = 3,
                                           .centerThickness = 1,
                                           .frontRadius = std::numeric_limits<double>::infinity(),
                                           .backRadius = 3}))));
  expectIt(read(octetsIn("[1, 2, 3]", "lower = [-1, -1, -1], upper = [1, 2, 2]")),
           octets(Cells({1, 2, 3}, BoxMapping({{-1, -1, -1}, {1, 2, 2}}))));
}

TEST_F(SceneConformalTest, FollowsCurves) {
  const Spine spine(kCurve, {0, 1, 0});
  const auto along = [](const Spine& curve, double length) {
    return octets(
        Cells({1, 6, 4},
              AlongSpine(curve,
                         PipeMapping({.innerRadius = 0.2, .outerRadius = 0.4, .length = length}))));
  };
  const std::string pipe = "inner_radius = 0.2, outer_radius = 0.4";
  expectIt(read(octetsIn("[1, 6, 4]", pipe) + kSpine + "side = [0, 1, 0]"),
           along(spine, spine.length()));
  expectIt(read(octetsIn("[1, 6, 4]", pipe + ", length = 2") + kSpine), along(Spine(kCurve), 2));
  EXPECT_EQ(refusal(octetsIn("[1, 6, 4]", pipe)),
            "line 5: a pipe: \"length\" is needed where there is no \"spine\"");
  EXPECT_EQ(refusal(octetsIn("[1, 6, 4]", pipe + ", length = 2") + "side = [0, 1, 0]"),
            "line 6: conformal: \"side\" needs a \"spine\"");
}

TEST_F(SceneConformalTest, HasNoiseAndRadiiByThePlace) {
  const auto text = octetsIn("[2, 2, 2]", "lower = [-1, -1, -1], upper = [1, 2, 2]");
  const Cells cells({2, 2, 2}, BoxMapping({{-1, -1, -1}, {1, 2, 2}}));
  expectIt(read(text + "noise = { amplitude = 0.1 }"), octets(cells.withNoise({.amplitude = 0.1})));
  expectIt(read(text + "noise = { amplitude = 0.1, seed = 3, unit = \"shortest edge\", "
                       "keeps_boundary = true }"),
           octets(cells.withNoise({0.1, 3, NoiseUnit::ShortestEdge, true})));
  const std::string graded =
      "[it]\nconformal = \"BCC\"\nradius = { at_center = 0.1, at_corners = 0.02 }\n"
      "cells = [2, 2, 2]\nsubdivisions = 2\nfit = { lower = [-1, -1, -1], upper = [1, 2, 2] }";
  expectIt(read(graded),
           BeamLattice<double>(beamsOf(UnitCell::bcc(), cells,
                                       Thickness<double>::byDistanceToCellCenter(0.1, 0.02), {2})));
}

TEST_F(SceneConformalTest, RefusesWhatFitsNothing) {
  EXPECT_EQ(refusal(octetsIn("[1, 1, 1]", "width = 3")),
            "line 5: a table of \"fit\" needs a key that tells what it is: one of "
            "\"inner_radius\", \"radius\", \"diameter\", \"lower\"");
  EXPECT_TRUE(refusal(octetsIn("[1, 0, 1]", "radius = 1, length = 1"), ErrorKind::Argument)
                  .starts_with("line 1: [it]: HexahedralCells: "));
  EXPECT_EQ(refusal(octetsIn("[1000, 1000, 1000]", "radius = 1, length = 1"), ErrorKind::Limit),
            "line 1: [it]: its cells have more than 10000000 beams");
}

}  // namespace
}  // namespace cutwater::test
