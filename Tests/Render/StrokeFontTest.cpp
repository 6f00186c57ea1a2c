#include <Cutwater/Render/Detail/StrokeFont.hpp>

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

struct Ink {
  int x0 = 1000, y0 = 1000, x1 = -1, y1 = -1;  // pixels that are not white, both ends included
};

Ink inkOf(const Image& image) {
  Ink ink;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.at(x, y) == Rgb{255, 255, 255}) continue;
      ink = {std::min(ink.x0, x), std::min(ink.y0, y), std::max(ink.x1, x), std::max(ink.y1, y)};
    }
  }
  return ink;
}

std::string utf8(unsigned code) {
  if (code < 0x80) return {static_cast<char>(code)};
  return {static_cast<char>(0xC0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3FU))};
}

TEST(StrokeFontTest, EveryCharacterLooksDifferent) {
  std::vector<unsigned> codes{0xB0, 0xB1, 0xB2, 0xB3, 0xB5, 0xB7};
  for (unsigned c = ' '; c <= '~'; ++c) codes.push_back(c);
  for (unsigned c = 0xC0; c <= 0xFF; ++c) codes.push_back(c);
  std::map<std::string, unsigned> seen;
  for (const auto c : codes) {
    Image image(50, 60);
    drawText(image, 8, 42, utf8(c), {.capHeight = 24, .weight = 2});
    std::string reds;
    for (const auto& p : image.pixels()) reds.push_back(static_cast<char>(p.red));
    const auto [other, isNew] = seen.emplace(reds, c);
    // In this font a bar is a long l, and a capital I a short one.
    EXPECT_TRUE(isNew || (c == 'l' && other->second == 'I'))
        << utf8(c) << " looks like " << utf8(other->second);
  }
}

TEST(StrokeFontTest, MarksStandOverTheirLetters) {
  const auto drawn = [](const char* text) {
    Image image(60, 60);
    drawText(image, 20, 40, text, {.capHeight = 24, .weight = 2});
    return inkOf(image);
  };
  const auto plain = drawn("U");
  const auto marked = drawn("\u00dc");
  EXPECT_LT(marked.y0, plain.y0 - 3);
  EXPECT_EQ(marked.y1, plain.y1);
  EXPECT_EQ(marked.x0, plain.x0);
  EXPECT_EQ(marked.x1, plain.x1);
  EXPECT_GT(drawn("\u00e7").y1, drawn("c").y1 + 3);
  EXPECT_EQ(drawn("\u00ee").x0, 19);  // wider than its letter
}

TEST(StrokeFontTest, CapitalsStandOnTheBaselineAtTheirHeight) {
  Image image(200, 100);
  drawText(image, 20, 70, "H", {.capHeight = 36, .weight = 2});
  const auto ink = inkOf(image);
  EXPECT_NEAR(ink.y1 + 1, 70 + 1, 1);
  EXPECT_NEAR(ink.y0, 70 - 36 - 1, 1);
  EXPECT_NEAR(ink.x0, 20 - 1, 1);
  EXPECT_NEAR(ink.x1 + 1, 20 + textLength("H", 36) + 1, 1);
}

TEST(StrokeFontTest, AnchorsPlaceTheLine) {
  const std::string text = "Hull H";
  const double length = textLength(text, 20);
  for (const auto& [anchor, start] :
       {std::pair(TextAnchor::Start, 200.0), std::pair(TextAnchor::Middle, 200 - 0.5 * length),
        std::pair(TextAnchor::End, 200 - length)}) {
    Image image(400, 60);
    drawText(image, 200, 40, text, {.capHeight = 20, .weight = 2, .anchor = anchor});
    const auto ink = inkOf(image);
    EXPECT_NEAR(ink.x0, start, 2);
    EXPECT_NEAR(ink.x1, start + length, 2);
  }
}

TEST(StrokeFontTest, UpwardsIsAQuarterTurnToTheLeft) {
  Image level(81, 81);
  Image upwards(81, 81);
  drawText(level, 20.5, 40.5, "Fg", {.capHeight = 20, .weight = 2});
  drawText(upwards, 40.5, 60.5, "Fg", {.capHeight = 20, .weight = 2, .upwards = true});
  for (int y = 0; y < 81; ++y) {
    for (int x = 0; x < 81; ++x) ASSERT_EQ(level.at(x, y), upwards.at(y, 80 - x)) << x << ' ' << y;
  }
}

TEST(StrokeFontTest, OneMarkPerUnknownCharacter) {
  EXPECT_EQ(textLength("\u03a9\u6f22\u00a7", 10), textLength("???", 10));
  EXPECT_EQ(textLength("\u00e4\u00a0", 10), textLength("a ", 10));
  EXPECT_EQ(textLength("\xe4m\xc3", 10), textLength("?m?", 10));  // not UTF-8
  EXPECT_EQ(textLength("\n", 10), textLength("?", 10));
  EXPECT_EQ(textLength("", 10), 0);
}

}  // namespace
}  // namespace cutwater::test
