#include <Cutwater/Scene/Detail/ParseToml.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using scene::parseToml;
using scene::SceneError;
using scene::SceneValue;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parseToml(text, "it"));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ParseTomlTest, KeepsOrderLinesAndKinds) {
  const auto table = parseToml(
      "\xef\xbb\xbfz = 1\r\n# words\r\na = [true, \"x\", 2.5]\n[m]\nk = -3\n[b]\n'odd key' = {u = "
      "1e3}\n",
      "it");
  ASSERT_EQ(table.size(), 4U);
  const auto keyAndLine = [&](std::size_t i) {
    return table[i].key + std::to_string(table[i].line);
  };
  EXPECT_EQ(keyAndLine(0) + keyAndLine(1) + keyAndLine(2) + keyAndLine(3), "z1a3m4b6");
  EXPECT_EQ(*table[0].value.as<double>(), 1);
  const auto& list = *table[1].value.as<SceneValue::List>();
  EXPECT_TRUE(*list[0].as<bool>());
  EXPECT_EQ(*list[1].as<std::string>(), "x");
  EXPECT_EQ(*list[2].as<double>(), 2.5);
  const auto& m = *table[2].value.as<SceneValue::Table>();
  EXPECT_EQ(m[0].line, 5U);
  EXPECT_EQ(*m[0].value.as<double>(), -3);
  const auto& b = *table[3].value.as<SceneValue::Table>();
  EXPECT_EQ(b[0].key, "odd key");
  EXPECT_EQ(*b[0].value.as<SceneValue::Table>()->front().value.as<double>(), 1000);
  EXPECT_EQ(b[0].value.as<double>(), nullptr);
}

TEST(ParseTomlTest, RefusalsHaveALine) {
  EXPECT_EQ(refusal("a = 1\nb = \n").substr(0, 12), "it: line 2: ");
  EXPECT_EQ(refusal("[a]\n[b]\n[a]\n").substr(0, 12), "it: line 3: ");
  EXPECT_EQ(refusal("a = \"\xff\"").substr(0, 12), "it: line 1: ");
  EXPECT_EQ(refusal(std::string("a = 1\n\0", 7)).substr(0, 4), "it: ");
  EXPECT_EQ(refusal("\na = 1979-05-27"), "it: line 2: a scene cannot contain dates");
  EXPECT_EQ(refusal("a = 9007199254740993"), "it: line 1: whole numbers beyond 2^53 are not exact");
  EXPECT_EQ(refusal("a = 9007199254740992"), "nothing");
  EXPECT_EQ(refusal("a = [[[[[[[1]]]]]]]"), "nothing");
  EXPECT_EQ(refusal("\na = [[[[[[[[1]]]]]]]]"),
            "it: line 2: lists and tables are nested too deeply");
}

/// Each dot of a key nests tables, which are freed by a call for each.
TEST(ParseTomlTest, KeysOfManyDotsAreRefusedBeforeTheyAreParsed) {
  const auto repeated = [](const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
  };
  const std::string kMany = ": more than 16 dots that are not decimal points";
  EXPECT_EQ(refusal("\n[" + repeated("a.", 1000000) + "a]\n"), "it: line 2" + kMany);
  EXPECT_EQ(refusal(repeated("0.", 1000000) + "0 = 1"), "it: line 1" + kMany);
  EXPECT_EQ(refusal(repeated("0 . ", 1000000) + "0 = 1"), "it: line 1" + kMany);
  EXPECT_EQ(refusal(repeated("0.1 . ", 1000000) + "0 = 1"), "it: line 1" + kMany);
  EXPECT_EQ(refusal(repeated("\"#\".", 1000000) + "0 = 1"), "it: line 1" + kMany);
  EXPECT_EQ(refusal("a = {" + repeated("b.c={", 100000)).substr(0, 10), "it: line 1");
  EXPECT_EQ(refusal("a = " + repeated("[", 1000000)).substr(0, 10), "it: line 1");
  std::string deep;  // each line within bounds
  for (int i = 0; i < 250; ++i) deep += "[{" + repeated("a.", 16) + "b=\n";
  EXPECT_EQ(refusal("a = " + deep).substr(0, 8), "it: line");
}

// Elsewhere the parser would take for impossible what they are: UBSan sees it.
TEST(ParseTomlTest, CharactersBeyondAsciiStandInStringsAndComments) {
  for (const std::string good :
       {R"(a = "é" # é ")", R"(a = 'é' # é)", R"("é" = 1)", R"('é' = 2)", R"(a = "\"é")",
        R"(a = """é""é""")", R"(a = '''é''é''')", "a = \"\"\"\\\n  é\"\"\"", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(refusal(good), "nothing") << good;
  }
  for (const std::string bad : {R"(é = 1)", R"(a = é)", R"(a = [1,é])", R"(a = ""é)", R"(a = "\é")",
                                R"(a = 2(b="é")", R"(a = "b" é "c")", R"(a = """"""é""")"}) {
    const auto words = refusal("\n" + bad);
    EXPECT_TRUE(words.starts_with("it: line 2: ")) << bad << ": " << words;
  }
}

TEST(ParseTomlTest, NumbersAndWordsMayHaveDots) {
  std::string numbers = "a = [0.5";
  for (int i = 0; i < 100000; ++i) numbers += ",-1_0.25e-3, 1.5";
  EXPECT_EQ(refusal(numbers + "]"), "nothing");
  EXPECT_EQ(refusal("  # ............................\na = \"../../hull.stl.gz\""), "nothing");
}

}  // namespace
}  // namespace cutwater::test
