#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "BarePicture.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class RenderDraftTest : public ::testing::Test {
 protected:
  /// Wires from half a pixel to two wide, in many directions and at heights from one pixel to many
  /// above a wall; plates without thickness, one along the wall and one upright; and a ball, of
  /// which a part is cut off, so that values are mere bounds.
  static Solid<T> thinThings() {
    const double pixel = pixelSize();
    const T thin = T(2e-6);
    Solid<T> solid = Cuboid<T>({-1, -1, T(-0.6)}, {1, 1, T(-0.5)});
    solid = solid | Cuboid<T>({T(-0.9), T(0.5), T(-0.3)}, {T(-0.4), T(0.9), T(-0.3) + thin});
    solid = solid | Cuboid<T>({T(0.5), T(-0.9), T(-0.5)}, {T(0.5) + thin, T(-0.4), T(-0.1)});
    solid = solid | (Sphere<T>({T(-0.6), T(-0.6), T(-0.4)}, T(0.25)) -
                     Cuboid<T>({-1, -1, T(-0.4)}, {T(-0.6), T(-0.6), 0}));
    int number = 0;
    for (const double height : {1.0, 2.0, 5.0, 12.0, 40.0}) {
      for (const double width : {0.5, 1.0, 2.0}) {
        const double turn = 0.41 * number;
        const Vec3<double> middle{-0.7 + 0.1 * number, 0.3 * std::sin(1.7 * number),
                                  -0.5 + height * pixel};
        const Vec3<double> half{0.5 * std::cos(turn), 0.5 * std::sin(turn), 0};
        solid = solid |
                Capsule<T>(Vec3<T>(middle - half), Vec3<T>(middle + half), T(0.5 * width * pixel));
        ++number;
      }
    }
    return solid;
  }
};
TYPED_TEST_SUITE(RenderDraftTest, Precisions);

/// The mean colour of 5 x 5 pixels, on white.
std::array<double, 3> meanAbout(const Image& image, int x, int y) {
  std::array<double, 3> sum{};
  for (int j = y - 2; j <= y + 2; ++j) {
    for (int i = x - 2; i <= x + 2; ++i) {
      const auto color = image.at(i, j);
      sum[0] += color.red / 25.0;
      sum[1] += color.green / 25.0;
      sum[2] += color.blue / 25.0;
    }
  }
  return sum;
}

TYPED_TEST(RenderDraftTest, LooksLikeTheFinalPicture) {
  const auto solid = this->thinThings();
  for (const auto& view :
       {View::named("+z"), View::named("iso"), View::fromAngles(20, 60), View::fromAngles(70, 8)}) {
    for (const double fieldOfView : {0.0, 40.0}) {
      auto options = bare(view);
      options.transparent = false;
      options.fieldOfView = fieldOfView;
      const auto final = render(solid, options);
      options.quality = PictureQuality::Draft;
      const auto draft = render(solid, options);
      double most = 0, sum = 0;
      for (int y = 2; y < kHeight - 2; ++y) {
        for (int x = 2; x < kWidth - 2; ++x) {
          const auto one = meanAbout(final, x, y), other = meanAbout(draft, x, y);
          double difference = 0;
          for (std::size_t k = 0; k < 3; ++k)
            difference = std::max(difference, std::abs(one[k] - other[k]));
          sum += difference;
          most = std::max(most, difference);
        }
      }
      // A wire that is lost differs by about 100, one sample of four in a row of pixels by 30.
      EXPECT_LT(most, 36) << view.back.z << ' ' << fieldOfView;
      EXPECT_LT(sum / (kWidth * kHeight), 0.6) << view.back.z << ' ' << fieldOfView;
    }
  }
}

TYPED_TEST(RenderDraftTest, TheSameWhateverTheThreads) {
  auto options = bare(View::named("iso"));
  options.quality = PictureQuality::Draft;
  options.threads = 1;
  const auto one = render(this->thinThings(), options);
  options.threads = 3;
  const auto more = render(this->thinThings(), options);
  EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), more.pixels().begin()));
  EXPECT_TRUE(std::equal(one.opacities().begin(), one.opacities().end(), more.opacities().begin()));
}

}  // namespace
}  // namespace cutwater::test
