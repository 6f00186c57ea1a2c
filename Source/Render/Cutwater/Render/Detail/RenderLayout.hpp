#pragma once

#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/Detail/PictureStyle.hpp>

#include <span>
#include <string>
#include <vector>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

struct LegendEntry {
  std::string name;
  Rgb color;
};

/// The layout of a picture of a solid, and the annotations around it.
class RenderLayout {
 public:
  /// The parts that need room.
  struct Parts {
    bool title = false;
    bool axes = false;
    std::span<const std::string> legend;
  };

  RenderLayout(int width, int height, const Parts& parts);

  [[nodiscard]] double scale() const { return style_.scale(); }
  /// The area in which the solid may be visible.
  [[nodiscard]] const PlotArea& area() const { return area_; }
  /// The frame into which the whole solid must fit, with some margin around it.
  [[nodiscard]] Frame frame() const;

  void drawTitle(Image& image, const std::string& title) const;
  /// Draws as many entries as there is room for, and the number of the others.
  void drawLegend(Image& image, std::span<const LegendEntry> entries) const;
  /// Draws three arrows along the coordinate axes, those towards the viewer over those that point
  /// away.
  void drawAxes(Image& image, const View& view) const;
  /// Draws a line of a round length, in a picture whose pixels have this size.
  void drawScaleBar(Image& image, double pixelSize, const std::string& unit) const;

 private:
  PictureStyle style_;
  PlotArea area_;
  int strip_ = 0;  // height reserved for axes and scale bar
};

}  // namespace cutwater::detail
