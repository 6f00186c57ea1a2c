#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/FewerPoints.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cutwater {

/// A point of a rule, with its weight.
template <typename Point>
struct WeightedPoint {
  Point at{};
  double weight = 0;
};

/// Rules for regions of a plane that polygons bound: exact for polynomials up to a degree, of no
/// more points than there are monomials, with positive weights, all within the region.
///
/// Between corners, ordered along the first axis, lines along the second meet the same edges: what
/// is between these is integrated by Gauss rules, and of all points few are left (FewerPoints).
class PlaneRule {
 public:
  using Point = std::array<double, 2>;
  using Points = std::span<const WeightedPoint<Point>>;
  /// A part of the rim, with the region on its left, as the second axis is to the left of the
  /// first.
  struct Edge {
    Point from;
    Point to;
  };

  explicit PlaneRule(int degree);

  /// The region is where the rim winds around points. Valid until the next call, as below.
  [[nodiscard]] Points of(std::span<const Edge> rim);
  /// Not exact: with so many parts between the outermost corners instead, all of the points.
  [[nodiscard]] Points roughlyOf(std::span<const Edge> rim, int parts);

 private:
  void addLines(std::span<const Edge> rim, std::span<const GaussPoint> across);
  void addLine(double at, double weight, std::span<const Edge> rim);

  int degree_;
  FewerPoints few_;
  std::vector<double> corners_;                    // along the first axis
  std::vector<std::pair<double, int>> crossings_;  // of a line: where, and whether it enters: +-1
  std::vector<WeightedPoint<Point>> points_;
};

/// Rules for polyhedra, whose moments are known.
///
/// Lines in sections across an axis give points and rough weights, which are multiplied by the
/// polynomial that makes their moments right. If it is not positive everywhere, sections are taken
/// more densely, and at last between all corners, where they are exact as they are. Of all points
/// few are left (FewerPoints).
class PolyhedronRule {
 public:
  using Points = std::span<const WeightedPoint<Vec3<double>>>;
  /// A polygon that bounds it, with holes cut open, counterclockwise from without unless it is
  /// reversed. Each edge is one of two of them, in opposite ways.
  struct Side {
    std::span<const Vec3<double>> corners;
    bool isReversed = false;
  };

  explicit PolyhedronRule(int degree);

  /// Of the polyhedron that these sides close, and that has these moments about a point: see
  /// CutCells::Moments. Valid until the next call.
  [[nodiscard]] Points of(std::span<const Side> sides, std::span<const double> moments,
                          const Vec3<double>& about);

 private:
  static constexpr int kBetweenCorners = 0;  // in place of a number of parts

  void measure(std::span<const Side> sides);
  void addSections(std::span<const Side> sides, int parts);
  void addSection(double at, double weight, std::span<const Side> sides, int parts);
  void addSectionOf(const Side& side, double at);
  [[nodiscard]] bool fit(std::span<const double> moments, const Vec3<double>& about);

  int degree_;
  PlaneRule ofSections_;
  FewerPoints few_;
  std::array<int, 3> axes_{};                   // across sections, across their lines, along these
  std::array<std::vector<double>, 3> corners_;  // along each axis
  std::vector<double> ends_;                    // of parts across sections
  std::vector<PlaneRule::Edge> section_;
  std::vector<WeightedPoint<Vec3<double>>> points_;
  std::vector<double> values_;  // of monomials at each point
};

}  // namespace cutwater
