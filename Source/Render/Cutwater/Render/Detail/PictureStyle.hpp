#pragma once

#include <Cutwater/Render/Detail/StrokeFont.hpp>
#include <Cutwater/Render/Image.hpp>

/// Common style of pictures with text and lines; for use within this folder only.
namespace cutwater::detail {

inline constexpr Rgb kInk{38, 42, 48};
inline constexpr Rgb kFaintInk{105, 110, 118};

// Heights of capitals and widths of lines in pixels, at scale 1.
inline constexpr double kNumbers = 10.5;
inline constexpr double kLabels = 12;
inline constexpr double kTitle = 17;
inline constexpr double kFrameLine = 1.2;

/// A part of a picture: pixels [x0, x0 + width) x [y0, y0 + height).
struct PlotArea {
  int x0, y0;
  int width, height;
};

/// Sizes of text and lines. All scale with the picture, so that a large one looks like a small one.
class PictureStyle {
 public:
  PictureStyle(int width, int height);

  /// Scale of lines and text relative to their usual thickness.
  [[nodiscard]] double scale() const { return scale_; }
  /// A scaled length in whole pixels.
  [[nodiscard]] int px(double length) const;
  [[nodiscard]] TextStyle text(double capHeight, TextAnchor anchor) const;
  [[nodiscard]] TextStyle upwardsText(double capHeight) const;

  void drawLine(Image& image, const Stroke& line, double width, const Rgb& color = kInk) const;
  void drawFrame(Image& image, const PlotArea& area) const;
  /// Draws a heading from (x, y) on, smaller if it would not fit into the picture otherwise.
  void drawHeading(Image& image, double x, double y, std::string_view title) const;

 private:
  double scale_;
};

}  // namespace cutwater::detail
