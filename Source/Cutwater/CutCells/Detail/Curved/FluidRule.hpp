#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

namespace cutwater {

/// The areas of what is open of the sides of a box across each axis; the lengths, of a rectangle.
struct OpenShares {
  Vec3<double> difference;  ///< of the upper less the lower side: a vector out of the box
  Vec3<double> sum;         ///< of both

  void add(int axis, int side, double area) {
    difference[axis] += side == 1 ? area : -area;
    sum[axis] += area;
  }
};

/// Quadrature of the fluid in boxes or rectangles, and of their walls, by dimension reduction (Saye
/// 2015): lines along an axis in which the wall is a graph, at Gauss points between the places
/// where the wall passes through the ends of lines.
///
/// Where the wall is no graph, boxes are halved. What is found of a box depends on it alone.
class FluidRule {
 public:
  /// `points`: of each Gauss rule, where that is enough.
  FluidRule(const FluidField& field, int points)
      : field_(field), fewest_(points), rims_(field), crossings_(field) {}

  /// The fluid in a box with these open sides, and its wall. If gap() is larger than `tolerance`,
  /// with the most points that rules have, then also in halves of the box; what has the least gap
  /// counts.
  void findIn(const BoxView& box, const OpenShares& sides, double tolerance);
  /// That in a rectangle, likewise; its edges tell what is open.
  void findIn(const BoxView& rectangle, double tolerance);
  /// All of a box or a rectangle.
  void takeAll(const Box<double>& box);

  [[nodiscard]] const RulePoints& points() const { return points_; }
  /// An estimate of the error of volumes and areas, in shares of the box and of its sides: by how
  /// much open sides and walls do not close, and differ from the volume by the divergence theorem,
  /// and the share of the box in which a wall is known and was not found.
  [[nodiscard]] double gap() const { return gap_; }

 private:
  [[nodiscard]] double gapIn(const BoxView& view, const OpenShares& sides) const;
  void addPart(const BoxView& view, int depth, int halvings);
  void addBetweenSurfaces(const Box<double>& box, std::span<const FluidField* const> surfaces,
                          int depth, int halvings);
  void addUncrossed(const BoxView& view, int depth, int halvings, bool mayHalve);
  [[nodiscard]] bool splitAtTurn(const BoxView& view, int depth, int halvings);
  void split(const Box<double>& box, int axis, double at, int depth, int halvings);
  [[nodiscard]] Vec3<double> centered(const Box<double>& box, Vec3<double> point);
  void forEachPart(std::span<const Box<double>> parts, FunctionRef<void(const Box<double>&)> add);
  void splitAt(const Box<double>& box, const Vec3<double>& found, int depth, int halvings);
  void addWhole(const Box<double>& box, int flatAxis);
  void sweep(const BoxView& view, const SweepAxes& axes);

  const FluidField& field_;
  int fewest_;
  std::span<const GaussPoint> gauss_;  // of the attempt at hand
  LineCrossings rims_;                 // of rows along the ends of lines
  LineCrossings crossings_;            // of lines
  std::vector<AxisLine> rows_;
  int flatAxis_ = -1;
  RulePoints points_;
  RulePoints best_;
  int parts_ = 0;      // of a box, however often it was halved, in all attempts
  int mostParts_ = 0;  // up to which the part at hand may be halved
  int linesLeft_ = 0;  // see KinkSweep
  double missed_ = 0;  // of the box: parts that hide a wall and could not be halved
  double gap_ = 0;
};

}  // namespace cutwater
