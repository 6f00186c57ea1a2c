#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Image.hpp>

#include <array>

#include <gtest/gtest.h>

#include "Colors.hpp"

namespace cutwater::test {
namespace {

double darkness(const Image& image) {
  double sum = 0;
  for (const auto& p : image.pixels()) sum += (255.0 - p.red) / 255;
  return sum;
}

TEST(ImageTest, BlendsFromBaseToPaint) {
  EXPECT_EQ(blended({10, 20, 30}, {110, 220, 0}, 0), (Rgb{10, 20, 30}));
  EXPECT_EQ(blended({10, 20, 30}, {110, 220, 0}, 1), (Rgb{110, 220, 0}));
  EXPECT_EQ(blended({10, 20, 30}, {110, 220, 0}, 0.5), (Rgb{60, 120, 15}));
  EXPECT_EQ(blended(kWhite, kBlack, 7), kBlack);
}

TEST(ImageTest, FillsExactlyTheRectangleThatIsInThePicture) {
  Image image(5, 4);
  image.fillRectangle(3, -2, 9, 2, kBlack);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(image.at(x, y), x >= 3 && y < 2 ? kBlack : kWhite);
  }
}

TEST(ImageTest, AStrokeCoversItsAreaWhereverItLies) {
  for (const double shift : {0.0, 0.25, 0.5, 0.7}) {
    Image image(80, 20);
    const std::array strokes{Stroke{10 + shift, 10 + shift, 60 + shift, 10 + shift}};
    image.drawStrokes(strokes, 3, kBlack);
    EXPECT_NEAR(darkness(image), 50 * 3 + 0.25 * 3.1416 * 9, 2) << shift;  // and two half discs
    EXPECT_EQ(image.at(35, 10), kBlack);
    EXPECT_EQ(image.at(35, 14), kWhite);
  }
}

TEST(ImageTest, OverlappingStrokesPaintOnce) {
  Image once(40, 40);
  Image twice(40, 40);
  const Stroke slanted{5.3, 4.1, 33.7, 29.9};
  const std::array one{slanted};
  const std::array two{slanted, Stroke{slanted.x1, slanted.y1, slanted.x0, slanted.y0}};
  once.drawStrokes(one, 1.4, kBlack);
  twice.drawStrokes(two, 1.4, kBlack);
  EXPECT_TRUE(std::equal(once.pixels().begin(), once.pixels().end(), twice.pixels().begin()));
}

TEST(ImageTest, LeavesOutWhatLiesOutside) {
  Image image(10, 10);
  const std::array far{Stroke{-1e300, -50, 1e300, -50}, Stroke{100, 100, 1e9, 1e9}};
  image.drawStrokes(far, 2, kBlack);
  EXPECT_EQ(darkness(image), 0);
}

TEST(ImageTest, RefusesImpossibleSizes) {
  EXPECT_THROW(Image(0, 10), Error);
  EXPECT_THROW(Image(10, -1), Error);
  EXPECT_THROW(Image(10, Image::kMaxSize + 1), Error);
}

TEST(ImageTest, WhatIsNotPaintedStaysTransparent) {
  auto image = Image::transparent(4, 3);
  image.paint(1, 1, {200, 0, 0}, 0.5);
  image.paint(1, 1, {0, 200, 0}, 0.5);  // over it: two parts of this to one of that
  EXPECT_EQ(image.at(1, 1), (Rgb{67, 133, 0}));
  EXPECT_EQ(image.opacities()[5], 192);
  image.fillRectangle(2, 0, 4, 1, {1, 2, 3});
  EXPECT_EQ(image.opacities()[3], 255);
  EXPECT_EQ(image.opacities()[0], 0);
  EXPECT_TRUE(Image(4, 3).opacities().empty());
}

}  // namespace
}  // namespace cutwater::test
