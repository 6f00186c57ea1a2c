#pragma once

#include <Cutwater/Render/Camera.hpp>
#include <Cutwater/Render/PictureStyle.hpp>

#include <span>
#include <string>
#include <vector>

/// How render() works inside; for its parts only.
namespace cutwater::detail {

struct LegendEntry {
  std::string name;
  Rgb color;
};

/// Where things stand on a picture of a solid, and what is written around it.
class RenderLayout {
 public:
  /// What there is room to be left for.
  struct Parts {
    bool title = false;
    bool axes = false;
    std::span<const std::string> legend;
  };

  RenderLayout(int width, int height, const Parts& parts);

  [[nodiscard]] double scale() const { return style_.scale(); }
  /// Where the solid may be seen.
  [[nodiscard]] const PlotArea& area() const { return area_; }
  /// What all of it is to be fitted to, with some room around.
  [[nodiscard]] Frame frame() const;

  void drawTitle(Image& image, const std::string& title) const;
  /// As many as there is room for, and how many more there are.
  void drawLegend(Image& image, std::span<const LegendEntry> entries) const;
  /// Three arrows along the coordinate axes, those towards the viewer over those that point away.
  void drawAxes(Image& image, const View& view) const;
  /// A line of a round length, in a picture whose pixels have this size.
  void drawScaleBar(Image& image, double pixelSize, const std::string& unit) const;

 private:
  PictureStyle style_;
  PlotArea area_;
  int strip_ = 0;  // height of what is kept free for axes and scale bar
};

}  // namespace cutwater::detail
