#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

namespace cutwater {

/// A line along an axis, from a point up to a coordinate.
struct AxisLine {
  Vec3<double> start;
  double end = 0;
  int axis = 0;
  bool mayTurn = true;  ///< whether values along it may have a turning point

  /// The point of the line at a coordinate.
  [[nodiscard]] Vec3<double> at(double coordinate) const {
    auto point = start;
    point[axis] = coordinate;
    return point;
  }
  [[nodiscard]] Vec3<double> endPoint() const { return at(end); }
  [[nodiscard]] double length() const { return end - start[axis]; }
};

/// Calls visit(from, to, wall below, wall above) for the stretches of a line in the fluid, between
/// the ascending places where it begins or ends; the walls tell whether they end in one.
template <typename Visit>
void forFluidStretches(const AxisLine& line, bool startsInFluid, std::span<const double> crossings,
                       const Visit& visit) {
  double from = line.start[line.axis];
  bool inFluid = startsInFluid;
  bool afterWall = false;
  for (const double at : crossings) {
    if (inFluid) visit(from, at, afterWall, true);
    from = at;
    inFluid = !inFluid;
    afterWall = true;
  }
  if (inFluid) visit(from, line.end, afterWall, false);
}

/// Where lines pass between fluid and body. What is found of a line depends on it alone.
///
/// A line whose ends are on two sides is taken to cross the surface once. One whose ends are on the
/// same side is searched for a point on the other one, by the derivatives at its ends, and then by
/// what the field's steepness does not exclude.
///
/// The surface of a union, and the like, lies in those of its operands: so it is looked for where
/// lines cross these. That finds a thin plate beside another operand that is nearer to the line,
/// and any number of crossings.
class LineCrossings {
 public:
  explicit LineCrossings(const FluidField& field) : field_(&field) {}

  void find(std::span<const AxisLine> lines);

  [[nodiscard]] bool startsInFluid(std::size_t line) const { return ends_[2 * line] > 0; }
  /// The coordinates, ascending, at which fluid begins or ends.
  [[nodiscard]] std::span<const double> of(std::size_t line) const {
    return std::span(positions_).subspan(first_[line], first_[line + 1] - first_[line]);
  }

 private:
  /// A stretch of a line with its ends on two sides of the surface.
  struct Bracket {
    AxisLine line;
    double body = 0;  // a coordinate in the body, and its value
    double bodyValue = 0;
    double fluid = 0;
    double fluidValue = 0;
    double root = 0;
    double widthBefore = 0;  // between both, some steps ago
    int steps = 0;
    int lastSide = 0;      // on which the last point was: 1 in the fluid, -1 in the body
    bool isAlong = false;  // the body's end lies in a stretch of the surface, where values are 0
    bool isDone = false;

    [[nodiscard]] double next() const;
    void take(double at, double value);
  };

  void evaluateEnds(std::span<const AxisLine> lines);
  void addBracket(const AxisLine& line, double from, double fromValue, double to, double toValue);
  void addBrackets(const AxisLine& line, double from, double to);
  void addBetweenOperands(const AxisLine& line, double from, double to);
  /// A point of the line on the other side, between ends on the same one, if one is found.
  bool findTurn(const AxisLine& line, double from, double to, double& at, double& value) const;
  bool findHidden(const AxisLine& line, double from, double to, double& at, double& value) const;
  void solve();

  const FluidField* field_;
  std::unique_ptr<LineCrossings> ofOperand_;
  std::vector<const FluidField*> near_;  // operands that a line may cross
  std::vector<double> known_;            // where a line crosses the surface of an operand
  std::vector<double> ends_;             // values at both ends of each line
  std::vector<Bracket> brackets_;
  std::vector<std::size_t> first_;
  std::vector<double> positions_;
  std::vector<std::size_t> open_;  // brackets that are not done
  std::vector<Vec3<double>> points_;
  std::vector<double> values_;
};

}  // namespace cutwater
