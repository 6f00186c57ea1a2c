#include <Cutwater/Render/Detail/PictureStyle.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

PictureStyle::PictureStyle(int width, int height)
    : scale_(std::clamp(std::min(width, height) / 900.0, 0.5, 8.0)) {}

int PictureStyle::px(double length) const {
  return static_cast<int>(std::lround(length * scale_));
}

TextStyle PictureStyle::text(double capHeight, TextAnchor anchor) const {
  const double height = std::max(capHeight * scale_, 7.0);  // smaller text is illegible
  return {.capHeight = height,
          .weight = std::max(0.12 * height, 1.0),
          .color = kInk,
          .anchor = anchor,
          .upwards = false};
}

TextStyle PictureStyle::upwardsText(double capHeight) const {
  auto style = text(capHeight, TextAnchor::Middle);
  style.upwards = true;
  return style;
}

void PictureStyle::drawLine(Image& image, const Stroke& line, double width,
                            const Rgb& color) const {
  image.drawStrokes(std::span(&line, 1), std::max(width * scale_, 1.0), color);
}

void PictureStyle::drawFrame(Image& image, const PlotArea& area) const {
  const double x0 = area.x0, y0 = area.y0;
  const double x1 = x0 + area.width, y1 = y0 + area.height;
  for (const auto& side : {Stroke{x0, y0, x1, y0}, Stroke{x1, y0, x1, y1}, Stroke{x1, y1, x0, y1},
                           Stroke{x0, y1, x0, y0}}) {
    drawLine(image, side, kFrameLine);
  }
}

void PictureStyle::drawHeading(Image& image, double x, double y, std::string_view title) const {
  auto heading = text(kTitle, TextAnchor::Start);
  const double room = image.width() - x - px(20);
  heading.capHeight *= std::min(1.0, room / std::max(textLength(title, heading.capHeight), 1.0));
  drawText(image, x, y, title, heading);
}

}  // namespace cutwater::detail
