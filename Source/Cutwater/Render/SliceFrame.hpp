#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Render/Slice.hpp>
#include <Cutwater/Render/StrokeFont.hpp>

#include <array>
#include <string>

/// How renderSlice() works inside; for its parts only.
namespace cutwater::detail {

/// The part of a picture that shows the plane: pixels [x0, x0 + width) x [y0, y0 + height).
struct PlotArea {
  int x0, y0;
  int width, height;
};

/// Between lines of equal distance.
struct LineSpacing {
  double inside;
  double outside;
};

template <std::floating_point T>
Interval<double> axisRange(const SliceWindow<T>& window, std::size_t i) {
  return {static_cast<double>(window.lower[i]), static_cast<double>(window.upper[i])};
}

/// What stands around a plot. All lengths follow the size of the picture, so that a large one looks
/// like a small one.
class SliceLayout {
 public:
  SliceLayout(int width, int height);

  /// Thickness of lines and text relative to their usual one.
  [[nodiscard]] double scale() const { return scale_; }
  /// Where a plot may stand.
  [[nodiscard]] PlotArea room() const { return room_; }

  /// A frame with ticks, numbers and labels to the left and below.
  void drawAxes(Image& image, const PlotArea& plot, const std::array<Interval<double>, 2>& ranges,
                const std::array<std::string, 2>& labels) const;

  /// To the right. The scale is linear on either side of 0; a thin body keeps a readable side of
  /// its own. Ticks stand at lines of equal distance, as many of them as there is room for.
  void drawColorBar(Image& image, const PlotArea& plot, const Interval<double>& values,
                    const LineSpacing& spacing, const std::string& label) const;

  void drawTitle(Image& image, const PlotArea& plot, const std::string& title,
                 const std::string& note) const;

 private:
  [[nodiscard]] int px(double length) const;
  [[nodiscard]] TextStyle text(double capHeight, TextAnchor anchor) const;
  [[nodiscard]] TextStyle upwardsText(double capHeight) const;
  void drawLine(Image& image, const Stroke& line, double width) const;
  void drawFrame(Image& image, const PlotArea& area) const;

  double scale_;
  PlotArea room_;
};

}  // namespace cutwater::detail
