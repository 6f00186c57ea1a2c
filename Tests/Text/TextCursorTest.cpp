#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Text/TextCursor.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using text::Content;
using text::TextCursor;

/// The words of each line.
std::vector<std::vector<std::string>> wordsOf(std::string_view bytes,
                                              const TextCursor::Rules& rules = {}) {
  const Content content{"it", bytes};
  TextCursor cursor(content, rules);
  std::vector<std::vector<std::string>> lines;
  while (cursor.nextLine()) {
    lines.emplace_back();
    for (auto word = cursor.word(); !word.empty(); word = cursor.word()) {
      lines.back().emplace_back(word);
    }
  }
  return lines;
}

using Lines = std::vector<std::vector<std::string>>;

template <typename Action>
std::string textRefusal(std::string_view bytes, const Action& action) {
  const Content content{"it", bytes};
  TextCursor cursor(content);
  try {
    action(cursor);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    return error.what();
  }
  return "none";
}

TEST(TextCursorTest, LinesEndAsOnAnySystem) {
  const Lines expected{{"a", "b"}, {}, {"c"}};
  for (const auto* bytes : {"a b\n\nc", "a b\r\n\r\nc\r\n", "a b\r\rc\r"}) {
    EXPECT_EQ(wordsOf(bytes), expected) << bytes;
  }
  EXPECT_EQ(wordsOf(" \ta\v\fb "), (Lines{{"a", "b"}}));
  EXPECT_EQ(wordsOf(""), Lines{});
}

TEST(TextCursorTest, CommentsBeginWhereTheRulesSay) {
  using enum TextCursor::Comments;
  EXPECT_EQ(wordsOf("a#b # c"), (Lines{{"a#b", "#", "c"}}));
  EXPECT_EQ(wordsOf("a#b # c", {.comments = AtWords}), (Lines{{"a#b"}}));
  EXPECT_EQ(wordsOf("a#b # c", {.comments = Anywhere}), (Lines{{"a"}}));
}

TEST(TextCursorTest, LinesContinueBehindABackslash) {
  EXPECT_EQ(wordsOf("a \\\nb\nc", {.continuation = true}), (Lines{{"a", "b"}, {"c"}}));
  EXPECT_EQ(wordsOf("a \\\nb"), (Lines{{"a", "\\"}, {"b"}}));
}

TEST(TextCursorTest, NumbersAreReadInFull) {
  const Content content{"it", "+1.5 -2e3 7 nan"};
  TextCursor cursor(content);
  ASSERT_TRUE(cursor.nextLine());
  EXPECT_EQ(cursor.number(), 1.5);
  EXPECT_EQ(cursor.number(), -2000);
  EXPECT_EQ(cursor.integer(), 7);
  EXPECT_NE(cursor.toNumber("nan"), cursor.toNumber("nan"));
}

TEST(TextCursorTest, RefusalsNameTheLine) {
  const auto numberOfSecondLine = [](TextCursor& cursor) {
    cursor.nextLine();
    cursor.nextLine();
    static_cast<void>(cursor.number());
  };
  EXPECT_EQ(textRefusal("\n1x\n", numberOfSecondLine),
            "it: line 2: expected a number, found \"1x\"");
  EXPECT_EQ(textRefusal("\n1e999\n", numberOfSecondLine), "it: line 2: \"1e999\" is out of range");
  EXPECT_EQ(textRefusal("\n", numberOfSecondLine),
            "it: line 1: a number is missing at the end of the line");
  const auto readLine = [](TextCursor& cursor) { cursor.nextLine(); };
  EXPECT_EQ(textRefusal(std::string_view("a\0b", 3), readLine), "it: line 1: a NUL byte in text");
  const std::string longest(TextCursor::kLongestLine, 'a');
  EXPECT_EQ(textRefusal(longest, readLine), "none");
  EXPECT_EQ(textRefusal(longest + 'a', readLine), "it: line 1: the line is longer than 64 kB");
  const auto readLongLine = [](TextCursor& cursor) {
    cursor.allowLongLines();
    cursor.nextLine();
  };
  EXPECT_EQ(textRefusal(longest + 'a', readLongLine), "none");
  EXPECT_EQ(textRefusal(longest + 'a' + '\0', readLongLine), "it: line 1: a NUL byte in text");
}

TEST(TextCursorTest, SaysWhereAFileIsCutWithinALine) {
  const auto readTwo = [](TextCursor& cursor) {
    for (int i = 0; i < 2; ++i) static_cast<void>(cursor.toNumber(cursor.wordOfFile()));
  };
  EXPECT_EQ(textRefusal("1 -", readTwo),
            "it: line 1: expected a number, found \"-\"; the file ends here, within a line");
  EXPECT_EQ(textRefusal("1 - ", readTwo), "it: line 1: expected a number, found \"-\"");
  EXPECT_EQ(textRefusal("1\n-\n", readTwo), "it: line 2: expected a number, found \"-\"");
}

TEST(TextCursorTest, CountsMustHaveRoomInTheFile) {
  const auto records = [](std::int64_t count) {
    return [=](TextCursor& cursor) { cursor.requireRecords(count, 2, "points"); };
  };
  EXPECT_EQ(textRefusal("1 2 3", records(3)), "none");  // without a last separator
  EXPECT_EQ(textRefusal("1 2 3", records(4)),
            "it: line 1: the file promises 4 points, but only 5 bytes are left");
  EXPECT_EQ(textRefusal("1 2 3", records(-1)), "it: line 1: the number of points is -1");
}

TEST(TextCursorTest, AByteOrderMarkIsNoText) {
  EXPECT_EQ(text::withoutByteOrderMark("\xef\xbb\xbf"
                                       "a"),
            "a");
  EXPECT_EQ(text::withoutByteOrderMark("a"), "a");
}

}  // namespace
}  // namespace cutwater::test
