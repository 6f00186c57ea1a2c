#include <Cutwater/Render/ColorMap.hpp>
#include <Cutwater/Render/SliceFrame.hpp>
#include <Cutwater/Render/Ticks.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr Rgb kInk{38, 42, 48};
constexpr Rgb kFaintInk{105, 110, 118};

// Heights of capitals and widths of lines in pixels, at scale 1.
constexpr double kNumbers = 10.5;
constexpr double kLabels = 12;
constexpr double kTitle = 17;
constexpr double kFrameLine = 1.2;
constexpr double kZeroLine = 2.2;

/// Position on the colour bar of a value, and the other way round.
class BarScale {
 public:
  BarScale(const PlotArea& bar, const Interval<double>& values)
      : top_(bar.y0), bottom_(bar.y0 + bar.height), values_(values) {
    const double share = -values.lower / std::max(values.upper - values.lower, 1e-300);
    const bool bothSides = values.lower < 0 && values.upper > 0;
    zero_ = bottom_ - (bothSides ? std::clamp(share, 0.3, 0.7) : share) * bar.height;
  }

  [[nodiscard]] double zero() const { return zero_; }
  [[nodiscard]] double position(double value) const {
    if (value < 0) return zero_ + (bottom_ - zero_) * (value / values_.lower);
    return values_.upper > 0 ? zero_ - (zero_ - top_) * (value / values_.upper) : zero_;
  }
  /// What signedDistanceColor() takes.
  [[nodiscard]] double fractionAt(double y) const {
    return y < zero_ ? (zero_ - y) / (zero_ - top_) : (zero_ - y) / (bottom_ - zero_);
  }

 private:
  double top_;
  double bottom_;
  Interval<double> values_;
  double zero_ = 0;
};

/// As many as there is room for, those nearest to 0 first.
std::vector<Tick> uncrowded(std::vector<Tick> ticks, const BarScale& scale, double room) {
  std::stable_sort(ticks.begin(), ticks.end(), [](const Tick& a, const Tick& b) {
    return std::abs(a.value) < std::abs(b.value);
  });
  std::vector<Tick> kept;
  for (const auto& tick : ticks) {
    const bool crowded = std::any_of(kept.begin(), kept.end(), [&](const Tick& other) {
      return std::abs(scale.position(other.value) - scale.position(tick.value)) < room;
    });
    if (!crowded) kept.push_back(tick);
  }
  return kept;
}

}  // namespace

SliceLayout::SliceLayout(int width, int height)
    : scale_(std::clamp(std::min(width, height) / 900.0, 0.5, 8.0)), room_{} {
  room_ = {px(105), px(96), width - px(105) - px(170), height - px(96) - px(84)};
}

int SliceLayout::px(double length) const {
  return static_cast<int>(std::lround(length * scale_));
}

TextStyle SliceLayout::text(double capHeight, TextAnchor anchor) const {
  const double height = std::max(capHeight * scale_, 7.0);  // smaller cannot be read
  return {.capHeight = height,
          .weight = std::max(0.12 * height, 1.0),
          .color = kInk,
          .anchor = anchor,
          .upwards = false};
}

TextStyle SliceLayout::upwardsText(double capHeight) const {
  auto style = text(capHeight, TextAnchor::Middle);
  style.upwards = true;
  return style;
}

void SliceLayout::drawLine(Image& image, const Stroke& line, double width) const {
  image.drawStrokes(std::span(&line, 1), std::max(width * scale_, 1.0), kInk);
}

void SliceLayout::drawFrame(Image& image, const PlotArea& area) const {
  const double x0 = area.x0, y0 = area.y0;
  const double x1 = x0 + area.width, y1 = y0 + area.height;
  for (const auto& side : {Stroke{x0, y0, x1, y0}, Stroke{x1, y0, x1, y1}, Stroke{x1, y1, x0, y1},
                           Stroke{x0, y1, x0, y0}}) {
    drawLine(image, side, kFrameLine);
  }
}

void SliceLayout::drawAxes(Image& image, const PlotArea& plot,
                           const std::array<Interval<double>, 2>& ranges,
                           const std::array<std::string, 2>& labels) const {
  drawFrame(image, plot);
  const double perPixel = (ranges[0].upper - ranges[0].lower) / plot.width;
  const double step = roundStep(perPixel * px(105));
  const double left = plot.x0;
  const double bottom = plot.y0 + plot.height;
  for (const auto& tick : ticksBetween(ranges[0].lower, ranges[0].upper, step)) {
    const double x = left + (tick.value - ranges[0].lower) / perPixel;
    drawLine(image, {x, bottom, x, bottom + px(7)}, kFrameLine);
    drawText(image, x, bottom + px(25), tick.label, text(kNumbers, TextAnchor::Middle));
  }
  for (const auto& tick : ticksBetween(ranges[1].lower, ranges[1].upper, step)) {
    const double y = bottom - (tick.value - ranges[1].lower) / perPixel;
    drawLine(image, {left - px(7), y, left, y}, kFrameLine);
    drawText(image, left - px(13), y + px(0.5 * kNumbers), tick.label,
             text(kNumbers, TextAnchor::End));
  }
  drawText(image, left + 0.5 * plot.width, bottom + px(55), labels[0],
           text(kLabels, TextAnchor::Middle));
  drawText(image, left - px(72), plot.y0 + 0.5 * plot.height, labels[1], upwardsText(kLabels));
}

void SliceLayout::drawColorBar(Image& image, const PlotArea& plot, const Interval<double>& values,
                               const LineSpacing& spacing, const std::string& label) const {
  const PlotArea bar{plot.x0 + plot.width + px(28), plot.y0, px(24), plot.height};
  const BarScale scale(bar, values);
  const int right = bar.x0 + bar.width;
  for (int y = bar.y0; y < bar.y0 + bar.height; ++y) {
    image.fillRectangle(bar.x0, y, right, y + 1, signedDistanceColor(scale.fractionAt(y + 0.5)));
  }
  drawFrame(image, bar);
  auto ticks = ticksBetween(0, values.upper, spacing.outside);
  for (const auto& tick : ticksBetween(values.lower, 0, spacing.inside)) {
    if (tick.value < 0) ticks.push_back(tick);
  }
  for (const auto& tick : uncrowded(ticks, scale, px(21))) {
    const double y = scale.position(tick.value);
    drawLine(image, {static_cast<double>(right), y, static_cast<double>(right + px(6)), y},
             kFrameLine);
    drawText(image, right + px(12), y + px(0.5 * kNumbers), tick.label,
             text(kNumbers, TextAnchor::Start));
  }
  if (values.lower < 0 && values.upper > 0) {
    drawLine(image,
             {static_cast<double>(bar.x0), scale.zero(), static_cast<double>(right), scale.zero()},
             kZeroLine);
  }
  drawText(image, right + px(88), bar.y0 + 0.5 * bar.height, label, upwardsText(kLabels));
}

void SliceLayout::drawTitle(Image& image, const PlotArea& plot, const std::string& title,
                            const std::string& note) const {
  auto heading = text(kTitle, TextAnchor::Start);
  const double room = image.width() - plot.x0 - px(20);
  heading.capHeight *= std::min(1.0, room / std::max(textLength(title, heading.capHeight), 1.0));
  drawText(image, plot.x0, plot.y0 - px(40), title, heading);
  auto style = text(kNumbers, TextAnchor::Start);
  style.color = kFaintInk;
  drawText(image, plot.x0, plot.y0 - px(14), note, style);
}

}  // namespace cutwater::detail
