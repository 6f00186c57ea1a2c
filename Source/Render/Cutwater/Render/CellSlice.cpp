#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/CellPicture.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

/// The least and the largest width and height of cells.
std::array<Interval<double>, 2> sizesIn(const CellLayer& layer) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::array<Interval<double>, 2> sizes{{{kNone, 0}, {kNone, 0}}};
  layer.eachCell([&](const detail::ShownCell& cell) {
    for (std::size_t i = 0; i < 2; ++i) {
      const double size = cell.rectangle.upper[i] - cell.rectangle.lower[i];
      sizes[i] = {std::min(sizes[i].lower, size), std::max(sizes[i].upper, size)};
    }
  });
  return sizes;
}

/// "cells of 0.1 x 0.2 m, ", or of leaves "cells of 0.1 to 0.4 m, "; nothing for cells that grow.
std::string sizeNote(const CellLayer& layer, const std::string& unit) {
  const auto [right, up] = sizesIn(layer);
  const auto isOne = [](const Interval<double>& sizes) {
    return sizes.upper - sizes.lower <= 2e-6 * sizes.upper;
  };
  const auto of = [](const Interval<double>& sizes) { return 0.5 * (sizes.lower + sizes.upper); };
  if (isOne(right) && isOne(up)) {
    const bool isSquare = std::abs(of(right) - of(up)) < 1e-6 * of(right);
    return "cells of " + (isSquare ? "" : lengthLabel(of(right), "") + " x ") +
           lengthLabel(of(up), unit) + ", ";
  }
  if (!layer.rows().areLeaves()) return {};
  return "cells of " + lengthLabel(up.lower, "") + " to " + lengthLabel(up.upper, unit) + ", ";
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
  const auto counts = picture.counts();
  say(sizeNote(layer, options.unit) + std::to_string(counts.cut) + " cut");
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

/// `axis`: across the layer.
Image pictureOf(const CellLayer& layer, int axis, const CellSliceOptions& options) {
  Image image(options.width, options.height);
  const detail::SliceLayout layout(options.width, options.height);
  const PictureStyle style(options.width, options.height);
  const auto window = options.window.value_or(layer.window());
  const auto right = detail::checkedRange(window, 0);
  const auto up = detail::checkedRange(window, 1);
  const CellPlot plot(detail::fitted(layout.room(), right, up), right, up);
  const CellPicture picture(layer, plot, style);
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

void checkSize(const CellSliceOptions& options) {
  require(options.width >= 320 && options.height >= 240,
          "renderCells: need at least 320 x 240 pixels", Named{"width", options.width},
          Named{"height", options.height});
}

}  // namespace

Image renderCells(const CutCells& cells, int axis, std::int32_t index,
                  const CellSliceOptions& options) {
  checkSize(options);
  return pictureOf(CellLayer(cells, axis, index), axis, options);
}

template <std::floating_point T>
Image renderCells(const CutLeaves& leaves, const OctreeCells<T>& mesh, int axis, double at,
                  const CellSliceOptions& options) {
  checkSize(options);
  return pictureOf(CellLayer(leaves, mesh, axis, at), axis, options);
}

template Image renderCells(const CutLeaves&, const OctreeCells<float>&, int, double,
                           const CellSliceOptions&);
template Image renderCells(const CutLeaves&, const OctreeCells<double>&, int, double,
                           const CellSliceOptions&);

}  // namespace cutwater
