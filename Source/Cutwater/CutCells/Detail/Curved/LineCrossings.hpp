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
/// If it is known in which surfaces the wall lies, lines are divided where they cross these. Of all
/// stretches that are on the same side of each of them, the value in the middle of the longest
/// tells what they are. So thin plates are found, and any number of crossings.
class LineCrossings {
 public:
  explicit LineCrossings(const FluidField& field) : field_(&field) {}

  void find(std::span<const AxisLine> lines);
  /// The same, given all the surfaces in which the wall lies near the lines.
  void find(std::span<const AxisLine> lines, std::span<const FluidField* const> surfaces);

  [[nodiscard]] bool startsInFluid(std::size_t line) const { return startsInFluid_[line] != 0; }
  /// The coordinates, ascending, at which fluid begins or ends.
  [[nodiscard]] std::span<const double> of(std::size_t line) const {
    return std::span(positions_).subspan(first_[line], first_[line + 1] - first_[line]);
  }
  /// The surface that is crossed there, of those in which the wall is known to lie; null: unknown.
  [[nodiscard]] const FluidField* surfaceAt(std::size_t line, std::size_t crossing) const {
    return surfaceOf_[first_[line] + crossing];
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

  /// Where a line crosses one of the surfaces in which walls lie.
  struct Root {
    std::size_t line = 0;
    double at = 0;
    const FluidField* surface = nullptr;
    std::uint64_t crossed = 0;  ///< a bit for each surface that is crossed an odd number of times
  };
  /// On which side of each surface a stretch of a line is, by a bit for each.
  struct Sides {
    std::uint64_t above = 0;  ///< values are positive
    std::uint64_t along = 0;  ///< the line lies in it, as its ends tell

    bool operator==(const Sides&) const = default;
  };
  static constexpr std::size_t kMostTold = 64;
  /// Stretches on the same sides.
  struct Alike {
    Sides sides;
    double length = 0;   ///< of the longest
    Vec3<double> point;  ///< in its middle
  };
  /// Whether the values at both ends of a line are zero on a surface.
  struct ZeroEnds {
    const FluidField* start = nullptr;
    const FluidField* end = nullptr;
  };

  void begin();
  void evaluateEnds(std::span<const AxisLine> lines);
  void addBracket(const AxisLine& line, double from, double fromValue, double to, double toValue);
  void addBrackets(const AxisLine& line, double from, double to);
  void findRoots(std::span<const AxisLine> lines, std::span<const FluidField* const> surfaces);
  void mergeRoots(std::span<const AxisLine> lines);
  void evaluateStretches(std::span<const AxisLine> lines);
  [[nodiscard]] std::size_t alikeOf(const Sides& sides);
  void addCrossings(const AxisLine& line, const ZeroEnds& zero, std::span<const Root> roots,
                    std::span<const double> middles);
  /// A point of the line on the other side, between ends on the same one, if one is found.
  bool findTurn(const AxisLine& line, double from, double to, double& at, double& value) const;
  bool findHidden(const AxisLine& line, double from, double to, double& at, double& value) const;
  void solve();

  const FluidField* field_;
  std::unique_ptr<LineCrossings> ofSurface_;
  std::vector<Root> roots_;         // by line, ascending
  std::vector<ZeroEnds> zeroEnds_;  // of each line
  std::vector<Sides> starts_;       // of each line
  std::vector<Alike> alike_;
  std::vector<double> ofAlike_;       // values in their middles
  std::vector<std::size_t> alikeOf_;  // of each stretch
  bool areSidesTold_ = false;         // there are no more surfaces than bits
  std::vector<double> ends_;          // values at both ends of each line
  std::vector<Bracket> brackets_;
  std::vector<char> startsInFluid_;
  std::vector<std::size_t> first_;
  std::vector<double> positions_;
  std::vector<const FluidField*> surfaceOf_;  // at each of these
  std::vector<std::size_t> open_;             // brackets that are not done
  std::vector<Vec3<double>> points_;
  std::vector<double> values_;
};

}  // namespace cutwater
