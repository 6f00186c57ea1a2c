#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Png.hpp>

#include <png.h>
#include <vector>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

Image pattern() {
  Image image(37, 23);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y),
                        static_cast<std::uint8_t>(x * y)};
    }
  }
  return image;
}

TEST(PngTest, DecodesToTheSamePixels) {
  const TemporaryFolder folder;
  const auto image = pattern();
  writePng(folder / "a.png", image);
  EXPECT_EQ(folder.fileCount(), 1U);

  png_image decoded{};
  decoded.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&decoded, (folder / "a.png").c_str()), 0);
  ASSERT_EQ(decoded.width, 37U);
  ASSERT_EQ(decoded.height, 23U);
  decoded.format = PNG_FORMAT_RGB;
  std::vector<Rgb> pixels(image.pixels().size());
  ASSERT_NE(png_image_finish_read(&decoded, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), image.pixels().begin()));
}

TEST(PngTest, KeepsOpacities) {
  const TemporaryFolder folder;
  auto image = Image::transparent(5, 4);
  image.paint(1, 2, {200, 100, 50}, 1);
  image.paint(3, 0, {10, 20, 30}, 0.2);
  writePng(folder / "a.png", image);
  png_image decoded{};
  decoded.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&decoded, (folder / "a.png").c_str()), 0);
  decoded.format = PNG_FORMAT_RGBA;
  std::vector<png_byte> bytes(std::size_t{4} * 5 * 4);
  ASSERT_NE(png_image_finish_read(&decoded, nullptr, bytes.data(), 0, nullptr), 0);
  for (std::size_t i = 0; i < 20; ++i) {
    ASSERT_EQ(bytes[4 * i + 3], i == 11 ? 255 : i == 3 ? 51 : 0) << i;
  }
  EXPECT_EQ((std::vector<png_byte>{&bytes[44], &bytes[48]}),
            (std::vector<png_byte>{200, 100, 50, 255}));
  EXPECT_EQ((std::vector<png_byte>{&bytes[12], &bytes[16]}),
            (std::vector<png_byte>{10, 20, 30, 51}));
}

TEST(PngTest, NamesThePathItCannotWrite) {
  const TemporaryFolder folder;
  const auto path = folder / "no/such/a.png";
  try {
    writePng(path, pattern());
    FAIL() << "wrote into a folder that does not exist";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::File);
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos);
  }
}

}  // namespace
}  // namespace cutwater::test
