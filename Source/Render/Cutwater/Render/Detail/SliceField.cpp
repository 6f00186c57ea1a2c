#include <Cutwater/Render/Detail/ColorMap.hpp>
#include <Cutwater/Render/Detail/SliceField.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

constexpr Rgb kOutline{22, 24, 30};
constexpr Rgb kUndefined{160, 160, 160};  // where the function gives NaN
constexpr Rgb kInnerLine{255, 255, 255};
constexpr Rgb kOuterLine{70, 40, 20};
constexpr double kOutlineWidth = 2.2;  // pixels, at scale 1
constexpr double kIsolineWidth = 1.0;
constexpr double kIsolineOpacity = 0.30;
// Least change of the value along the plane, per unit of length, for which lines are drawn.
constexpr double kLeastSlope = 0.3;
constexpr double kLeastOutlineSlope = 0.1;

/// A line `width` pixels wide covers this much of a pixel whose centre is `distance` from its
/// middle.
double coverage(double distance, double width) {
  return std::clamp(0.5 * width - distance + 0.5, 0.0, std::min(width, 1.0));
}

}  // namespace

template <std::floating_point T>
SliceField<T>::SliceField(const SignedDistanceFunction<T>& solid, const SlicePlane<T>& plane,
                          const SliceWindow<T>& window, const PlotArea& area,
                          const SliceOptions<T>& options)
    : area_(area),
      stride_(static_cast<std::size_t>(area.width) + 2),
      values_(stride_ * (static_cast<std::size_t>(area.height) + 2)),
      pixel_(
          static_cast<double>((window.upper[0] - window.lower[0]) / static_cast<T>(area.width))) {
  const auto rows = static_cast<std::size_t>(area.height) + 2;
  const T dx = (window.upper[0] - window.lower[0]) / static_cast<T>(area.width);
  const T dy = (window.upper[1] - window.lower[1]) / static_cast<T>(area.height);
  parallelFor(rows, {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                std::vector<Vec3<T>> points(stride_);
                for (auto row = begin; row < end; ++row) {
                  const T b = window.upper[1] - (static_cast<T>(row) - T(0.5)) * dy;
                  for (std::size_t i = 0; i < stride_; ++i) {
                    const T a = window.lower[0] + (static_cast<T>(i) - T(0.5)) * dx;
                    points[i] = plane.origin + a * plane.right + b * plane.up;
                  }
                  solid.signedDistances(std::span<const Vec3<T>>(points),
                                        std::span(values_).subspan(row * stride_, stride_),
                                        {.threads = 1});
                }
              });
  for (const T v : values_) {
    if (!std::isfinite(v)) continue;
    least_ = std::min(least_, static_cast<double>(v));
    greatest_ = std::max(greatest_, static_cast<double>(v));
  }
}

/// Change of the value per pixel. It may be far below 1 per unit of length, where a surface meets
/// the plane at a shallow angle.
template <std::floating_point T>
double SliceField<T>::slope(int x, int y) const {
  return 0.5 * std::hypot(value(x + 1, y) - value(x - 1, y), value(x, y + 1) - value(x, y - 1));
}

template <std::floating_point T>
Rgb SliceField<T>::color(int x, int y, const LineSpacing& spacing, double scale) const {
  const double v = value(x, y);
  if (!std::isfinite(v)) return kUndefined;
  auto result = signedDistanceColor(v < 0 ? -v / least_ : greatest_ > 0 ? v / greatest_ : 0);
  // Differences vanish on the ridges of a distance and where it is constant. A lower limit keeps
  // the outline from swelling there, and lets lines of equal distance fade, which do not belong
  // there.
  const double least = kLeastSlope * pixel_;
  const double change = slope(x, y);
  const double step = v < 0 ? spacing.inside : spacing.outside;
  const double line = std::round(v / step) * step;
  if (line != 0) {  // the line at 0 is the outline
    const double shown =
        coverage(std::abs(v - line) / std::max(change, least), kIsolineWidth * scale);
    result = blended(result, v < 0 ? kInnerLine : kOuterLine,
                     kIsolineOpacity * std::min(change / least, 1.0) * shown);
  }
  return blended(
      result, kOutline,
      coverage(std::abs(v) / std::max(change, kLeastOutlineSlope * pixel_), kOutlineWidth * scale));
}

template <std::floating_point T>
void SliceField<T>::draw(Image& image, const LineSpacing& spacing, double scale) const {
  for (int y = 0; y < area_.height; ++y) {
    for (int x = 0; x < area_.width; ++x) {
      image.at(area_.x0 + x, area_.y0 + y) = color(x, y, spacing, scale);
    }
  }
}

template class SliceField<float>;
template class SliceField<double>;

}  // namespace cutwater::detail
