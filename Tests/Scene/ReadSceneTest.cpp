#include <clocale>
#include <random>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

const std::string kScene =
    "# A scene with one of everything.\n"
    "solid = \"body\"\n"
    "[rod]\nshape = \"capped cone\"\nfrom = [0, 0, -1.5]\nto = [0.5, 0, 1.5]\n"
    "start_radius = 0.5\nend_radius = 0.25\n"
    "move = [{ translate = [0.5, 0, 0] }, { rotate = 90, axis = \"z\" }]\n"
    "[prism]\nshape = \"extrusion\"\noutline = [[0, 0], [1, 0], [0, 1]]\nlower = 0\nupper = 1\n"
    "[lens]\nshape = \"convex polyhedron\"\nhalf_spaces = [{ normal = [1, 0, 0] }, { normal = [-1, "
    "0, 0], point = [-1, 0, 0] }, { normal = [0, 1, 0] }, { normal = [0, -1, 0], point = [0, -1, "
    "0] }, { normal = [0, 0, 1] }, { normal = [0, 0, -1], point = [0, 0, -1] }]\n"
    "[core]\nlattice = \"octet\"\ncell = [1, 1, 1]\ncount = [2, 2, 2]\n"
    "radius = { near = \"rod\", start = 0.1, end = 0.05, over = 1 }\n"
    "[balls]\nballs = \"balls.csv\"\npatch = \"balls\"\n"
    "[many]\nrepeated = \"prism\"\nperiod = [2, 0, 0]\ncount = [2, 1, 1]\n"
    "[sheared]\ntransformed = \"lens\"\ncolumns = [[1, 0, 0], [0.5, 1, 0], [0, 0, 2]]\n"
    "[body]\nunion = [\"rod\", \"many\", \"core\", \"sheared\", \"balls\"]\nreach = 0.1\n"
    "fillet = \"cubic\"\n";

class ReadSceneTest : public SceneTest {
 protected:
  void SetUp() override { std::ofstream(folder / "balls.csv") << "0,0,0,1\n1,2,0.5,0.75\n"; }

  /// An Error with the file's name, or a solid that answers.
  void expectAnAnswer(const std::string& text) const {
    try {
      const auto solid = read(text);
      static_cast<void>(solid.signedDistance({0.1, 0.2, 0.3}));
      ++answers;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file.string() + ": ")) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      ++refusals;
    }
  }

  mutable int answers = 0;
  mutable int refusals = 0;
};

/// What a table must not hold, one line after `[it]`.
const char* const kBadLines[] = {
    "shape = \"sphere\"",
    "shape = \"\"\nradius = 1",
    "shape = [\"sphere\"]\nradius = 1",
    "shape = \"sphere\"\nradius = -1",
    "shape = \"sphere\"\nradius = 1e999",
    "shape = \"sphere\"\nradius = nan",
    "shape = \"sphere\"\nradius = true",
    "shape = \"sphere\"\nradius = 1\nradius = 2",
    "shape = \"sphere\"\nradius = 1\ncenter = 3",
    "shape = \"sphere\"\nradius = 1\ncenter = [1, \"2\", 3]",
    "shape = \"sphere\"\nradius = 1\ncenter = {x = 1}",
    "shape = \"sphere\"\nradius = 1\nmove = 3",
    "shape = \"sphere\"\nradius = 1\nmove = [3]",
    "shape = \"sphere\"\nradius = 1\nmove = [{}]",
    "shape = \"sphere\"\nradius = 1\nmove = [{ rotate = 3, axis = \"w\" }]",
    "shape = \"sphere\"\nradius = 1\nmove = [{ rotate = 3, axis = [0, 0, 0] }]",
    "shape = \"sphere\"\nradius = 1\npatch = \"\"",
    "shape = \"sphere\"\nradius = 1\npatch = 7",
    "shape = \"cuboid\"\nlower = [0, 0, 0]\nupper = [1, 0, 1]",
    "shape = \"plane\"\nnormal = [0, 0, 0]",
    "shape = \"ellipsoid\"\nsemi_axes = [1, 1, 0]",
    "shape = \"extrusion\"\noutline = [[0, 0], [1, 1], [1, 0], [0, 1]]\nlower = 0\nupper = 1",
    "shape = \"extrusion\"\noutline = [[0, 0], [1, 0, 2], [0, 1]]\nlower = 0\nupper = 1",
    "shape = \"extrusion\"\noutline = 5\nlower = 0\nupper = 1",
    "shape = \"revolution\"\noutline = [[-1, 0], [1, 0], [0, 1]]",
    "shape = \"convex polyhedron\"\nhalf_spaces = []",
    "shape = \"convex polyhedron\"\nhalf_spaces = [1]",
    "shape = \"convex polyhedron\"\nhalf_spaces = [{ normal = [1, 0, 0], d = 1 }]",
    "union = \"it\"",
    "union = [\"it\"]",
    "union = [\"nobody\"]",
    "union = [1]",
    "union = [\"\"]",
    "complement = [\"it\"]",
    "mesh = \"\"",
    "mesh = \".\"",
    "mesh = \"nobody.stl\"",
    "mesh = \"balls.csv\"\nprobes = 0.5",
    "mesh = \"test.toml\"",
    "prepared = \"balls.csv\"",
    "balls = \"test.toml\"",
    "beams = \"balls.csv\"",
    "beams = \"nul\\u0000.csv\"",
    "lattice = \"octet\"\ncell = [1, 1, 1]\nradius = {}",
    "lattice = \"octet\"\ncell = [1, 1, 1]\nradius = [1]",
    "lattice = \"octet\"\ncell = [1, 0, 1]\nradius = 1",
    "lattice = \"octet\"\ncell = [1, 1, 1]\nradius = 1\ncount = [1, 2, 2.5]",
    "lattice = \"octet\"\ncell = [1, 1, 1]\nradius = 1\ncount = [1, 2, 4294967294]",
    "lattice = \"re-entrant\"\ncell = [1, 1, 1]\nradius = 1\nheight = 2",
    "shape = \"sphere\"\nradius = 1\nwhen = 1979-05-27T07:32:00Z",
    "shape = 'sphere",
    "\"\" = 1",
    "it.shape = \"plane\"",
};

TEST_F(ReadSceneTest, RefusesBadScenesByNameAndLine) {
  EXPECT_GE(std::size(kBadLines), 50U);
  for (const auto* lines : kBadLines) {
    const std::string text = "# a scene\n[it]\n" + std::string(lines) + "\n";
    try {
      static_cast<void>(read(text));
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with(file.string() + ": line ")) << message;
    }
    expectAnAnswer(text);
  }
}

TEST_F(ReadSceneTest, AnyBytesGiveAnErrorOrASolid) {
  const auto solid = read(kScene);
  EXPECT_EQ(solid.patchNames().back(), "balls");
  std::mt19937 random(7);
  for (int i = 0; i < 600; ++i) {
    auto text = kScene;
    for (auto changes = 1 + random() % 2; changes > 0; --changes) {
      const auto at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(at, 1 + random() % 8);
          break;
        case 2:
          text.insert(at, text.substr(random() % text.size(), random() % 24));
          break;
        default:
          text[at] = "=[]{}\".,\n-019#"[random() % 15];
      }
    }
    expectAnAnswer(text);
  }
  expectAnAnswer("[it]\nshape = [ }\n");  // what the parser takes for granted
  EXPECT_GT(answers, 15);                 // both ways are tried
  EXPECT_GT(refusals, 150);
  for (std::size_t size = 0; size < kScene.size(); size += 7) {
    expectAnAnswer(kScene.substr(0, size));
  }
}

TEST_F(ReadSceneTest, FilesAndTheirSizesAreChecked) {
  EXPECT_EQ(refusal(""), "there is no solid in it");
  EXPECT_THROW((void)readScene(folder / "none.toml"), Error);
  EXPECT_THROW((void)readScene(folder.path()), Error);
  const std::string text = "[a]\nshape = \"plane\"\n";
  EXPECT_NO_THROW((void)read(text, {.maxBytes = text.size()}));
  try {
    static_cast<void>(read(text, {.maxBytes = text.size() - 1}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
}

TEST_F(ReadSceneTest, NumbersDoNotDependOnTheLocale) {
  const std::string text = "[a]\nshape = \"sphere\"\nradius = 1.5";
  for (const char* locale : {"de_DE.UTF-8", "de_DE.utf8", "C"}) {
    if (std::setlocale(LC_ALL, locale) == nullptr) continue;
    EXPECT_EQ(read(text).signedDistance({}), -1.5);
  }
  std::setlocale(LC_ALL, "C");
}

}  // namespace
}  // namespace cutwater::test
