#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr double kZeroLine = 2.2;

/// Maps a value to its position on the colour bar, and back.
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
  /// The argument of signedDistanceColor().
  [[nodiscard]] double fractionAt(double y) const {
    return y < zero_ ? (zero_ - y) / (zero_ - top_) : (zero_ - y) / (bottom_ - zero_);
  }

 private:
  double top_;
  double bottom_;
  Interval<double> values_;
  double zero_ = 0;
};

/// Keeps as many ticks as there is room for, those nearest to 0 first.
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

PlotArea fitted(const PlotArea& room, const Interval<double>& right, const Interval<double>& up) {
  const double w = right.upper - right.lower;
  const double h = up.upper - up.lower;
  const double perPixel = std::max(w / room.width, h / room.height);
  const int width = std::clamp(static_cast<int>(std::lround(w / perPixel)), 1, room.width);
  const int height = std::clamp(static_cast<int>(std::lround(h / perPixel)), 1, room.height);
  return {room.x0 + (room.width - width) / 2, room.y0 + (room.height - height) / 2, width, height};
}

// Liang and Barsky 1984.
std::optional<Stroke> clipped(const Stroke& line, const PlotArea& area) {
  const std::array<double, 2> from{line.x0, line.y0};
  const std::array<double, 2> way{line.x1 - line.x0, line.y1 - line.y0};
  const std::array<double, 2> lower{static_cast<double>(area.x0), static_cast<double>(area.y0)};
  const std::array<double, 2> upper{lower[0] + area.width, lower[1] + area.height};
  double first = 0;
  double last = 1;
  for (std::size_t i = 0; i < 2; ++i) {
    if (way[i] == 0) {
      if (from[i] < lower[i] || from[i] > upper[i]) return {};
      continue;
    }
    const double a = (lower[i] - from[i]) / way[i];
    const double b = (upper[i] - from[i]) / way[i];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last)) return {};
  return Stroke{from[0] + first * way[0], from[1] + first * way[1], from[0] + last * way[0],
                from[1] + last * way[1]};
}

SliceLayout::SliceLayout(int width, int height) : style_(width, height), room_{} {
  const auto px = [&](double length) { return style_.px(length); };
  room_ = {px(105), px(96), width - px(105) - px(170), height - px(96) - px(84)};
}

void SliceLayout::drawAxes(Image& image, const PlotArea& plot,
                           const std::array<Interval<double>, 2>& ranges,
                           const std::array<std::string, 2>& labels) const {
  style_.drawFrame(image, plot);
  const double perPixel = (ranges[0].upper - ranges[0].lower) / plot.width;
  // Those of the two axes differ where a window is so narrow that it is drawn wider than it is.
  const double perPixelUp = (ranges[1].upper - ranges[1].lower) / plot.height;
  const double step = roundStep(std::max(perPixel, perPixelUp) * style_.px(105));
  const double left = plot.x0;
  const double bottom = plot.y0 + plot.height;
  for (const auto& tick : ticksBetween(ranges[0].lower, ranges[0].upper, step)) {
    const double x = left + (tick.value - ranges[0].lower) / perPixel;
    style_.drawLine(image, {x, bottom, x, bottom + style_.px(7)}, kFrameLine);
    drawText(image, x, bottom + style_.px(25), tick.label,
             style_.text(kNumbers, TextAnchor::Middle));
  }
  for (const auto& tick : ticksBetween(ranges[1].lower, ranges[1].upper, step)) {
    const double y = bottom - (tick.value - ranges[1].lower) / perPixelUp;
    style_.drawLine(image, {left - style_.px(7), y, left, y}, kFrameLine);
    drawText(image, left - style_.px(13), y + style_.px(0.5 * kNumbers), tick.label,
             style_.text(kNumbers, TextAnchor::End));
  }
  drawText(image, left + 0.5 * plot.width, bottom + style_.px(55), labels[0],
           style_.text(kLabels, TextAnchor::Middle));
  drawText(image, left - style_.px(72), plot.y0 + 0.5 * plot.height, labels[1],
           style_.upwardsText(kLabels));
}

void SliceLayout::drawColorBar(Image& image, const PlotArea& plot, const Interval<double>& values,
                               const LineSpacing& spacing, const std::string& label) const {
  const PlotArea bar{plot.x0 + plot.width + style_.px(28), plot.y0, style_.px(24), plot.height};
  const BarScale scale(bar, values);
  const int right = bar.x0 + bar.width;
  for (int y = bar.y0; y < bar.y0 + bar.height; ++y) {
    image.fillRectangle(bar.x0, y, right, y + 1, signedDistanceColor(scale.fractionAt(y + 0.5)));
  }
  style_.drawFrame(image, bar);
  auto ticks = ticksBetween(0, values.upper, spacing.outside);
  for (const auto& tick : ticksBetween(values.lower, 0, spacing.inside)) {
    if (tick.value < 0) ticks.push_back(tick);
  }
  for (const auto& tick : uncrowded(ticks, scale, style_.px(21))) {
    const double y = scale.position(tick.value);
    style_.drawLine(image,
                    {static_cast<double>(right), y, static_cast<double>(right + style_.px(6)), y},
                    kFrameLine);
    drawText(image, right + style_.px(12), y + style_.px(0.5 * kNumbers), tick.label,
             style_.text(kNumbers, TextAnchor::Start));
  }
  if (values.lower < 0 && values.upper > 0) {
    style_.drawLine(
        image,
        {static_cast<double>(bar.x0), scale.zero(), static_cast<double>(right), scale.zero()},
        kZeroLine);
  }
  drawText(image, right + style_.px(88), bar.y0 + 0.5 * bar.height, label,
           style_.upwardsText(kLabels));
}

void SliceLayout::drawTitle(Image& image, const PlotArea& plot, const std::string& title,
                            const std::string& note) const {
  style_.drawHeading(image, plot.x0, plot.y0 - style_.px(40), title);
  auto style = style_.text(kNumbers, TextAnchor::Start);
  style.color = kFaintInk;
  drawText(image, plot.x0, plot.y0 - style_.px(14), note, style);
}

}  // namespace cutwater::detail
