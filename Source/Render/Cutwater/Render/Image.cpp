#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Image.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cutwater {

namespace {

std::size_t checkedCount(int width, int height) {
  require(1 <= width && width <= Image::kMaxSize && 1 <= height && height <= Image::kMaxSize,
          "Image: need a width and a height from 1 to 32768 pixels", Named{"width", width},
          Named{"height", height});
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::uint8_t mixed(std::uint8_t base, std::uint8_t paint, double opacity) {
  return static_cast<std::uint8_t>(std::lround(base + (paint - base) * opacity));
}

double distanceTo(const Stroke& s, double x, double y) {
  const double dx = s.x1 - s.x0;
  const double dy = s.y1 - s.y0;
  const double squared = dx * dx + dy * dy;
  const double along =
      squared > 0 ? std::clamp(((x - s.x0) * dx + (y - s.y0) * dy) / squared, 0.0, 1.0) : 0;
  return std::hypot(x - s.x0 - along * dx, y - s.y0 - along * dy);
}

struct PixelBox {
  int x0, y0, x1, y1;
};

/// The pixels [x0, x1) x [y0, y1) within reach of the strokes.
PixelBox pixelBounds(std::span<const Stroke> strokes, double reach) {
  constexpr double kFar = Image::kMaxSize;  // keeps the conversion to int defined
  double x0 = kFar, y0 = kFar, x1 = -kFar, y1 = -kFar;
  for (const auto& s : strokes) {
    x0 = std::min({x0, s.x0, s.x1});
    y0 = std::min({y0, s.y0, s.y1});
    x1 = std::max({x1, s.x0, s.x1});
    y1 = std::max({y1, s.y0, s.y1});
  }
  const auto pixel = [](double v) { return static_cast<int>(std::clamp(v, -kFar, 2 * kFar)); };
  return {pixel(std::floor(x0 - reach)), pixel(std::floor(y0 - reach)),
          pixel(std::ceil(x1 + reach)), pixel(std::ceil(y1 + reach))};
}

}  // namespace

Rgb blended(const Rgb& base, const Rgb& paint, double opacity) {
  const double o = std::clamp(opacity, 0.0, 1.0);
  return {mixed(base.red, paint.red, o), mixed(base.green, paint.green, o),
          mixed(base.blue, paint.blue, o)};
}

Image::Image(int width, int height, const Rgb& background)
    : width_(width), height_(height), pixels_(checkedCount(width, height), background) {}

Image Image::transparent(int width, int height) {
  Image image(width, height);
  image.opacities_.resize(image.pixels_.size());
  return image;
}

void Image::paint(int x, int y, const Rgb& color, double coverage) {
  auto& pixel = pixels_[index(x, y)];
  if (opacities_.empty()) {
    pixel = blended(pixel, color, coverage);
    return;
  }
  // T. Porter and T. Duff, "Compositing digital images", SIGGRAPH 1984: over.
  auto& opacity = opacities_[index(x, y)];
  const double paint = std::clamp(coverage, 0.0, 1.0);
  const double sum = paint + (1 - paint) * opacity / 255;
  if (sum > 0) pixel = blended(pixel, color, paint / sum);
  opacity = static_cast<std::uint8_t>(std::lround(255 * sum));
}

void Image::fillRectangle(int x0, int y0, int x1, int y1, const Rgb& color) {
  for (int y = std::max(y0, 0); y < std::min(y1, height_); ++y) {
    for (int x = std::max(x0, 0); x < std::min(x1, width_); ++x) paint(x, y, color, 1);
  }
}

void Image::drawStrokes(std::span<const Stroke> strokes, double width, const Rgb& color) {
  const auto inPicture = [&](std::span<const Stroke> some) {
    auto bounds = pixelBounds(some, 0.5 * width + 1);
    bounds.x0 = std::max(bounds.x0, 0);
    bounds.y0 = std::max(bounds.y0, 0);
    bounds.x1 = std::max(std::min(bounds.x1, width_), bounds.x0);
    bounds.y1 = std::max(std::min(bounds.y1, height_), bounds.y0);
    return bounds;
  };
  // Finds the nearest stroke to each pixel; a stroke is only near pixels around it.
  const auto all = inPicture(strokes);
  const auto columns = static_cast<std::size_t>(all.x1 - all.x0);
  std::vector<float> distances(columns * static_cast<std::size_t>(all.y1 - all.y0),
                               std::numeric_limits<float>::infinity());
  const auto distanceAt = [&](int x, int y) -> float& {
    return distances[static_cast<std::size_t>(y - all.y0) * columns +
                     static_cast<std::size_t>(x - all.x0)];
  };
  for (const auto& stroke : strokes) {
    const auto near = inPicture(std::span(&stroke, 1));
    for (int y = near.y0; y < near.y1; ++y) {
      for (int x = near.x0; x < near.x1; ++x) {
        auto& distance = distanceAt(x, y);
        distance = std::min(distance, static_cast<float>(distanceTo(stroke, x + 0.5, y + 0.5)));
      }
    }
  }
  for (int y = all.y0; y < all.y1; ++y) {
    for (int x = all.x0; x < all.x1; ++x) {
      const double distance{distanceAt(x, y)};
      const double coverage = std::clamp(0.5 * width - distance + 0.5, 0.0, std::min(width, 1.0));
      if (coverage > 0) paint(x, y, color, coverage);
    }
  }
}

}  // namespace cutwater
