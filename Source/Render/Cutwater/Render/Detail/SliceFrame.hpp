#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Render/Detail/PictureStyle.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <array>
#include <cmath>
#include <optional>
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

/// Of axis i. @throws Error(Argument) unless it is finite and not empty.
template <std::floating_point T>
Interval<double> checkedRange(const SliceWindow<T>& window, std::size_t i) {
  const T size = window.upper[i] - window.lower[i];
  require(std::isfinite(window.lower[i]) && std::isfinite(window.upper[i]) && std::isfinite(size) &&
              size > 0,
          "picture of a plane: need a finite window that is not empty",
          Named{"lower", window.lower[i]}, Named{"upper", window.upper[i]});
  return axisRange(window, i);
}

/// The largest area in the given one with the proportions of these ranges, centred.
[[nodiscard]] PlotArea fitted(const PlotArea& room, const Interval<double>& right,
                              const Interval<double>& up);

/// The part of a line that lies in the area.
[[nodiscard]] std::optional<Stroke> clipped(const Stroke& line, const PlotArea& area);

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
