#include <Cutwater/Render/Detail/CellPicture.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cutwater::detail {

namespace {

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

/// Lines across one axis: what is drawn of each, by its place.
using LineParts = std::map<double, std::vector<Interval<double>>>;

/// Parts that meet or overlap are one, so that a line looks alike whatever it is made of.
std::vector<Interval<double>> joined(std::vector<Interval<double>> parts) {
  std::ranges::sort(parts, {}, &Interval<double>::lower);
  std::vector<Interval<double>> result;
  for (const auto& part : parts) {
    if (result.empty() || part.lower > result.back().upper) {
      result.push_back(part);
    } else {
      result.back().upper = std::max(result.back().upper, part.upper);
    }
  }
  return result;
}

/// Which of these places, in ascending order, are from `lower` up to `upper`.
struct PixelRange {
  int first, end;
};
PixelRange pixelsIn(std::span<const double> places, double lower, double upper) {
  const auto at = [&](double x) {
    return static_cast<int>(std::ranges::lower_bound(places, x) - places.begin());
  };
  return {at(lower), at(upper)};
}

}  // namespace

Rgb bodyColor(int x, int y, double scale) {
  const double across = (x + y) * std::sqrt(0.5);
  const double fromLine = std::abs(std::remainder(across, kHatchSpacing * scale));
  return blended(kBody, kHatch, std::clamp(0.5 * kHatchWidth * scale - fromLine + 0.5, 0.0, 1.0));
}

void CellPicture::drawCells(Image& image) const {
  const auto& area = plot_.area();
  std::vector<double> across;
  std::vector<double> upwards;
  for (int x = 0; x < area.width; ++x) across.push_back(plot_.a(x));
  for (int y = area.height - 1; y >= 0; --y) upwards.push_back(plot_.b(y));
  layer_.eachCell([&](const ShownCell& cell) {
    const auto& [lower, upper] = cell.rectangle;
    const auto right = pixelsIn(across, lower[0], upper[0]);
    const auto up = pixelsIn(upwards, lower[1], upper[1]);
    if (right.first == right.end) return;
    for (int n = up.first; n < up.end; ++n) {
      drawRow(image, cell, right.first, right.end, area.height - 1 - n);
    }
  });
}

void CellPicture::drawGrid(Image& image) const {
  const double least = kLeastBetweenLines * std::max(style_.scale(), 1.0);
  const double perUnit = plot_.x(1) - plot_.x(0);
  const double perUnitUp = plot_.y(0) - plot_.y(1);
  std::array<LineParts, 2> parts;  // across the plane's coordinates
  const auto add = [&](const SliceWindow<double>& box, double leastRight, double leastUp) {
    const auto& [lower, upper] = box;
    for (const auto& end : {lower, upper}) {
      if ((upper[0] - lower[0]) * perUnit >= leastRight) {
        parts[0][end[0]].push_back({lower[1], upper[1]});
      }
      if ((upper[1] - lower[1]) * perUnitUp >= leastUp) {
        parts[1][end[1]].push_back({lower[0], upper[0]});
      }
    }
  };
  add(layer_.window(), 0, 0);
  layer_.eachCell([&](const ShownCell& cell) { add(cell.rectangle, least, least); });
  std::vector<Stroke> lines;
  for (const std::size_t across : {0U, 1U}) {
    for (const auto& [place, some] : parts.at(across)) {
      for (const auto& [lower, upper] : joined(some)) {
        const auto line = across == 0 ? plot_.stroke({place, lower}, {place, upper})
                                      : plot_.stroke({lower, place}, {upper, place});
        if (const auto shown = clipped(line, plot_.area())) lines.push_back(*shown);
      }
    }
  }
  image.drawStrokes(lines, std::max(style_.scale(), 1.0), kGridLine);
}

void CellPicture::drawWall(Image& image) const {
  std::vector<Stroke> lines;
  for (const auto& cell : layer_.cells()) {
    for (const auto& segment : cell.segments) {
      const auto line = plot_.stroke(segment.from, segment.to);
      if (const auto shown = clipped(line, plot_.area())) lines.push_back(*shown);
    }
  }
  image.drawStrokes(lines, std::max(kWallWidth * style_.scale(), 1.0), kWall);
}

void CellPicture::drawMarks(Image& image) const {
  std::vector<Stroke> frames;
  std::vector<PlanePoint> dots;
  double least = 1e9;
  const auto& area = plot_.area();
  for (const auto& cell : layer_.cells()) {
    const auto [lower, upper] = layer_.rectangle(cell.row);
    const Stroke box{plot_.x(lower[0]), plot_.y(upper[1]), plot_.x(upper[0]), plot_.y(lower[1])};
    if (box.x0 < area.x0 - 0.5 || box.x1 > area.x0 + area.width + 0.5 || box.y0 < area.y0 - 0.5 ||
        box.y1 > area.y0 + area.height + 0.5) {
      continue;
    }
    least = std::min({least, box.x1 - box.x0, box.y1 - box.y0});
    if (pieces(cell.row) > 1) frames.push_back(box);
    if (layer_.rows().isThin(cell.row)) {
      dots.push_back({0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)});
    }
  }
  drawFrames(image, frames);
  drawDots(image, dots, std::min(dotRadius(), 0.3 * least));
}

void CellPicture::drawFrames(Image& image, std::span<const Stroke> boxes) const {
  std::vector<Stroke> sides;
  for (const auto& box : boxes) {
    const double inset = std::min(0.5 * (kFrameWidth + 1) * style_.scale(),
                                  0.25 * std::min(box.x1 - box.x0, box.y1 - box.y0));
    const double x0 = box.x0 + inset, x1 = box.x1 - inset;
    const double y0 = box.y0 + inset, y1 = box.y1 - inset;
    sides.insert(sides.end(),
                 {{x0, y0, x1, y0}, {x1, y0, x1, y1}, {x1, y1, x0, y1}, {x0, y1, x0, y0}});
  }
  image.drawStrokes(sides, std::max(kFrameWidth * style_.scale(), 1.0), kMark);
}

void CellPicture::drawDots(Image& image, std::span<const PlanePoint> places, double radius) const {
  std::vector<Stroke> dots;
  for (const auto& at : places) dots.push_back({at[0], at[1], at[0], at[1]});
  image.drawStrokes(dots, 2 * radius + 2.4 * style_.scale(), kMarkRim);
  image.drawStrokes(dots, 2 * radius, kMark);
}

double CellPicture::dotRadius() const {
  return kDot * style_.scale();
}

CellTally CellPicture::counts() const {
  CellTally counts{.cut = layer_.cells().size()};
  for (const auto& cell : layer_.cells()) {
    counts.multiPiece += pieces(cell.row) > 1 ? 1 : 0;
    counts.thin += layer_.rows().isThin(cell.row) ? 1 : 0;
  }
  return counts;
}

std::uint32_t CellPicture::pieces(std::uint32_t row) const {
  return layer_.rows().firstPiece(row + std::size_t{1}) - layer_.rows().firstPiece(row);
}

double CellPicture::shareOf(std::uint32_t row) const {
  double sum = 0;
  for (std::uint32_t n = 0; n < pieces(row); ++n) {
    sum += layer_.rows().volumeFraction(layer_.rows().firstPiece(row) + n);
  }
  return sum;
}

void CellPicture::drawRow(Image& image, const ShownCell& cell, int x0, int x1, int y) const {
  const auto& area = plot_.area();
  const auto* const section = cell.row == CutCells::kNoRow ? nullptr : &layer_.section(cell.row);
  const double share = section == nullptr ? 0 : shareOf(cell.row);
  for (int x = x0; x < x1; ++x) {
    const auto body = bodyColor(x, y, style_.scale());
    auto& pixel = image.at(area.x0 + x, area.y0 + y);
    if (section == nullptr) {
      pixel = cell.isFluid ? kFluidColor : body;
      continue;
    }
    const auto side = section->at({plot_.a(x), plot_.b(y)});
    pixel = fluidFractionColor(side.isFluid ? layer_.rows().volumeFraction(side.piece) : share);
    if (!side.isFluid) pixel = blended(pixel, body, kBodyTint);
  }
}

}  // namespace cutwater::detail
