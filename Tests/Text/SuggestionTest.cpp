#include <Cutwater/Text/Suggestion.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using text::suggestion;

TEST(SuggestionTest, IsTheNearestWordWithinAThirdOfItsLength) {
  const std::vector<std::string> words{"radius", "radii", "center", "to"};
  EXPECT_EQ(suggestion("radus", words), "; is it \"radius\"?");    // one inserted
  EXPECT_EQ(suggestion("radiuss", words), "; is it \"radius\"?");  // one removed
  EXPECT_EQ(suggestion("redius", words), "; is it \"radius\"?");   // one replaced
  EXPECT_EQ(suggestion("raduis", words), "; is it \"radius\"?");   // two exchanged
  EXPECT_EQ(suggestion("raddi", words), "; is it \"radii\"?");
  EXPECT_EQ(suggestion("centre", words), "; is it \"center\"?");
  EXPECT_EQ(suggestion("t", words), "; is it \"to\"?");
  EXPECT_EQ(suggestion("rxxxus", words), "");
  EXPECT_EQ(suggestion("xy", words), "");
  EXPECT_EQ(suggestion("", words), "");  // nothing is near nothing
  EXPECT_EQ(suggestion("radius", {}), "");
}

TEST(SuggestionTest, OfEquallyNearWordsTheFirst) {
  EXPECT_EQ(suggestion("mast", {"mist", "most"}), "; is it \"mist\"?");
}

TEST(SuggestionTest, IsAWordOfNearlyTheSameMeaning) {
  const std::vector<std::string> shapes{"box frame", "cuboid", "sphere", "torus"};
  for (const char* word : {"box", "block", "cube", "rectangle"}) {
    EXPECT_EQ(suggestion(word, shapes), "; is it \"cuboid\"?") << word;
  }
  EXPECT_EQ(suggestion("ball", shapes), "; is it \"sphere\"?");
  EXPECT_EQ(suggestion("ring", shapes), "; is it \"torus\"?");
  EXPECT_EQ(suggestion("ball", {"cuboid"}), "");  // not known here
}

TEST(SuggestionTest, IsTheOnlyWordThatBeginsWithIt) {
  const std::vector<std::string> options{"--output", "--cells", "--cut", "--color"};
  EXPECT_EQ(suggestion("--out", options), "; is it \"--output\"?");
  EXPECT_EQ(suggestion("--c", {"--cells", "--color"}), "");
  EXPECT_EQ(suggestion("ou", {"output"}), "");  // too short to tell
}

TEST(SuggestionTest, LongWordsAreNoSlips) {
  const std::string word(65, 'a');
  EXPECT_EQ(suggestion(word, {word}), "");
  EXPECT_NE(suggestion(word.substr(1), {word.substr(1)}), "");
}

}  // namespace
}  // namespace cutwater::test
