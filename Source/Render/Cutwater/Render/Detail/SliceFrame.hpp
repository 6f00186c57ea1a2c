#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Render/Detail/PictureStyle.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <array>
#include <string>

/// Internals of renderSlice(), for its own parts only.
namespace cutwater::detail {

/// The spacing of lines of equal distance.
struct LineSpacing {
  double inside;
  double outside;
};

template <std::floating_point T>
Interval<double> axisRange(const SliceWindow<T>& window, std::size_t i) {
  return {static_cast<double>(window.lower[i]), static_cast<double>(window.upper[i])};
}

/// The annotations around a plot.
class SliceLayout {
 public:
  SliceLayout(int width, int height);

  /// Scale of lines and text relative to their usual thickness.
  [[nodiscard]] double scale() const { return style_.scale(); }
  /// The area in which a plot may be placed.
  [[nodiscard]] PlotArea room() const { return room_; }

  /// Draws a frame with ticks, numbers and labels to the left and below.
  void drawAxes(Image& image, const PlotArea& plot, const std::array<Interval<double>, 2>& ranges,
                const std::array<std::string, 2>& labels) const;

  /// Draws the colour bar to the right. The scale is linear on either side of 0; each side stays
  /// readable, even for a thin body. Ticks are at lines of equal distance, as many as there is room
  /// for.
  void drawColorBar(Image& image, const PlotArea& plot, const Interval<double>& values,
                    const LineSpacing& spacing, const std::string& label) const;

  void drawTitle(Image& image, const PlotArea& plot, const std::string& title,
                 const std::string& note) const;

 private:
  PictureStyle style_;
  PlotArea room_;
};

}  // namespace cutwater::detail
