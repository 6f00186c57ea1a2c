#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/CellLayer.hpp>
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
using detail::PictureStyle;
using detail::PlanePoint;
using detail::PlotArea;

constexpr Rgb kFluid{250, 251, 252};
constexpr Rgb kBody{150, 155, 163};
constexpr Rgb kHatch{112, 118, 128};
constexpr Rgb kGridLine{196, 201, 207};
constexpr Rgb kWall{16, 18, 24};
constexpr Rgb kMark{214, 0, 110};
constexpr Rgb kMarkRim{255, 255, 255};
constexpr double kBodyTint = 0.62;   // of the body's colour in its part of a cut cell
constexpr double kHatchSpacing = 7;  // pixels at scale 1, as all that follow
constexpr double kHatchWidth = 1.1;
constexpr double kWallWidth = 2.2;
constexpr double kFrameWidth = 2.0;  // around cells with several pieces
constexpr double kDot = 3.4;         // the radius of that in thin cells
constexpr double kLeastBetweenLines = 4;

/// Where the plane's points are on the plot.
class CellPlot {
 public:
  CellPlot(const PlotArea& area, const Interval<double>& right, const Interval<double>& up)
      : area_(area), right_(right), up_(up) {}

  [[nodiscard]] const PlotArea& area() const { return area_; }
  [[nodiscard]] double x(double a) const {
    return area_.x0 + area_.width * (a - right_.lower) / (right_.upper - right_.lower);
  }
  [[nodiscard]] double y(double b) const {
    return area_.y0 + area_.height * (up_.upper - b) / (up_.upper - up_.lower);
  }
  /// The middle of a pixel, counted from the plot's upper left corner.
  [[nodiscard]] double a(int x) const {
    return right_.lower + (x + 0.5) / area_.width * (right_.upper - right_.lower);
  }
  [[nodiscard]] double b(int y) const {
    return up_.upper - (y + 0.5) / area_.height * (up_.upper - up_.lower);
  }
  [[nodiscard]] Stroke stroke(const PlanePoint& from, const PlanePoint& to) const {
    return {x(from[0]), y(from[1]), x(to[0]), y(to[1])};
  }

 private:
  PlotArea area_;
  Interval<double> right_;
  Interval<double> up_;
};

/// Which cell along an axis has this place; nothing beyond the box.
std::optional<std::size_t> placeOf(std::span<const double> planes, double at) {
  const auto after = std::ranges::upper_bound(planes, at) - planes.begin();
  if (after == 0 || after == std::ssize(planes)) return {};
  return static_cast<std::size_t>(after - 1);
}

/// The body, hatched at 45 degrees.
Rgb bodyColor(int x, int y, double scale) {
  const double across = (x + y) * std::sqrt(0.5);
  const double fromLine = std::abs(std::remainder(across, kHatchSpacing * scale));
  return blended(kBody, kHatch, std::clamp(0.5 * kHatchWidth * scale - fromLine + 0.5, 0.0, 1.0));
}

class CellPicture {
 public:
  CellPicture(const CutCells& cells, const CellLayer& layer, const CellPlot& plot,
              const PictureStyle& style)
      : cells_(cells), layer_(layer), plot_(plot), style_(style) {}

  void drawCells(Image& image) const {
    const auto& area = plot_.area();
    std::vector<std::optional<std::size_t>> columns;
    for (int x = 0; x < area.width; ++x) columns.push_back(placeOf(layer_.planes(0), plot_.a(x)));
    for (int y = 0; y < area.height; ++y) {
      const auto up = placeOf(layer_.planes(1), plot_.b(y));
      for (int x = 0; x < area.width;) {
        const auto& right = columns[static_cast<std::size_t>(x)];
        int end = x + 1;
        while (end < area.width && columns[static_cast<std::size_t>(end)] == right) ++end;
        if (up && right) drawRow(image, layer_.cellAt(*right, *up), x, end, y);
        x = end;
      }
    }
  }

  /// Lines of the grid, unless they are too close to each other to tell cells apart.
  void drawGrid(Image& image) const {
    std::vector<Stroke> lines;
    const auto add = [&](const Stroke& line) {
      if (const auto shown = detail::clipped(line, plot_.area())) lines.push_back(*shown);
    };
    const auto across = layer_.planes(0);
    const auto upwards = layer_.planes(1);
    const double least = kLeastBetweenLines * std::max(style_.scale(), 1.0);
    const auto isWide = [&](std::span<const double> planes, std::size_t n, double perUnit) {
      return n == 0 || n + 1 == planes.size() || (planes[n + 1] - planes[n]) * perUnit >= least;
    };
    const double perUnit = plot_.x(1) - plot_.x(0);
    const double perUnitUp = plot_.y(0) - plot_.y(1);
    for (std::size_t n = 0; n < across.size(); ++n) {
      if (!isWide(across, n, perUnit)) continue;
      add(plot_.stroke({across[n], upwards.front()}, {across[n], upwards.back()}));
    }
    for (std::size_t n = 0; n < upwards.size(); ++n) {
      if (!isWide(upwards, n, perUnitUp)) continue;
      add(plot_.stroke({across.front(), upwards[n]}, {across.back(), upwards[n]}));
    }
    image.drawStrokes(lines, std::max(style_.scale(), 1.0), kGridLine);
  }

  void drawWall(Image& image) const {
    std::vector<Stroke> lines;
    for (const auto& cell : layer_.cells()) {
      for (const auto& segment : cell.segments) {
        const auto line = plot_.stroke(segment.from, segment.to);
        if (const auto shown = detail::clipped(line, plot_.area())) lines.push_back(*shown);
      }
    }
    image.drawStrokes(lines, std::max(kWallWidth * style_.scale(), 1.0), kWall);
  }

  void drawMarks(Image& image) const {
    std::vector<Stroke> frames;
    std::vector<Stroke> dots;
    double least = 1e9;
    for (const auto& cell : layer_.cells()) {
      const auto [lower, upper] = layer_.rectangle(cell.row);
      const double x0 = plot_.x(lower[0]), x1 = plot_.x(upper[0]);
      const double y0 = plot_.y(upper[1]), y1 = plot_.y(lower[1]);
      const auto& area = plot_.area();
      if (x0 < area.x0 - 0.5 || x1 > area.x0 + area.width + 0.5 || y0 < area.y0 - 0.5 ||
          y1 > area.y0 + area.height + 0.5) {
        continue;
      }
      least = std::min({least, x1 - x0, y1 - y0});
      if (pieces(cell.row) > 1) addFrame({x0, y0, x1, y1}, frames);
      if (cells_.cells.isThin(cell.row)) {
        dots.push_back({0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (x0 + x1), 0.5 * (y0 + y1)});
      }
    }
    image.drawStrokes(frames, std::max(kFrameWidth * style_.scale(), 1.0), kMark);
    drawDots(image, dots, std::min(kDot * style_.scale(), 0.3 * least));
  }
  void drawDots(Image& image, std::span<const Stroke> dots, double radius) const {
    image.drawStrokes(dots, 2 * radius + 2.4 * style_.scale(), kMarkRim);
    image.drawStrokes(dots, 2 * radius, kMark);
  }
  void addFrame(const Stroke& box, std::vector<Stroke>& to) const {
    const double inset = std::min(0.5 * kFrameWidth * style_.scale() + 0.5 * style_.scale(),
                                  0.25 * std::min(box.x1 - box.x0, box.y1 - box.y0));
    const double x0 = box.x0 + inset, x1 = box.x1 - inset;
    const double y0 = box.y0 + inset, y1 = box.y1 - inset;
    for (const auto& side : {Stroke{x0, y0, x1, y0}, Stroke{x1, y0, x1, y1}, Stroke{x1, y1, x0, y1},
                             Stroke{x0, y1, x0, y0}}) {
      to.push_back(side);
    }
  }

  /// How many cells of the layer are cut, have several pieces, are thin.
  struct Counts {
    std::size_t cut = 0, multiPiece = 0, thin = 0;
  };
  [[nodiscard]] Counts counts() const {
    Counts counts{.cut = layer_.cells().size()};
    for (const auto& cell : layer_.cells()) {
      counts.multiPiece += pieces(cell.row) > 1 ? 1 : 0;
      counts.thin += cells_.cells.isThin(cell.row) ? 1 : 0;
    }
    return counts;
  }

 private:
  [[nodiscard]] std::uint32_t pieces(std::uint32_t row) const {
    return cells_.cells.firstPiece[row + std::size_t{1}] - cells_.cells.firstPiece[row];
  }

  /// Of all fluid in the cell.
  [[nodiscard]] double shareOf(std::uint32_t row) const {
    double sum = 0;
    for (std::uint32_t n = 0; n < pieces(row); ++n) {
      sum += cells_.volumeFraction(cells_.cells.firstPiece[row] + n);
    }
    return sum;
  }

  /// The pixels [x0, x1) of a line that lie in a cell.
  void drawRow(Image& image, const Index3& cell, int x0, int x1, int y) const {
    const auto& area = plot_.area();
    const auto row = cells_.rowOf(cell);
    const bool isFluid = row == CutCells::kNoRow && cells_.classOf(cell) == FluidClass::Fluid;
    const auto* const section = row == CutCells::kNoRow ? nullptr : &layer_.section(row);
    const double share = section == nullptr ? 0 : shareOf(row);
    for (int x = x0; x < x1; ++x) {
      const auto body = bodyColor(x, y, style_.scale());
      auto& pixel = image.at(area.x0 + x, area.y0 + y);
      if (section == nullptr) {
        pixel = isFluid ? kFluid : body;
        continue;
      }
      const auto side = section->at({plot_.a(x), plot_.b(y)});
      pixel = detail::fluidFractionColor(side.isFluid ? cells_.volumeFraction(side.piece) : share);
      if (!side.isFluid) pixel = blended(pixel, body, kBodyTint);
    }
  }

  const CutCells& cells_;
  const CellLayer& layer_;
  const CellPlot& plot_;
  const PictureStyle& style_;
};

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
  image.fillRectangle(x0, fluid.y0, x1, fluid.y0 + swatch, kFluid);
  label(fluid.y0 + 0.5 * swatch, "fluid");
  for (int y = body.y0; y < body.y0 + swatch; ++y) {
    for (int x = x0; x < x1; ++x) image.at(x, y) = bodyColor(x, y, style.scale());
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
    std::vector<Stroke> frame;
    picture.addFrame({x, middle - half, x + 2 * half, middle + half}, frame);
    image.drawStrokes(frame, std::max(kFrameWidth * style.scale(), 1.0), kMark);
    x += 2 * half + style.px(7);
    say(std::to_string(counts.multiPiece) + " in several pieces");
  }
  if (counts.thin > 0) {
    x += style.px(20);
    const double radius = kDot * style.scale();
    const Stroke dot{x + radius, middle, x + radius, middle};
    picture.drawDots(image, std::span(&dot, 1), radius);
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
