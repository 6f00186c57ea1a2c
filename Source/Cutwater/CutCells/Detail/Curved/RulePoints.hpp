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

/// Calls visit(span, wall below, wall above) for the stretches of a line that lie in the fluid;
/// the walls tell whether they end in one.
template <typename Visit>
void forFluidSpans(const LineCrossings& crossings, std::size_t number, const AxisLine& line,
                   double weight, const Visit& visit) {
  FluidSpan span{line, weight};
  const auto visitUpTo = [&](double from, double to, bool wallBelow, bool wallAbove) {
    span.line.start[line.axis] = from;
    span.line.end = to;
    visit(span, wallBelow, wallAbove);
  };
  double from = line.start[line.axis];
  bool inFluid = crossings.startsInFluid(number);
  bool afterWall = false;
  for (const double at : crossings.of(number)) {
    if (inFluid) visitUpTo(from, at, afterWall, true);
    from = at;
    inFluid = !inFluid;
    afterWall = true;
  }
  if (inFluid) visitUpTo(from, line.end, afterWall, false);
}

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

/// Adds the wall at a point of a line with this weight.
inline void addWallPoint(const Vec3<double>& at, const Vec3<double>& normal, int axis,
                         double weight, const Vec3<double>& inside, RulePoints& to) {
  constexpr double kSteepest = 1e-3;  // where a wall along a line is taken to have an area
  if (normal == Vec3<double>{}) return;
  to.walls.push_back({at, normal, weight / std::max(std::abs(normal[axis]), kSteepest), inside});
}

}  // namespace cutwater
