#include <Cutwater/Text/Words.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(WordsTest, ComparesAsciiLettersInAnyCase) {
  EXPECT_TRUE(text::equalIgnoringCase("", ""));
  EXPECT_TRUE(text::equalIgnoringCase("Vertex", "vERTEX"));
  EXPECT_FALSE(text::equalIgnoringCase("vertex", "vertices"));
  EXPECT_FALSE(text::equalIgnoringCase("[", "{"));  // 32 apart, as letters of two cases are
}

TEST(WordsTest, MessagesAreShortAndPrintable) {
  EXPECT_EQ(text::shortened("radius"), "radius");
  EXPECT_EQ(text::shortened("a\tb\n"), "a?b?");
  EXPECT_EQ(text::shortened("\x7f"), "?");
  EXPECT_EQ(text::shortened(std::string(40, 'x')), std::string(40, 'x'));
  EXPECT_EQ(text::shortened(std::string(41, 'x')), std::string(40, 'x').append("..."));
  EXPECT_EQ(text::inQuotes("a b"), "\"a b\"");
}

}  // namespace
}  // namespace cutwater::test
