#pragma once

#include <Cutwater/Render/Detail/PictureStyle.hpp>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// The side of a tile in pixels; its square is kMostRays.
inline constexpr int kTile = 16;

/// The pixels of an area tile by tile, so that neighbours in the list are neighbours in the
/// picture: within a tile, too, each sixteenth is a square, and each sixteenth of that.
class PixelTiles {
 public:
  explicit PixelTiles(const PlotArea& area) : width_(area.width), height_(area.height) {}

  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(tiles(width_)) * static_cast<std::size_t>(tiles(height_));
  }

  /// Calls visit(x, y) for the pixels of a tile, counted from the area's corner.
  template <typename Visit>
  void forPixels(std::size_t tile, Visit visit) const {
    const auto columns = static_cast<std::size_t>(tiles(width_));
    const int x0 = static_cast<int>(tile % columns) * kTile;
    const int y0 = static_cast<int>(tile / columns) * kTile;
    for (unsigned n = 0; n < kTile * kTile; ++n) {
      const int x = x0 + everySecondBit(n);
      const int y = y0 + everySecondBit(n >> 1U);
      if (x < width_ && y < height_) visit(x, y);
    }
  }

 private:
  static int tiles(int pixels) { return (pixels + kTile - 1) / kTile; }
  /// Of the number's bits 0, 2, 4 and 6.
  static int everySecondBit(unsigned n) {
    return static_cast<int>((n & 1U) | (n >> 1U & 2U) | (n >> 2U & 4U) | (n >> 3U & 8U));
  }

  int width_;
  int height_;
};

}  // namespace cutwater::detail
