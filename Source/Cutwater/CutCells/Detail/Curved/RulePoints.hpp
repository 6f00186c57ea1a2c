#pragma once

#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

/// A stretch of a line that lies in the fluid. Its length times the weight is its share of a
/// volume; of an area, in a rectangle.
struct FluidSpan {
  AxisLine line;
  double weight = 0;
  std::uint32_t block = kNone;  ///< see RulePoints

  [[nodiscard]] Vec3<double> middle() const {
    return line.at(0.5 * (line.start[line.axis] + line.end));
  }
  [[nodiscard]] double size() const { return weight * line.length(); }
};

/// A point of the wall, at an end of such a stretch.
struct WallPoint {
  Vec3<double> at;
  Vec3<double> normal;          ///< out of the fluid, unit; in a rectangle, in its plane
  double weight = 0;            ///< its share of the wall's area; of a length, in a rectangle
  Vec3<double> inside;          ///< a point of the fluid beside it
  std::uint32_t block = kNone;  ///< of that
};

/// Where a line is in a sweep.
struct LinePlace {
  std::uint32_t sweep = 0;
  std::uint32_t sliceStretch = 0;  ///< between places at which slices of rows change
  std::uint32_t rowStretch = 0;    ///< between places at which lines of a row change
  std::uint32_t rowStretches = 0;  ///< number of these in the row

  bool operator==(const LinePlace&) const = default;
};

/// Quadrature of the fluid in boxes or rectangles, and of their walls.
///
/// Spans of one block are connected with each other: as what lines meet changes smoothly between
/// the places that divide a sweep, the spans of lines between these, counted along each line, are
/// parts of one piece.
struct RulePoints {
  std::vector<FluidSpan> spans;
  std::vector<WallPoint> walls;
  std::uint32_t sweeps = 0;

  /// The block of the spans of this number on lines with so many spans at a place. Slices of a
  /// sweep are added one after the other.
  [[nodiscard]] std::uint32_t blockAt(const LinePlace& place, std::uint32_t count,
                                      std::uint32_t number) {
    const Block block{place, count, number};
    for (auto i = blocks_.size(); i-- > 0 && isInSlice(blocks_[i].place, place);) {
      if (blocks_[i] == block) return static_cast<std::uint32_t>(i);
    }
    blocks_.push_back(block);
    return static_cast<std::uint32_t>(blocks_.size() - 1);
  }
  [[nodiscard]] std::size_t blockCount() const { return blocks_.size(); }
  [[nodiscard]] const LinePlace& placeOf(std::size_t block) const { return blocks_[block].place; }

  void clear() {
    spans.clear();
    walls.clear();
    blocks_.clear();
    sweeps = 0;
  }

 private:
  struct Block {
    LinePlace place;
    std::uint32_t count = 0;
    std::uint32_t number = 0;

    bool operator==(const Block&) const = default;
  };
  static bool isInSlice(const LinePlace& a, const LinePlace& b) {
    return a.sweep == b.sweep && a.sliceStretch == b.sliceStretch;
  }

  std::vector<Block> blocks_;
};

/// The unit normal of the wall at a point, out of the fluid; in the plane across an axis, if that
/// is not -1. Zero where there is none, as where the wall touches the plane.
[[nodiscard]] inline Vec3<double> wallNormal(const FluidField& field, const Vec3<double>& at,
                                             int flatAxis) {
  constexpr double kTouching = 1e-6;
  auto slope = -field.gradient(at);
  const double steepness = length(slope);
  if (flatAxis >= 0) slope[flatAxis] = 0;
  return length(slope) > kTouching * steepness ? normalized(slope) : Vec3<double>{};
}

/// A slice of rows of lines.
struct SweptSlice {
  double at = 0;
  double weight = 0;
  std::uint32_t stretch = 0;  ///< see LinePlace
};

/// Lines of a sweep, with their weights and places.
struct SweptLines {
  std::uint32_t sweep = 0;
  std::vector<AxisLine> lines = {};
  std::vector<double> weights = {};
  std::vector<LinePlace> places = {};

  /// Those of a slice, at Gauss points between the ends, which are sorted.
  void addRow(std::span<const GaussPoint> gauss, const Box<double>& box, const SweepAxes& axes,
              const SweptSlice& slice, std::vector<double>& ends, bool mayTurn = true) {
    std::ranges::sort(ends);
    ends.push_back(box.upper[axes.row]);
    const auto first = places.size();
    forStretches(gauss, box.lower[axes.row], ends,
                 [&](double row, double weight, std::uint32_t stretch) {
                   lines.push_back(lineAt(box, axes, slice.at, row));
                   lines.back().mayTurn = mayTurn;
                   weights.push_back(slice.weight * weight);
                   places.push_back({sweep, slice.stretch, stretch, 0});
                 });
    for (auto i = first; i < places.size(); ++i) {
      places[i].rowStretches = places.back().rowStretch + 1;
    }
  }
};

/// What is taken of lines.
struct LineTaking {
  int flatAxis = -1;      ///< see wallNormal()
  bool withFluid = true;  ///< and not the wall alone
  LinePlace place = {};
};

/// A line with a weight, the one of this number among those whose crossings were found.
struct MetLine {
  const LineCrossings& crossings;
  std::size_t number = 0;
  FluidSpan whole;
};

/// Adds what a line has of the fluid; and of the wall, where takesWall(surface, normal) says so.
template <typename TakesWall>
void addLinePoints(const FluidField& field, const MetLine& met, const LineTaking& taking,
                   const TakesWall& takesWall, RulePoints& to) {
  constexpr double kSteepest = 1e-3;  // where a wall along a line is taken to have an area
  const auto& crossings = met.crossings;
  const auto number = met.number;
  const auto& line = met.whole.line;
  std::size_t next = 0;  // crossing
  const auto places = crossings.of(number).size() + (crossings.startsInFluid(number) ? 2 : 1);
  const auto count = static_cast<std::uint32_t>(places / 2);  // spans
  std::uint32_t place = 0;
  const auto visit = [&](double from, double end, bool wallBelow, bool wallAbove) {
    auto span = met.whole;
    span.block = to.blockAt(taking.place, count, place++);
    span.line.start[line.axis] = from;
    span.line.end = end;
    if (taking.withFluid) to.spans.push_back(span);
    const auto addWall = [&](double coordinate, bool isAbove) {
      const auto* surface = crossings.surfaceAt(number, next++);
      const auto at = line.at(coordinate);
      auto normal = wallNormal(surface == nullptr ? field : *surface, at, taking.flatAxis);
      if (surface != nullptr && (normal[line.axis] > 0) != isAbove) normal = -normal;
      if (normal == Vec3<double>{} || !takesWall(surface, normal)) return;
      const double slope = std::max(std::abs(normal[line.axis]), kSteepest);
      to.walls.push_back({at, normal, met.whole.weight / slope, span.middle(), span.block});
    };
    if (wallBelow) addWall(from, false);
    if (wallAbove) addWall(end, true);
  };
  forFluidStretches(line, crossings.startsInFluid(number), crossings.of(number), visit);
}

}  // namespace cutwater
