#pragma once

#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <array>
#include <span>

namespace cutwater {

/// Quadrature in a box, or a rectangle, whose wall lies in several smooth surfaces: rows of lines,
/// and slices of rows, are divided by Gauss rules between the places where surfaces leave through
/// the sides or meet each other. Between these, what lines meet depends smoothly on where they are.
///
/// Dimension reduction with several functions, as of Saye 2022; but the places where two or three
/// surfaces meet are found by Newton's method, as the functions are no polynomials.
class SurfaceSweep {
 public:
  /// `surfaces`: those that may meet the box. Views all of them.
  SurfaceSweep(const FluidField& field, std::span<const GaussPoint> gauss, const Box<double>& box,
               std::span<const FluidField* const> surfaces);

  /// Whether no surface can meet the box.
  [[nodiscard]] bool isUncrossed() const { return seen_.empty(); }
  /// Whether each surface is a graph along an axis, and no row or slice has a place where one
  /// begins or ends within it, or two of them begin or end to meet.
  [[nodiscard]] bool isGood() const { return flaws_ == 0; }
  /// Where to divide the box if not: across the axis, at a coordinate.
  struct Division {
    int axis = 0;
    double at = 0;
  };
  [[nodiscard]] Division division() const;
  /// Whether one of the surfaces seems to have an edge in the box itself.
  [[nodiscard]] bool hasKink() const;

  /// Where points go, and what finds them.
  struct Into {
    LineCrossings& rims;   ///< of rows along the ends of lines
    LineCrossings& lines;  ///< of lines
    RulePoints& points;
  };
  /// Adds the fluid and its wall. Each surface's part of it is measured by lines along an axis over
  /// which it is a graph.
  void run(const Into& into) const;

 private:
  static constexpr std::size_t kSamples = 9;
  /// A surface, and its unit normals near the corners and the middle of the box.
  struct Seen {
    const FluidField* field = nullptr;
    std::array<Vec3<double>, kSamples> points{};
    std::array<Vec3<double>, kSamples> normals{};
    std::array<bool, kSamples> isOnIt{};  // each of these points; all, if few are
    int wallAxis = 0;                     // over which it is a graph
    bool isGraph = false;
    std::array<bool, 3> isMonotone{};  // along an axis: it crosses lines at most once

    [[nodiscard]] bool isMonotoneAlong(int axis) const {
      return isMonotone[static_cast<std::size_t>(axis)];
    }
  };

  void see(const FluidField& surface);
  bool sample(std::span<const double> values, Seen& seen) const;
  void draw(Vec3<double>& point, double& value, const FluidField& surface) const;
  [[nodiscard]] Vec3<double> slopeOf(const FluidField& surface, const Vec3<double>& point) const;
  void chooseAxes();
  [[nodiscard]] bool leavesAlongRows(const Seen& seen, const SweepAxes& axes) const;
  [[nodiscard]] int flawsOf(const SweepAxes& axes) const;
  [[nodiscard]] bool mayTouchInRows(const Seen& a, const Seen& b, const SweepAxes& axes) const;
  [[nodiscard]] bool mayMeet(const Seen& a, const Seen& b) const;
  [[nodiscard]] int bendingAxis() const;
  [[nodiscard]] bool hasWallAlong(int axis) const;
  [[nodiscard]] bool isFree(int axis) const { return axis != flatAxis_; }
  void sweep(const SweepAxes& axes, std::span<const SweptSlice> slices, bool withFluid,
             const Into& into) const;
  [[nodiscard]] std::vector<SweptSlice> slices(const SweepAxes& axes, LineCrossings& edges) const;
  void addMeetings(const Box<double>& region, int axis, std::vector<double>& found) const;

  const FluidField& field_;
  std::span<const GaussPoint> gauss_;
  Box<double> box_;
  int flatAxis_ = -1;
  std::vector<Seen> seen_;
  std::vector<const FluidField*> surfaces_;  // of these
  SweepAxes axes_;
  int flaws_ = 0;
};

}  // namespace cutwater
