#include <Cutwater/Render/Detail/CellPicture.hpp>
#include <Cutwater/Render/Detail/ColorMap.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

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

/// Which cell along an axis has this place; nothing beyond the box.
std::optional<std::size_t> placeOf(std::span<const double> planes, double at) {
  const auto after = std::ranges::upper_bound(planes, at) - planes.begin();
  if (after == 0 || after == std::ssize(planes)) return {};
  return static_cast<std::size_t>(after - 1);
}

}  // namespace

Rgb bodyColor(int x, int y, double scale) {
  const double across = (x + y) * std::sqrt(0.5);
  const double fromLine = std::abs(std::remainder(across, kHatchSpacing * scale));
  return blended(kBody, kHatch, std::clamp(0.5 * kHatchWidth * scale - fromLine + 0.5, 0.0, 1.0));
}

void CellPicture::drawCells(Image& image) const {
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

void CellPicture::drawGrid(Image& image) const {
  std::vector<Stroke> lines;
  const auto add = [&](const Stroke& line) {
    if (const auto shown = clipped(line, plot_.area())) lines.push_back(*shown);
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
    if (cells_.cells.isThin(cell.row)) {
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

CellCounts CellPicture::counts() const {
  CellCounts counts{.cut = layer_.cells().size()};
  for (const auto& cell : layer_.cells()) {
    counts.multiPiece += pieces(cell.row) > 1 ? 1 : 0;
    counts.thin += cells_.cells.isThin(cell.row) ? 1 : 0;
  }
  return counts;
}

std::uint32_t CellPicture::pieces(std::uint32_t row) const {
  return cells_.cells.firstPiece[row + std::size_t{1}] - cells_.cells.firstPiece[row];
}

double CellPicture::shareOf(std::uint32_t row) const {
  double sum = 0;
  for (std::uint32_t n = 0; n < pieces(row); ++n) {
    sum += cells_.volumeFraction(cells_.cells.firstPiece[row] + n);
  }
  return sum;
}

void CellPicture::drawRow(Image& image, const Index3& cell, int x0, int x1, int y) const {
  const auto& area = plot_.area();
  const auto row = cells_.rowOf(cell);
  const bool isFluid = row == CutCells::kNoRow && cells_.classOf(cell) == FluidClass::Fluid;
  const auto* const section = row == CutCells::kNoRow ? nullptr : &layer_.section(row);
  const double share = section == nullptr ? 0 : shareOf(row);
  for (int x = x0; x < x1; ++x) {
    const auto body = bodyColor(x, y, style_.scale());
    auto& pixel = image.at(area.x0 + x, area.y0 + y);
    if (section == nullptr) {
      pixel = isFluid ? kFluidColor : body;
      continue;
    }
    const auto side = section->at({plot_.a(x), plot_.b(y)});
    pixel = fluidFractionColor(side.isFluid ? cells_.volumeFraction(side.piece) : share);
    if (!side.isFluid) pixel = blended(pixel, body, kBodyTint);
  }
}

}  // namespace cutwater::detail
