#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Render/PictureStyle.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <array>
#include <string>

/// How renderSlice() works inside; for its parts only.
namespace cutwater::detail {

/// Between lines of equal distance.
struct LineSpacing {
  double inside;
  double outside;
};

template <std::floating_point T>
Interval<double> axisRange(const SliceWindow<T>& window, std::size_t i) {
  return {static_cast<double>(window.lower[i]), static_cast<double>(window.upper[i])};
}

/// What stands around a plot.
class SliceLayout {
 public:
  SliceLayout(int width, int height);

  /// Thickness of lines and text relative to their usual one.
  [[nodiscard]] double scale() const { return style_.scale(); }
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
  PictureStyle style_;
  PlotArea room_;
};

}  // namespace cutwater::detail
