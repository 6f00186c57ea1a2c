#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/CellPicture.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <algorithm>
#include <cmath>

// renderCells().

namespace cutwater {

namespace {

using detail::CellLayer;
using detail::CellPicture;
using detail::CellPlot;
using detail::PictureStyle;
using detail::PlotArea;

/// Fluid, all shares of it in a cut cell, and body, beside the plot.
void drawKey(Image& image, const PlotArea& plot, const PictureStyle& style) {
  const int x0 = plot.x0 + plot.width + style.px(28);
  const int x1 = x0 + style.px(24);
  const int gap = style.px(9);
  const int swatch = style.px(24);
  const auto label = [&](double y, const std::string& text) {
    drawText(image, x1 + style.px(12), y + style.px(0.5 * detail::kNumbers), text,
             style.text(detail::kNumbers, TextAnchor::Start));
  };
  const PlotArea fluid{x0, plot.y0, x1 - x0, swatch};
  const PlotArea body{x0, plot.y0 + plot.height - swatch, x1 - x0, swatch};
  const PlotArea bar{x0, fluid.y0 + swatch + gap, x1 - x0, body.y0 - fluid.y0 - swatch - 2 * gap};
  image.fillRectangle(x0, fluid.y0, x1, fluid.y0 + swatch, detail::kFluidColor);
  label(fluid.y0 + 0.5 * swatch, "fluid");
  for (int y = body.y0; y < body.y0 + swatch; ++y) {
    for (int x = x0; x < x1; ++x) image.at(x, y) = detail::bodyColor(x, y, style.scale());
  }
  label(body.y0 + 0.5 * swatch, "body");
  for (int y = 0; y < bar.height; ++y) {
    image.fillRectangle(x0, bar.y0 + y, x1, bar.y0 + y + 1,
                        detail::fluidFractionColor(1 - (y + 0.5) / bar.height));
  }
  for (const auto& tick : ticksBetween(0, 1, 0.2)) {
    const double y = bar.y0 + (1 - tick.value) * bar.height;
    style.drawLine(image, {static_cast<double>(x1), y, x1 + style.px(6.0) * 1.0, y},
                   detail::kFrameLine);
    label(y, tick.label);
  }
  for (const auto& area : {fluid, bar, body}) style.drawFrame(image, area);
  drawText(image, x1 + style.px(88), bar.y0 + 0.5 * bar.height, "volume fraction of fluid",
           style.upwardsText(detail::kLabels));
}

/// The width that all of these have; 0 if they differ.
double widthOf(std::span<const double> planes) {
  const double mean = (planes.back() - planes.front()) / static_cast<double>(planes.size() - 1);
  for (std::size_t n = 1; n < planes.size(); ++n) {
    if (std::abs(planes[n] - planes[n - 1] - mean) > 1e-6 * mean) return 0;
  }
  return mean;
}

/// The size of the cells, and what the marks mean.
void drawNote(Image& image, const PlotArea& plot, const CellLayer& layer,
              const CellPicture& picture, const CellSliceOptions& options,
              const PictureStyle& style) {
  auto ink = style.text(detail::kNumbers, TextAnchor::Start);
  ink.color = detail::kFaintInk;
  double x = plot.x0;
  const double y = plot.y0 - style.px(14);
  const auto say = [&](const std::string& text) {
    drawText(image, x, y, text, ink);
    x += textLength(text, ink.capHeight);
  };
  const double right = widthOf(layer.planes(0));
  const double up = widthOf(layer.planes(1));
  const auto counts = picture.counts();
  const bool isSquare = std::abs(right - up) < 1e-6 * right;
  const auto size = right > 0 && up > 0
                        ? "cells of " + (isSquare ? "" : lengthLabel(right, "") + " x ") +
                              lengthLabel(up, options.unit) + ", "
                        : "";
  say(size + std::to_string(counts.cut) + " cut");
  const double middle = y - 0.5 * ink.capHeight;
  if (counts.multiPiece > 0) {
    x += style.px(20);
    const double half = 0.6 * ink.capHeight;
    const Stroke box{x, middle - half, x + 2 * half, middle + half};
    picture.drawFrames(image, std::span(&box, 1));
    x += 2 * half + style.px(7);
    say(std::to_string(counts.multiPiece) + " in several pieces");
  }
  if (counts.thin > 0) {
    x += style.px(20);
    const double radius = picture.dotRadius();
    const detail::PlanePoint place{x + radius, middle};
    picture.drawDots(image, std::span(&place, 1), radius);
    x += 2 * radius + style.px(7);
    say(std::to_string(counts.thin) + " with all corners on one side");
  }
}

}  // namespace

Image renderCells(const CutCells& cells, int axis, std::int32_t index,
                  const CellSliceOptions& options) {
  require(options.width >= 320 && options.height >= 240,
          "renderCells: need at least 320 x 240 pixels", Named{"width", options.width},
          Named{"height", options.height});
  const CellLayer layer(cells, axis, index);
  Image image(options.width, options.height);
  const detail::SliceLayout layout(options.width, options.height);
  const PictureStyle style(options.width, options.height);
  const auto across = layer.planes(0);
  const auto upwards = layer.planes(1);
  const SliceWindow<double> all{{across.front(), upwards.front()}, {across.back(), upwards.back()}};
  const auto window = options.window.value_or(all);
  const auto right = detail::checkedRange(window, 0);
  const auto up = detail::checkedRange(window, 1);
  const CellPlot plot(detail::fitted(layout.room(), right, up), right, up);
  const CellPicture picture(cells, layer, plot, style);
  picture.drawCells(image);
  picture.drawGrid(image);
  picture.drawWall(image);
  picture.drawMarks(image);
  const auto labels = SlicePlane<double>::across(axis, layer.middle()).labels;
  const auto inUnits = [&](const std::string& name) {
    return options.unit.empty() ? name : name + " [" + options.unit + "]";
  };
  layout.drawAxes(image, plot.area(), {right, up}, {inUnits(labels[0]), inUnits(labels[1])});
  drawKey(image, plot.area(), style);
  layout.drawTitle(image, plot.area(), options.title, "");
  drawNote(image, plot.area(), layer, picture, options, style);
  return image;
}

}  // namespace cutwater
