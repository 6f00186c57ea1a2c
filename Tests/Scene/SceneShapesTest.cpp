#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using V = Vec3<double>;

std::vector<Expected> roundShapes() {
  return {
      {"sphere", "radius = 1.5", Sphere<double>({}, 1.5)},
      {"sphere", "radius = 1\ncenter = [0.1, -0.2, 0.3]", Sphere<double>({0.1, -0.2, 0.3}, 1)},
      {"ellipsoid", "semi_axes = [1, 2, 0.5]", Ellipsoid<double>({}, {1, 2, 0.5})},
      {"ellipsoid", "semi_axes = [1, 2, 0.5]\ncenter = [1, 0, 2]",
       Ellipsoid<double>({1, 0, 2}, {1, 2, 0.5})},
      {"torus", "major = 2\nminor = 0.5", Torus<double>(2, 0.5)},
      {"torus", "major = 2\nminor = 0.5\ncenter = [1, 2, 3]\naxis = [0, 1, 1]",
       Torus<double>({1, 2, 3}, {0, 1, 1}, 2, 0.5)},
      {"capped torus", "major = 2\nminor = 0.5\nhalf_angle = 75", CappedTorus<double>(2, 0.5, 75)},
      {"link", "length = 0\nmajor = 1\nminor = 0.25", Link<double>(0, 1, 0.25)},
      {"link", "length = 0.5\nmajor = 1\nminor = 0.25", Link<double>(0.5, 1, 0.25)},
      {"capsule", "from = [0, 0, 1]\nto = [1, 1, 0]\nradius = 0.5",
       Capsule<double>({0, 0, 1}, {1, 1, 0}, 0.5)},
      {"cone-sphere", "from = [0, 0, 1]\nto = [1, 1, 0]\nstart_radius = 0.5\nend_radius = 0",
       ConeSphere<double>({0, 0, 1}, {1, 1, 0}, 0.5, 0)},
  };
}

std::vector<Expected> cylindersAndCones() {
  return {
      {"cylinder", "from = [0, 0, 1]\nto = [1, 1, 0]\nradius = 0.5",
       Cylinder<double>({0, 0, 1}, {1, 1, 0}, 0.5)},
      {"rounded cylinder", "from = [0, 0, 0]\nto = [0, 2, 0]\nradius = 0.5\nrounding = 0.2",
       RoundedCylinder<double>({}, {0, 2, 0}, 0.5, 0.2)},
      {"infinite cylinder", "radius = 0.5", InfiniteCylinder<double>({}, {0, 0, 1}, 0.5)},
      {"infinite cylinder", "radius = 0.5\npoint = [1, 0, 0]\naxis = [1, 2, 3]",
       InfiniteCylinder<double>({1, 0, 0}, {1, 2, 3}, 0.5)},
      {"cone", "apex = [0, 0, 1]\nbase = [1, 0, 0]\nradius = 0.7",
       Cone<double>({0, 0, 1}, {1, 0, 0}, 0.7)},
      {"capped cone", "from = [0, 0, 1]\nto = [1, 1, 0]\nstart_radius = 0\nend_radius = 0.7",
       CappedCone<double>({0, 0, 1}, {1, 1, 0}, 0, 0.7)},
      {"infinite cone", "half_angle = 30", InfiniteCone<double>({}, {0, 0, 1}, 30)},
      {"infinite cone", "half_angle = 30\napex = [0, 1, 0]\naxis = [0, -1, 0]",
       InfiniteCone<double>({0, 1, 0}, {0, -1, 0}, 30)},
  };
}

std::vector<Expected> boxes() {
  const std::string corners = "lower = [-1, -0.5, 0]\nupper = [1, 2, 3]\n";
  const V lower{-1, -0.5, 0};
  const V upper{1, 2, 3};
  return {
      {"plane", "", Plane<double>({}, {0, 0, 1})},
      {"plane", "point = [0, 1, 0]\nnormal = [1, 1, 0]", Plane<double>({0, 1, 0}, {1, 1, 0})},
      {"cuboid", corners, Cuboid<double>(lower, upper)},
      {"rounded box", corners + "radius = 0.25", RoundedBox<double>(lower, upper, 0.25)},
      {"box frame", corners + "thickness = 0.1", BoxFrame<double>({lower, upper}, 0.1)},
      {"hexagonal prism", "inradius = 1\nheight = 2", HexagonalPrism<double>(1, 2)},
      {"octahedron", "radius = 2", Octahedron<double>(2)},
      {"pyramid", "side = 2\nheight = 1.5", Pyramid<double>(2, 1.5)},
  };
}

std::vector<Expected> polygonsAndPolyhedra() {
  const std::string outline = "outline = [[0, 0], [2, 0], [2, 2], [0, 2]]\n";
  const std::string hole = "loops = [[[0.5, 0.5], [1, 0.5], [0.5, 1]]]\n";
  const Polygon<double> square({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const Polygon<double> holed({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{0.5, 0.5}, {1, 0.5}, {0.5, 1}}});
  return {
      {"convex polyhedron",
       "half_spaces = [{ normal = [1, 0, 0], point = [1, 0, 0] }, { normal = [-1, 0, 0] },\n"
       "  { normal = [0, 1, 1], point = [0, 1, 0] }, { normal = [0, -1, 0] }, { normal = [0, 0, "
       "-1] "
       "}]",
       ConvexPolyhedron<double>({{{1, 0, 0}, {1, 0, 0}},
                                 {{}, {-1, 0, 0}},
                                 {{0, 1, 0}, {0, 1, 1}},
                                 {{}, {0, -1, 0}},
                                 {{}, {0, 0, -1}}})},
      {"extrusion", outline + "lower = -1\nupper = 1", Extrusion<double>(square, -1, 1)},
      {"extrusion", outline + hole + "lower = 0\nupper = 1", Extrusion<double>(holed, 0, 1)},
      {"revolution", outline, Revolution<double>(square)},
      {"revolution", outline + hole + "origin = [0, 0, 1]\naxis = [0, 1, 1]",
       Revolution<double>(holed, {0, 0, 1}, {0, 1, 1})},
  };
}

class SceneShapesTest : public SceneTest {};

TEST_F(SceneShapesTest, AreThoseOfTheLibrary) {
  std::vector<Expected> all;
  for (auto* group : {roundShapes, cylindersAndCones, boxes, polygonsAndPolyhedra}) {
    for (auto& one : group()) all.push_back(std::move(one));
  }
  for (const auto& [name, text, solid] : all) {
    SCOPED_TRACE(name);
    expectIt(read("[it]\nshape = \"" + name + "\"\n" + text), solid);
  }
  expectAll(all, scene::shapeForms());
}

TEST_F(SceneShapesTest, TellTheLineOfWhatTheirConstructorsRefuse) {
  EXPECT_EQ(refusal("\n[ring]\nshape = \"torus\"\nmajor = 1\nminor = 2", ErrorKind::Argument),
            "line 2: [ring]: Torus: need 0 < minor < major < infinity (minor = 2, major = 1)");
  EXPECT_EQ(
      refusal("[a]\nshape = \"extrusion\"\noutline = []\nlower = 0\nupper = 1", ErrorKind::Argument)
          .substr(0, 21),
      "line 1: [a]: Polygon:");
}

TEST_F(SceneShapesTest, TellWhatIsMissingOrWrong) {
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\""),
            "line 1: sphere needs \"radius\", a number above 0");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\nradus = 1"),
            "line 3: sphere has no key \"radus\"; is it \"radius\"?");
  EXPECT_EQ(refusal("[a]\nshape = \"shpere\"\nradius = 1"),
            "line 2: [a]: there is no shape \"shpere\"; is it \"sphere\"?");
  EXPECT_EQ(refusal("[a]\nshape = \"box\"\nlower = 1"),
            "line 2: [a]: there is no shape \"box\"; is it \"cuboid\"?");
  EXPECT_EQ(refusal("[a]\nshape = 3\nradius = 1"), "line 2: [a]: there is no shape 3");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\n\nradius = 0"),
            "line 4: \"radius\" of sphere: need a number above 0, found 0");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\nradius = \"big\""),
            "line 3: \"radius\" of sphere: need a number above 0, found \"big\"");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\nradius = inf"),
            "line 3: \"radius\" of sphere: need a number above 0, found inf");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\nradius = 1\ncenter = [1, 2]"),
            "line 4: \"center\" of sphere: need three numbers, found a list of 2");
  EXPECT_EQ(refusal("[a]\nshape = \"sphere\"\nradius = 1\ncenter = [1, 2, nan]"),
            "line 4: \"center\" of sphere: need three numbers, found a list of 3");
  EXPECT_EQ(refusal("[a]\nshape = \"convex polyhedron\"\nhalf_spaces = [{ point = [0, 0, 0] }]"),
            "line 3: a table of \"half_spaces\" needs a key that tells what it is: one of "
            "\"normal\"");
}

}  // namespace
}  // namespace cutwater::test
