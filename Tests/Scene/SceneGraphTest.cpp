#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <set>

#include "Scenes.hpp"

namespace cutwater::test {
namespace {

const std::string kSphereA = "[a]\nshape = \"sphere\"\nradius = 1\n";
const std::string kSphereB = "[b]\nshape = \"sphere\"\nradius = 1\ncenter = [1, 0, 0]\n";
const Solid<double> kBallA = named(Sphere<double>({}, 1), "a");
const Solid<double> kBallB = named(Sphere<double>({1, 0, 0}, 1), "b");
const std::string kBoth = "[both]\nunion = [\"a\", \"b\"]\n";

class SceneGraphTest : public SceneTest {};

TEST_F(SceneGraphTest, SolidsMayStandInAnyOrder) {
  const Solid<double> both = kBallA | kBallB;
  for (const auto& text :
       {kSphereA + kSphereB + kBoth, kBoth + kSphereA + kSphereB, kSphereB + kBoth + kSphereA}) {
    expectSame(read("solid = \"both\"\n" + text), both);
  }
}

TEST_F(SceneGraphTest, TheLastOneIsMeantUnlessTold) {
  expectSame(read(kBoth + kSphereA + kSphereB), kBallB);
  expectSame(read("solid = \"a\"\n" + kBoth + kSphereA + kSphereB), kBallA);
  expectSame(read("solid = \"b\"\n" + kBoth + kSphereA + kSphereB, {.solid = "a"}), kBallA);
  // Later in the file, not in the alphabet.
  expectSame(read("[z]\nshape = \"plane\"\n" + kSphereA), kBallA);
}

TEST_F(SceneGraphTest, OnlyWhatIsNeededIsMade) {
  expectSame(read("[lost]\nmesh = \"none.stl\"\n" + kSphereA), kBallA);
  EXPECT_NE(refusal("[lost]\nmesh = \"none.stl\"\nscal = 1\n" + kSphereA), "nothing");
}

TEST_F(SceneGraphTest, RefusesNamesThatThereAreNot) {
  EXPECT_EQ(refusal(kSphereA + "[it]\nunion = [\"a\",\n  \"aa\"]"),
            "line 6: there is no solid \"aa\"; is it \"a\"?");
  EXPECT_EQ(refusal("[pipe]\nshape = \"plane\"\n[it]\ncopy = \"piep\""),
            "line 4: there is no solid \"piep\"; is it \"pipe\"?");
  EXPECT_EQ(refusal("solid = \"c\"\n" + kSphereA + "[bolts]\ncopy = \"a\""),
            "line 1: there is no solid \"c\"; is it \"a\"?");
  try {
    static_cast<void>(read(kSphereA, {.solid = "bolt"}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Argument);
    EXPECT_EQ(error.what(), file.string() + ": there is no solid \"bolt\"");
  }
}

TEST_F(SceneGraphTest, RefusesCyclesAndNamesTheChain) {
  EXPECT_EQ(refusal("[a]\ncopy = \"a\""), "line 2: \"a\" is made of itself: \"a\" -> \"a\"");
  EXPECT_EQ(refusal(kSphereA + "[p]\nunion = [\"a\", \"q\"]\n[q]\ncomplement = \"r\"\n"
                               "[r]\nshell = \"q\"\nhalf_thickness = 1\n"),
            "line 9: \"q\" is made of itself: \"q\" -> \"r\" -> \"q\"");
  EXPECT_EQ(refusal("[a]\nlattice = \"octet\"\ncell = [1, 1, 1]\n"
                    "radius = { near = \"a\", start = 1, end = 1, over = 1 }"),
            "line 4: \"a\" is made of itself: \"a\" -> \"a\"");
}

TEST_F(SceneGraphTest, EndsAtHundredOperatorsOnOneAnother) {
  const auto chain = [](int length, bool isReversed) {
    std::vector<std::string> links{"[s0]\nshape = \"sphere\"\nradius = 1\n"};
    for (int i = 1; i < length; ++i) {
      links.push_back("[s" + std::to_string(i) + "]\ncopy = \"s" + std::to_string(i - 1) + "\"\n");
    }
    if (isReversed) std::reverse(links.begin(), links.end());
    std::string text = "solid = \"s0\"\n";
    for (const auto& link : links) text += link;
    return text;
  };
  for (const bool isReversed : {false, true}) {
    EXPECT_EQ(refusal(chain(100, isReversed)), "nothing");
    for (const int length : {101, 20000}) {
      const auto message = refusal(chain(length, isReversed), ErrorKind::Limit);
      EXPECT_TRUE(message.ends_with(": solids are nested more than 100 deep")) << message;
    }
  }
}

TEST_F(SceneGraphTest, EndsWhereASolidWouldBeAskedTooOften) {
  const auto name = [](int i) { return std::string(1, 's') += std::to_string(i); };
  const auto doubled = [&](int times, const std::string& table) {
    std::string text = "[s0]\nshape = \"sphere\"\nradius = 1\n";
    for (int i = 1; i <= times; ++i) {
      auto one = table;
      for (auto at = one.find('@'); at != std::string::npos; at = one.find('@')) {
        one.replace(at, 1, name(i - 1));
      }
      text += '[' + name(i) + "]\n" + one;
    }
    return text;
  };
  for (const std::string table :
       {"union = [\"@\", \"@\"]\n", "unfolded = \"@\"\nnormal = [1, 0, 0]\n"}) {
    EXPECT_EQ(refusal(doubled(10, table)), "nothing");
    EXPECT_EQ(refusal(doubled(17, table), ErrorKind::Limit).substr(9),
              "[s17]: it is made of more than 65536 solids");
    EXPECT_NE(refusal(doubled(90, table), ErrorKind::Limit), "nothing");
  }
}

/// A key that tells what a table is means nothing else in another.
TEST_F(SceneGraphTest, FormsAreToldApart) {
  std::set<std::string> heads;
  std::set<std::string> others;
  for (const auto& group : scene::allSceneForms()) {
    for (const auto& form : group.forms) {
      ASSERT_NE(form.make, nullptr);
      if (form.kindKey.empty()) {
        EXPECT_TRUE(heads.insert(form.identifyingKey()).second) << form.name;
      }
      for (const auto& key : form.keys) {
        if (key.name != form.identifyingKey()) others.insert(key.name);
      }
    }
  }
  for (const auto& key : scene::commonKeys()) others.insert(key.name);
  heads.insert("shape");
  for (const auto& head : heads) EXPECT_FALSE(others.contains(head)) << head;
}

TEST_F(SceneGraphTest, RefusesWhatIsNoSolid) {
  EXPECT_EQ(refusal(""), "there is no solid in it");
  EXPECT_EQ(refusal("solid = \"a\""), "there is no solid in it");
  EXPECT_EQ(refusal("# nothing\n\nradius = 1\n"),
            "line 3: \"radius\" is not a key of a scene, which has \"solid\", a text, and a table "
            "[name] for each solid");
  EXPECT_EQ(refusal("[[a]]\nshape = \"plane\"").substr(0, 11), "line 1: \"a\"");
  EXPECT_EQ(refusal("[a]\n").substr(0, 54),
            "line 1: [a] needs a key that tells what it is: one of ");
  EXPECT_EQ(refusal("[a]\nshap = \"plane\""), "line 2: [a] has no key \"shap\"; is it \"shape\"?");
  EXPECT_EQ(refusal("[a.b]\nshape = \"plane\"").substr(0, 15), "line 1: [a] nee");
}

TEST_F(SceneGraphTest, MessagesAreShortWhateverTheNames) {
  std::string ring;
  constexpr int kCount = 50;
  for (int i = 0; i < kCount; ++i) {
    ring += "[" + std::string(200, 'n') + std::to_string(i) + "]\ncopy = \"" +
            std::string(200, 'n') + std::to_string((i + 1) % kCount) + "\"\n";
  }
  const auto words = refusal(ring);
  EXPECT_TRUE(words.ends_with("nnn...\"")) << words;
  EXPECT_NE(words.find("\" -> ... -> \"nnn"), std::string::npos) << words;
  EXPECT_LT(words.size(), 450U) << words;
  EXPECT_LT(refusal("[" + std::string(5000, 'n') + "]\nbals = 1").size(), 450U);
}

}  // namespace
}  // namespace cutwater::test
