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

TEST(SuggestionTest, LongWordsAreNoSlips) {
  const std::string word(65, 'a');
  EXPECT_EQ(suggestion(word, {word}), "");
  EXPECT_NE(suggestion(word.substr(1), {word.substr(1)}), "");
}

}  // namespace
}  // namespace cutwater::test
