#pragma once

#include <Cutwater/CutCells/Detail/Curved/LineCrossings.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

/// A stretch of a line that lies in the fluid. Its length times the weight is its share of a
/// volume; of an area, in a rectangle.
struct FluidSpan {
  AxisLine line;
  double weight = 0;

  [[nodiscard]] Vec3<double> middle() const {
    return line.at(0.5 * (line.start[line.axis] + line.end));
  }
  [[nodiscard]] double size() const { return weight * line.length(); }
};

/// A point of the wall, at an end of such a stretch.
struct WallPoint {
  Vec3<double> at;
  Vec3<double> normal;  ///< out of the fluid, unit; in a rectangle, in its plane
  double weight = 0;    ///< its share of the wall's area; of a length, in a rectangle
  Vec3<double> inside;  ///< a point of the fluid beside it
};

/// Quadrature of the fluid in boxes or rectangles, and of their walls.
struct RulePoints {
  std::vector<FluidSpan> spans;
  std::vector<WallPoint> walls;

  void clear() {
    spans.clear();
    walls.clear();
  }
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

/// What is taken of lines.
struct LineTaking {
  int flatAxis = -1;      ///< see wallNormal()
  bool withFluid = true;  ///< and not the wall alone
  bool onlyNearest =
      false;  ///< of the wall, where the line's axis is the one nearest to its normal
};

/// Adds what a line with a weight, the one of this number among `crossings`, has of the fluid and
/// of the wall.
inline void addLinePoints(const FluidField& field, const LineCrossings& crossings,
                          std::size_t number, const FluidSpan& whole, const LineTaking& taking,
                          RulePoints& to) {
  constexpr double kSteepest = 1e-3;  // where a wall along a line is taken to have an area
  const auto& line = whole.line;
  const auto visit = [&](double from, double end, bool wallBelow, bool wallAbove) {
    auto span = whole;
    span.line.start[line.axis] = from;
    span.line.end = end;
    if (taking.withFluid) to.spans.push_back(span);
    const auto addWall = [&](double place) {
      const auto at = line.at(place);
      const auto normal = wallNormal(field, at, taking.flatAxis);
      if (normal == Vec3<double>{}) return;
      if (taking.onlyNearest && nearestAxis(normal) != line.axis) return;
      const double slope = std::max(std::abs(normal[line.axis]), kSteepest);
      to.walls.push_back({at, normal, whole.weight / slope, span.middle()});
    };
    if (wallBelow) addWall(from);
    if (wallAbove) addWall(end);
  };
  forFluidStretches(line, crossings.startsInFluid(number), crossings.of(number), visit);
}

}  // namespace cutwater
