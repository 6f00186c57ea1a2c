#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

using Field = TpmsField<double>;
using Graded = GradedValue<double>;
using Map = TpmsMap<double>;

const std::string kGyroid = "[it]\ntpms = \"gyroid\"\n";
const std::string kGround = "solid = \"it\"\n[ground]\nshape = \"plane\"\n";
const Plane<double> kPlane({}, {0, 0, 1});

class SceneTpmsTest : public SceneTest {};

TEST_F(SceneTpmsTest, HasEveryPattern) {
  for (const auto& pattern : TpmsPattern::all()) {
    SCOPED_TRACE(pattern.name());
    expectIt(read("[it]\ntpms = \"" + pattern.name() + "\"\ncell = 1.5\nlevel = 0.1"),
             TpmsSolid<double>(Field(pattern, 1.5), TpmsPart::Wall, 0.1));
  }
  const auto unknown = refusal("[it]\ntpms = \"gyriod\"\ncell = 1\nlevel = 0.1");
  EXPECT_TRUE(unknown.starts_with("line 2: \"tpms\" of tpms: need one of \"gyroid\", ")) << unknown;
  EXPECT_TRUE(unknown.ends_with("found \"gyriod\"; is it \"gyroid\"?")) << unknown;
}

TEST_F(SceneTpmsTest, HasEveryPart) {
  const std::vector<std::string> names{"wall",      "channels",  "channel A",
                                       "channel B", "wall in A", "wall in B"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    SCOPED_TRACE(names[i]);
    expectIt(read(kGyroid + "cell = 2\nlevel = 0.3\npart = \"" + names[i] + "\""),
             TpmsSolid<double>(Field(TpmsPattern::gyroid(), 2), static_cast<TpmsPart>(i), 0.3));
  }
  expectIt(read(kGyroid + "cell = 2\nlevel = -0.5\npart = \"channel B\""),
           TpmsSolid<double>(Field(TpmsPattern::gyroid(), 2), TpmsPart::ChannelB, -0.5));
}

TEST_F(SceneTpmsTest, HasCellsOfEveryKind) {
  const auto wallIn = [](const Map& map) {
    return TpmsSolid<double>(Field(TpmsPattern::gyroid(), map), TpmsPart::Wall, 0.3);
  };
  const auto withCell = [&](const std::string& cell) {
    return read(kGyroid + "level = 0.3\ncell = " + cell);
  };
  expectIt(withCell("[1, 2, 3]"), wallIn(Map(Vec3<double>{1, 2, 3})));
  const std::string round = "{ radial_size = 1, cells_per_turn = 6, axial_size = 1.5";
  expectIt(withCell(round + " }"), wallIn(Map::cylindrical({1, 6, 1.5})));
  expectIt(withCell(round + ", turns_per_length = 0.1 }"),
           wallIn(Map::cylindrical({1, 6, 1.5, 0.1})));
  const CellSizes<double> along({{-1, 2}, {0, 1}, {2, 3}});
  expectIt(withCell("{ x = 2, y = 1, z = [[-1, 2], [0, 1], [2, 3]] }"),
           wallIn(Map({CellSizes<double>(2), CellSizes<double>(1), along})));
  expectIt(withCell("2\ndeformation = { amplitude = 0.2, spacing = [1, 2, 3] }"),
           wallIn(Map(2).deformed({.amplitude = 0.2, .spacing = {1, 2, 3}, .seed = 1})));
  expectIt(withCell("2\ndeformation = { amplitude = 0.2, spacing = [1, 2, 3], seed = 7 }"),
           wallIn(Map(2).deformed({.amplitude = 0.2, .spacing = {1, 2, 3}, .seed = 7})));
}

TEST_F(SceneTpmsTest, MayBeGraded) {
  const auto level = Graded::byValueOf(kPlane, {.start = 0.1, .end = 0.4, .over = 2});
  expectIt(read(kGround + kGyroid +
                "cell = 2\nlevel = { near = \"ground\", start = 0.1, end = 0.4, over = 2 }"),
           TpmsSolid<double>(Field(TpmsPattern::gyroid(), 2), TpmsPart::Wall, level));
  const auto between = [](const Graded& weight) {
    const TpmsTransition<double> transition{TpmsPattern::gyroid(), TpmsPattern::schwarzP(), weight};
    return TpmsSolid<double>(Field(transition, 2), TpmsPart::Wall, 0.3);
  };
  const auto passing =
      kGround + kGyroid + "cell = 2\nlevel = 0.3\ntransition = { to = \"Schwarz P\", ";
  expectIt(read(passing + "near = \"ground\", over = 2 }"),
           between(Graded::byValueOf(kPlane, {.start = 0, .end = 1, .over = 2})));
  expectIt(read(passing + "near = \"ground\", over = 2, start = 0.75, end = 0.25 }"),
           between(Graded::byValueOf(kPlane, {.start = 0.75, .end = 0.25, .over = 2})));
  expectIt(read(passing + "weight = 0.25 }"), between(0.25));
}

TEST_F(SceneTpmsTest, HasWallsOfEvenThickness) {
  const std::string wall = "[it]\neven_wall = \"Schwarz P\"\ncell = 2\nhalf_thickness = ";
  expectIt(read(wall + "0.1"), MetricWall<double>(TpmsPattern::schwarzP(), 2, 0.1));
  expectIt(read(kGround + wall + "{ near = \"ground\", start = 0.1, end = 0.15, over = 2 }"),
           MetricWall<double>(TpmsPattern::schwarzP(), 2,
                              Graded::byValueOf(kPlane, {.start = 0.1, .end = 0.15, .over = 2})));
  EXPECT_TRUE(refusal(wall + "1.5", ErrorKind::Argument)
                  .starts_with("line 1: [it]: MetricWall: need half a thickness between"));
}

/// As the scene names them.
TpmsChannels<double> namedSides(const TpmsChannels<double>& sides) {
  return {named(sides.a, "channel A"), named(sides.b, "channel B")};
}

/// Solid and fluids of what `exchanger` describes about a core.
template <typename Read>
void expectExchanger(const Read& read, const std::string& tables, const TwoFluids<double>& parts) {
  const std::string fluids =
      "[a]\nfluid = \"A\"\nof = \"it\"\n[b]\nfluid = \"B\"\nof = \"it\"\npatch = \"cold\"\n";
  expectSame(read("solid = \"it\"\n" + tables + fluids), parts.wall);
  expectSame(read("solid = \"a\"\n" + tables + fluids), parts.a);
  expectSame(read("solid = \"b\"\n" + tables + fluids), named(parts.b, "cold"));
}

TEST_F(SceneTpmsTest, HasHeatExchangers) {
  const auto reader = [this](const std::string& text) { return read(text); };
  const std::string box =
      "[it]\nexchanger = \"box\"\ncore = \"core\"\nlower = [-2, -2, -1]\nupper = [2, 2, 2]\n";
  const Box<double> block{{-2, -2, -1}, {2, 2, 2}};
  const std::string core = "[core]\ntpms = \"gyroid\"\ncell = 2\nlevel = 0.3\n";
  const auto sides = namedSides(TpmsChannels<double>::of(Field(TpmsPattern::gyroid(), 2), 0.3));
  expectExchanger(
      reader, box + "cap = 0.2\n" + core,
      twoFluidsIn<double>(block, sides, {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.2}));
  expectExchanger(
      reader, box + "cap = 0.2\naxis_of_a = \"z\"\naxis_of_b = \"x\"\n" + core,
      twoFluidsIn<double>(block, sides, {.axisOfA = 2, .axisOfB = 0, .capThickness = 0.2}));
  expectExchanger(reader,
                  "[it]\nexchanger = \"cylinder\"\ncore = \"core\"\nradius = 2\nlower = -1\n"
                  "upper = 2\ncap = 0.25\n" +
                      core,
                  twoFluidsIn<double>({.radius = 2, .z = {-1, 2}, .capThickness = 0.25}, sides));
  const MetricWall<double> even(TpmsPattern::schwarzD(), 2, 0.1);
  expectExchanger(
      reader,
      box + "cap = 0.2\n[core]\neven_wall = \"Schwarz D\"\ncell = 2\nhalf_thickness = 0.1\n",
      twoFluidsIn<double>(block, namedSides(TpmsChannels<double>::of(even)),
                          {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.2}));
}

TEST_F(SceneTpmsTest, MovesExchangersWithAllTheirParts) {
  const auto reader = [this](const std::string& text) { return read(text); };
  auto sides = namedSides(TpmsChannels<double>::of(Field(TpmsPattern::gyroid(), 2), 0.3));
  for (auto* side : {&sides.a, &sides.b}) side->translate({0.5, 0, 0});
  auto parts = twoFluidsIn<double>({{-2, -2, -1}, {2, 2, 2}}, sides,
                                   {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.2});
  for (auto* part : {&parts.a, &parts.wall, &parts.b}) {
    part->rotate(90, 2);
    *part = named(*part, "hx");
  }
  expectExchanger(
      reader,
      "[core]\ntpms = \"gyroid\"\ncell = 2\nlevel = 0.3\n"
      "move = [{ translate = [0.5, 0, 0] }]\n[it]\nexchanger = \"box\"\ncore = \"core\"\n"
      "lower = [-2, -2, -1]\nupper = [2, 2, 2]\ncap = 0.2\npatch = \"hx\"\n"
      "move = [{ rotate = 90, axis = \"z\" }]\n",
      parts);
}

TEST_F(SceneTpmsTest, RefusesWhatIsNone) {
  EXPECT_EQ(refusal(kGyroid + "cell = 2"), "line 1: tpms needs \"level\", a number, or a table");
  EXPECT_EQ(refusal(kGyroid + "level = 0.3\ncell = [1, 2]"),
            "line 4: \"cell\" of tpms: need a number above 0, three of them, or a table, found a "
            "list of 2");
  EXPECT_EQ(refusal(kGyroid + "level = 0.3\ncell = { x = 1, y = 2 }"),
            "line 4: cells of sizes by the place needs \"z\", a number above 0, or a list of "
            "points, two numbers each");
  EXPECT_EQ(
      refusal(kGyroid + "cell = 2\nlevel = { near = \"groud\", start = 0, end = 1, over = 1 }"),
      "line 4: there is no solid \"groud\"");
  EXPECT_EQ(refusal(kGyroid + "cell = 2\nlevel = 0.3\ntransition = { weight = 1 }"),
            "line 5: a transition needs \"to\", one of \"gyroid\", \"Schwarz P\", \"Schwarz D\", "
            "\"Schwarz D, 4 terms\", \"lidinoid\", \"split-P\", \"Neovius\", \"Schoen IWP\", "
            "\"Schoen F-RD\", \"Fischer-Koch S\"");
  EXPECT_TRUE(refusal(kGyroid + "cell = 2\nlevel = 2", ErrorKind::Argument)
                  .starts_with("line 1: [it]: TpmsSolid: need levels between"));
  EXPECT_TRUE(
      refusal(kGyroid + "cell = 2\nlevel = 0.3\ntransition = { weight = 2, to = \"gyroid\" }",
              ErrorKind::Argument)
          .starts_with("line 1: [it]: TpmsField: need weights from 0 to 1"));
}

TEST_F(SceneTpmsTest, RefusesExchangersOfWhatIsNoWall) {
  const std::string box =
      "[it]\nexchanger = \"box\"\ncore = \"core\"\nlower = [-2, -2, -1]\n"
      "upper = [2, 2, 2]\ncap = 0.2\n";
  const std::string need =
      "line 4: box: \"core\": need the name of an \"even_wall\", or of a "
      "\"tpms\" whose part is \"wall\"";
  EXPECT_EQ(refusal("solid = \"it\"\n" + box + "[core]\nshape = \"sphere\"\nradius = 1\n"), need);
  EXPECT_EQ(refusal("solid = \"it\"\n" + box +
                    "[core]\ntpms = \"gyroid\"\ncell = 2\nlevel = 0.3\npart = \"channel A\"\n"),
            need);
  EXPECT_EQ(refusal("[ball]\nshape = \"sphere\"\nradius = 1\n[f]\nfluid = \"A\"\nof = \"ball\"\n"),
            "line 6: fluid: \"of\": need the name of an \"exchanger\"");
}

TEST_F(SceneTpmsTest, TriesEveryForm) {
  EXPECT_EQ(namesOf(scene::tpmsForms()),
            (std::vector<std::string>{"box", "cylinder", "even_wall", "fluid", "tpms"}));
}

}  // namespace
}  // namespace cutwater::test
