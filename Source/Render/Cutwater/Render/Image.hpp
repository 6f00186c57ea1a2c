#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// A screen colour (sRGB), each component from 0 to 255.
struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb&) const = default;
};

/// The colour of `paint` over `base`; opacity from 0 (base) to 1 (paint).
[[nodiscard]] Rgb blended(const Rgb& base, const Rgb& paint, double opacity);

/// A straight line on a picture, in pixels.
struct Stroke {
  double x0, y0;
  double x1, y1;
};

/// A picture to draw on: x to the right, y downwards, pixel (0, 0) at the top left. In continuous
/// coordinates, pixel (x, y) is the square [x, x + 1] x [y, y + 1]. Anything outside the picture is
/// not drawn.
class Image {
 public:
  /// The largest width and height.
  static constexpr int kMaxSize = 32768;

  /// @throws Error unless 1 <= width, height <= kMaxSize.
  Image(int width, int height, const Rgb& background = {255, 255, 255});

  /// A picture that is transparent where nothing is drawn: its pixels have an opacity.
  /// @throws Error as above.
  [[nodiscard]] static Image transparent(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// The pixels, row by row from the top.
  [[nodiscard]] std::span<const Rgb> pixels() const { return pixels_; }

  /// From 0, transparent, to 255, row by row; empty if the picture is opaque everywhere.
  [[nodiscard]] std::span<const std::uint8_t> opacities() const { return opacities_; }

  /// The pixel must be in the picture. Its opacity does not depend on its colour.
  [[nodiscard]] const Rgb& at(int x, int y) const { return pixels_[index(x, y)]; }
  [[nodiscard]] Rgb& at(int x, int y) { return pixels_[index(x, y)]; }

  /// Paints over the pixel, which must be in the picture; coverage from 0 to 1.
  void paint(int x, int y, const Rgb& color, double coverage);

  /// Fills the pixels [x0, x1) x [y0, y1).
  void fillRectangle(int x0, int y0, int x1, int y1, const Rgb& color);

  /// Draws anti-aliased lines with round ends, in one coat: pixels where they overlap are painted
  /// once. `width` in pixels.
  void drawStrokes(std::span<const Stroke> strokes, double width, const Rgb& color);

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  int width_;
  int height_;
  std::vector<Rgb> pixels_;
  std::vector<std::uint8_t> opacities_;
};

}  // namespace cutwater
