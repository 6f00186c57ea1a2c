#include <Cutwater/Render/Detail/RenderLayout.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater::detail {

namespace {

// Lengths in pixels at scale 1.
constexpr double kTitleHeight = 58;
constexpr double kStripHeight = 84;
constexpr double kMargin = 30;
constexpr double kRow = 23;     // of the legend
constexpr double kSwatch = 14;  // side of its squares
constexpr double kMostLegend = 300;
constexpr double kTriad = 38;      // length of an arrow
constexpr double kTriadRoom = 62;  // from the edges of the picture to their origin
constexpr double kScaleBar = 190;  // at most
constexpr double kThickLine = 2.4;

constexpr std::array<Rgb, 3> kAxisColors{{{196, 57, 51}, {63, 140, 66}, {45, 98, 180}}};

/// The text, or as much of it as fits, followed by two dots.
std::string shortened(const std::string& text, double capHeight, double room) {
  if (textLength(text, capHeight) <= room) return text;
  std::size_t least = 0;  // by bisection: length grows with the number of characters
  std::size_t most = text.size();
  while (least < most) {
    const auto middle = least + (most - least + 1) / 2;
    const bool fits = textLength(text.substr(0, middle) + "..", capHeight) <= room;
    (fits ? least : most) = fits ? middle : middle - 1;
  }
  while (least > 0 && continuesCharacter(text[least])) --least;
  return text.substr(0, least) + "..";
}

}  // namespace

RenderLayout::RenderLayout(int width, int height, const Parts& parts)
    : style_(width, height), area_{0, 0, width, height} {
  if (parts.title) area_.y0 = style_.px(kTitleHeight);
  if (parts.axes) strip_ = style_.px(kStripHeight);
  double longest = 0;
  const double capHeight = style_.text(kNumbers, TextAnchor::Start).capHeight;
  for (const auto& name : parts.legend) longest = std::max(longest, textLength(name, capHeight));
  if (longest > 0) {
    const double most = std::min<double>(style_.px(kMostLegend), 0.3 * width);
    area_.width -= static_cast<int>(std::min(longest + style_.px(kMargin + 2 * kSwatch), most));
  }
  area_.height -= area_.y0;
}

Frame RenderLayout::frame() const {
  const double margin = style_.px(kMargin);
  const double height = area_.height - strip_ - (strip_ > 0 ? margin : 2 * margin);
  return {area_.x0 + 0.5 * area_.width, area_.y0 + margin + 0.5 * height,
          std::max(area_.width - 2 * margin, 1.0), std::max(height, 1.0)};
}

void RenderLayout::drawTitle(Image& image, const std::string& title) const {
  style_.drawHeading(image, style_.px(kMargin), style_.px(0.66 * kTitleHeight), title);
}

void RenderLayout::drawLegend(Image& image, std::span<const LegendEntry> entries) const {
  const int left = area_.x0 + area_.width;
  const int row = style_.px(kRow);
  const int swatch = style_.px(kSwatch);
  int top = area_.y0 + style_.px(kMargin);
  const auto text = style_.text(kNumbers, TextAnchor::Start);
  const double textLeft = left + 1.6 * swatch;
  const double room = image.width() - textLeft - 0.3 * style_.px(kMargin);
  const auto rows =
      static_cast<std::size_t>(std::max((image.height() - style_.px(kMargin) - top) / row, 1));
  const auto shown = entries.size() <= rows ? entries.size() : rows - 1;
  for (const auto& entry : entries.first(shown)) {
    image.fillRectangle(left, top, left + swatch, top + swatch, entry.color);
    drawText(image, textLeft, top + 0.5 * (swatch + text.capHeight),
             shortened(entry.name, text.capHeight, room), text);
    top += row;
  }
  if (shown == entries.size()) return;
  auto faint = text;
  faint.color = kFaintInk;
  drawText(image, textLeft, top + 0.5 * (swatch + text.capHeight),
           "and " + std::to_string(entries.size() - shown) + " more", faint);
}

void RenderLayout::drawAxes(Image& image, const View& view) const {
  const double x = area_.x0 + style_.px(kTriadRoom);
  const double y = image.height() - style_.px(kTriadRoom);
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return view.back[a] < view.back[b]; });
  for (const int axis : order) {
    const double right = view.right()[axis];
    const double up = view.up[axis];
    const double arm = style_.px(kTriad);
    const auto& color = kAxisColors[static_cast<std::size_t>(axis)];
    if (std::hypot(right, up) < 0.05) continue;  // straight towards the viewer or away
    style_.drawLine(image, {x, y, x + arm * right, y - arm * up}, kThickLine, color);
    auto text = style_.text(kLabels, TextAnchor::Middle);
    text.color = color;
    const double reach = arm + 11 * style_.scale() / std::hypot(right, up);
    drawText(image, x + reach * right, y - reach * up + 0.38 * text.capHeight,
             std::string(1, "xyz"[axis]), text);
  }
}

void RenderLayout::drawScaleBar(Image& image, double pixelSize, const std::string& unit) const {
  const double most = style_.px(kScaleBar) * pixelSize;
  if (!(std::isfinite(most) && most > 0)) return;
  const double length = roundStep(0.4 * most);  // 1, 2, 5: factors of at most 2.5
  const double right = area_.x0 + area_.width - style_.px(kMargin);
  const double left = right - length / pixelSize;
  const double y = image.height() - style_.px(32);
  const double tick = style_.px(6);
  style_.drawLine(image, {left, y, right, y}, 1.6);
  for (const double x : {left, right}) style_.drawLine(image, {x, y - tick, x, y + tick}, 1.6);
  drawText(image, 0.5 * (left + right), y - 1.7 * tick, lengthLabel(length, unit),
           style_.text(kNumbers, TextAnchor::Middle));
}

}  // namespace cutwater::detail
