#include <Cutwater/Render/StrokeFont.hpp>

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

TEST(StrokeFontTest, EveryCharacterLooksDifferent) {
  std::map<std::string, char> seen;
  for (char c = ' '; c <= '~'; ++c) {
    Image image(40, 50);
    drawText(image, 8, 35, std::string(1, c), {.capHeight = 24, .weight = 2});
    std::string reds;
    for (const auto& p : image.pixels()) reds.push_back(static_cast<char>(p.red));
    const auto [other, isNew] = seen.emplace(reds, c);
    // In this font a bar is a long l, and a capital I a short one.
    EXPECT_TRUE(isNew || (c == 'l' && other->second == 'I'))
        << c << " looks like " << other->second;
  }
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

TEST(StrokeFontTest, OneMarkPerCharacterBeyondAscii) {
  EXPECT_EQ(textLength("\u00e4\u6f22", 10), textLength("??", 10));
  EXPECT_EQ(textLength("\n", 10), textLength("?", 10));
  EXPECT_EQ(textLength("", 10), 0);
}

}  // namespace
}  // namespace cutwater::test
