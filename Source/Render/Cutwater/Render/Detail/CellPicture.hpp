#pragma once

#include <Cutwater/Render/Detail/CellLayer.hpp>
#include <Cutwater/Render/Detail/SliceFrame.hpp>

#include <vector>

namespace cutwater::detail {

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

/// The colour of cells that are all fluid.
inline constexpr Rgb kFluidColor{250, 251, 252};
/// The colour of the body at a pixel: hatched at 45 degrees.
[[nodiscard]] Rgb bodyColor(int x, int y, double scale);

/// How many cells of a layer are cut, have several pieces, are thin.
struct CellTally {
  std::size_t cut = 0;
  std::size_t multiPiece = 0;
  std::size_t thin = 0;
};

/// Draws a layer of cells. Refers to what it is made of.
class CellPicture {
 public:
  CellPicture(const CellLayer& layer, const CellPlot& plot, const PictureStyle& style)
      : layer_(layer), plot_(plot), style_(style) {}

  void drawCells(Image& image) const;
  /// The sides of cells, unless they are too close to each other to tell cells apart.
  void drawGrid(Image& image) const;
  void drawWall(Image& image) const;
  void drawMarks(Image& image) const;

  /// The mark of cells with several pieces: frames within boxes, in pixels.
  void drawFrames(Image& image, std::span<const Stroke> boxes) const;
  /// The mark of thin cells: a dot of this radius at each place; in pixels.
  void drawDots(Image& image, std::span<const PlanePoint> places, double radius) const;
  [[nodiscard]] double dotRadius() const;

  [[nodiscard]] CellTally counts() const;

 private:
  [[nodiscard]] std::uint32_t pieces(std::uint32_t row) const;
  /// Of all fluid in the cell.
  [[nodiscard]] double shareOf(std::uint32_t row) const;
  /// The pixels [x0, x1) of a line that lie in a cell.
  void drawRow(Image& image, const ShownCell& cell, int x0, int x1, int y) const;

  const CellLayer& layer_;
  const CellPlot& plot_;
  const PictureStyle& style_;
};

}  // namespace cutwater::detail
