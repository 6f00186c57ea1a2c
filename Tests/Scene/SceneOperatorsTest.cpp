#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using S = Solid<double>;
using V = Vec3<double>;

const std::string kOperands =
    "[a]\nshape = \"sphere\"\ncenter = [0.5, 0.25, 0]\nradius = 1\n"
    "[b]\nshape = \"cuboid\"\nlower = [0.25, 0.5, -1]\nupper = [2, 1.5, 1]\n"
    "[c]\nshape = \"sphere\"\nradius = 0.75\n";
const S kA = named(Sphere<double>({0.5, 0.25, 0}, 1), "a");
const S kB = named(Cuboid<double>({0.25, 0.5, -1}, {2, 1.5, 1}), "b");
const S kC = named(Sphere<double>({}, 0.75), "c");

std::vector<Expected> combinations() {
  const Smoothing<double> cubic{.reach = 0.25, .kind = SmoothKind::Cubic};
  return {
      {"union", "union = [\"a\", \"b\", \"c\"]", unionOf(kA, kB, kC)},
      {"union", "union = [\"a\"]", unionOf(std::vector<S>{kA})},
      {"union", "union = [\"a\", \"b\"]\nreach = 0.5", smoothUnion(kA, kB, {.reach = 0.5})},
      {"union", "union = [\"a\", \"b\"]\nreach = 0.5\nfillet = \"exponential\"",
       smoothUnion(kA, kB, {.reach = 0.5, .kind = SmoothKind::Exponential})},
      {"intersection", "intersection = [\"a\", \"b\", \"c\"]", intersectionOf(kA, kB, kC)},
      {"intersection", "intersection = [\"a\", \"b\"]\nreach = 0.5\nfillet = \"circular\"",
       smoothIntersection(kA, kB, {.reach = 0.5, .kind = SmoothKind::Circular})},
      {"difference", "difference = [\"a\", \"b\"]", kA - kB},
      {"difference", "difference = [\"a\", \"b\", \"c\"]", kA - kB - kC},
      {"difference", "difference = [\"a\", \"b\"]\nreach = 0.25\nfillet = \"cubic\"",
       smoothDifference(kA, kB, cubic)},
      {"xor", "xor = [\"a\", \"b\"]", kA ^ kB},
      {"xor", "xor = [\"a\", \"b\", \"c\"]", (kA ^ kB) ^ kC},
      {"complement", "complement = \"a\"", ~kA},
      {"blended", "blended = [\"a\", \"b\"]\nt = 0.25", blended(kA, kB, 0.25)},
  };
}

std::vector<Expected> ofOneSolid() {
  const AffineMap<double> shear{{{{1, 0, 0}, {0.5, 2, 0}, {0, 0, 1}}}, {0.25, 0, 0}};
  auto linear = shear;
  linear.offset = {};
  const std::string columns = "transformed = \"a\"\ncolumns = [[1, 0, 0], [0.5, 2, 0], [0, 0, 1]]";
  return {
      {"copy", "copy = \"a\"", kA},
      {"offset", "offset = \"b\"\ndistance = -0.1", offset(kB, -0.1)},
      {"shell", "shell = \"b\"\nhalf_thickness = 0.1", shell(kB, 0.1)},
      {"scaled", "scaled = \"a\"\nfactor = -1.5", scaled(kA, -1.5)},
      {"elongated", "elongated = \"c\"\nhalf = [0, 1, 0.5]", elongated(kC, V{0, 1, 0.5})},
      {"transformed", columns + "\ntranslation = [0.25, 0, 0]", transformed(kA, shear)},
      {"transformed", columns, transformed(kA, linear)},
      {"inverted", "inverted = \"b\"", inverted(kB)},
      {"mirrored", "mirrored = \"b\"\nnormal = [1, 1, 0]", mirrored(kB, {1, 1, 0})},
      {"mirrored", "mirrored = \"b\"\nnormal = [1, 1, 0]\npoint = [0, 0.5, 0]",
       mirrored(kB, {1, 1, 0}, {0, 0.5, 0})},
      {"folded", "folded = \"b\"\nnormal = [1, 1, 0]\npoint = [0, 0.5, 0]",
       folded(kB, {1, 1, 0}, {0, 0.5, 0})},
      {"unfolded", "unfolded = \"b\"\nnormal = [1, 1, 0]\npoint = [0, 0.5, 0]",
       unfolded(kB, {1, 1, 0}, {0, 0.5, 0})},
      {"repeated", "repeated = \"a\"\nperiod = [2.5, 0, 2]",
       repeated(kA, {.period = {2.5, 0, 2}, .count = {}})},
      {"repeated", "repeated = \"a\"\nperiod = [2.5, 0, 2]\ncount = [2, 1, 3]",
       repeated(kA, {.period = {2.5, 0, 2}, .count = {2, 1, 3}})},
  };
}

class SceneOperatorsTest : public SceneTest {};

TEST_F(SceneOperatorsTest, AreThoseOfTheLibrary) {
  auto all = combinations();
  for (auto& one : ofOneSolid()) all.push_back(std::move(one));
  for (const auto& [name, text, solid] : all) {
    SCOPED_TRACE(text);
    expectSame(read(kOperands + "[it]\n" + text), solid);
  }
  expectAll(all, scene::operatorForms());
}

TEST_F(SceneOperatorsTest, MotionsActInTheirOrder) {
  const std::string box = "[it]\nshape = \"cuboid\"\nlower = [0, 0, 0]\nupper = [1, 2, 3]\n";
  const Cuboid<double> plain({0, 0, 0}, {1, 2, 3});
  expectIt(read(box + "move = [{ translate = [1, 0, 0] }, { rotate = 90, axis = \"z\" }]"),
           rotated(translated(plain, {1, 0, 0}), 90, 2));
  expectIt(read(box + "move = [{ rotate = 90, axis = \"x\" }, { translate = [1, 0, 0] }]"),
           translated(rotated(plain, 90, 0), {1, 0, 0}));
  expectIt(read(box + "move = [{ rotate = 30, axis = [1, 1, 0], through = [0, 1, 0] }]"),
           rotated(plain, 30, {1, 1, 0}, {0, 1, 0}));
  expectIt(read(box + "move = [{ rotate = 30, axis = \"y\", through = [1, 1, 0] }]"),
           rotated(plain, 30, {0, 1, 0}, {1, 1, 0}));
  EXPECT_EQ(refusal(box + "move = [{ rotate = 30 }]"),
            "line 5: rotate needs \"axis\", \"x\", \"y\", \"z\" or three numbers");
  EXPECT_EQ(refusal(box + "move = [{ rotate = 30, axis = \"xy\" }]"),
            "line 5: \"axis\" of rotate: need \"x\", \"y\", \"z\" or three numbers, found \"xy\"");
  EXPECT_EQ(refusal(box + "move = [{ turn = 30 }]"),
            "line 5: a table of \"move\" needs a key that tells what it is: one of "
            "\"translate\", \"rotate\"");
  EXPECT_EQ(refusal(box + "move = [{ rotate = 30, axis = \"x\", translate = [1, 0, 0] }]"),
            "line 5: a table of \"move\" cannot have both \"translate\" and \"rotate\"");
  EXPECT_EQ(refusal(box + "move = [{ translat = [1, 0, 0] }]"),
            "line 5: a table of \"move\" has no key \"translat\"; is it \"translate\"?");
}

TEST_F(SceneOperatorsTest, PatchesHaveNames) {
  const auto solid = read(kOperands + "[both]\nunion = [\"a\", \"b\"]\npatch = \"body\"\n");
  expectSame(solid, named(kA | kB, "body"));
}

TEST_F(SceneOperatorsTest, PatchesAreCalledAfterTheTablesOfShapes) {
  using Names = std::vector<std::string>;
  const std::string both = kOperands + "[both]\nunion = [\"a\", \"b\"]\n";
  EXPECT_EQ(read(both).patchNames(), (Names{"a", "b"}));
  EXPECT_EQ(read(both + "[shelled]\nshell = \"both\"\nhalf_thickness = 0.1").patchNames(),
            (Names{"a", "b"}));
  EXPECT_EQ(read(both + "[moved]\ncopy = \"c\"\nmove = [{ translate = [1, 0, 0] }]").patchNames(),
            (Names{"c"}));
  EXPECT_EQ(read(both + "[it]\ncopy = \"a\"\npatch = \"bore\"").patchNames(), (Names{"bore"}));
  EXPECT_EQ(read(both + "[it]\nshape = \"sphere\"\nradius = 1\npatch = \"bore\"").patchNames(),
            (Names{"bore"}));
}

TEST_F(SceneOperatorsTest, TellTheLineOfWhatIsRefused) {
  EXPECT_EQ(refusal(kOperands + "[it]\nblended = [\"a\"]\nt = 0"),
            "line 13: blended: need two solids");
  EXPECT_EQ(refusal(kOperands + "[it]\nblended = [\"a\", \"b\"]\nt = 2", ErrorKind::Argument),
            "line 12: [it]: blended: need 0 <= t <= 1 (t = 2)");
  EXPECT_EQ(refusal(kOperands + "[it]\nunion = []"),
            "line 13: \"union\" of union: need a list of names of solids, found a list of 0");
  EXPECT_EQ(refusal(kOperands + "[it]\nunion = [\"a\"]\nfillet = \"cubik\""),
            "line 14: \"fillet\" of union: need one of \"quadratic\", \"cubic\", \"circular\", "
            "\"exponential\", found \"cubik\"; is it \"cubic\"?");
  EXPECT_EQ(refusal(kOperands + "[it]\nunion = [\"a\"]\nxor = [\"a\"]"),
            "line 14: [it] cannot have both \"union\" and \"xor\"");
}

}  // namespace
}  // namespace cutwater::test
