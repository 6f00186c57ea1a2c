#pragma once

#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <functional>
#include <optional>

namespace cutwater {

/// Quadrature in a box, or a rectangle, whose wall has edges and corners, as where operands of a
/// union meet: rows of lines, and slices of rows, are divided by Gauss rules between the places
/// where the normals of the wall that lines meet jump, or where they meet something else.
class KinkSweep {
 public:
  /// `linesLeft`: how many lines may still be looked at to find such places; counts down.
  KinkSweep(const FluidField& field, std::span<const GaussPoint> gauss, const BoxView& view,
            int& linesLeft, RulePoints& to)
      : field_(field),
        gauss_(gauss),
        view_(view),
        box_(view.box()),
        linesLeft_(linesLeft),
        to_(to),
        found_(field) {}

  /// Adds the fluid, by lines along the first of these axes, and the wall: by the same lines if it
  /// is a graph over them; else each part of it by lines along the axis nearest to its normal.
  void run(const SweepAxes& axes, bool isGraph);

 private:
  /// Where a line passes through the wall.
  struct Passage {
    double at = 0;
    Vec3<double> normal;
  };
  /// What a line meets.
  struct State {
    int axis = 0;
    bool startsInFluid = false;
    std::vector<Passage> passages;
  };
  using States = std::vector<State>;
  /// What lines meet at a place along an axis of the box.
  struct Place {
    double at = 0;
    States states;
  };
  using StatesAt = std::function<States(double)>;
  /// How what lines meet differs between two places.
  struct Change {
    bool isAny = false;
    const State* before = nullptr;  ///< of the line that differs
    const State* after = nullptr;
    std::optional<std::size_t> passage = {};  ///< whose normals differ; none: their number does
  };
  [[nodiscard]] Change changeBetween(const States& a, const States& b) const;

  void measure(bool withFluid);
  void addSlice(const SweptSlice& slice, bool withFluid);
  [[nodiscard]] std::vector<double> breaksOfRow(double slice);
  [[nodiscard]] States statesOfRow(double slice);
  [[nodiscard]] State stateOf(const AxisLine& line);
  /// Where states change along an axis of the box, ascending: at `known` places, and at those that
  /// are found between them; and the upper end.
  [[nodiscard]] std::vector<double> breaks(int axis, std::vector<double> known,
                                           const StatesAt& statesAt);
  void refine(int axis, const Place& from, const Place& to, const StatesAt& statesAt,
              std::vector<double>& found);
  [[nodiscard]] double predicted(int axis, double from, double to, const Change& change) const;

  const FluidField& field_;
  std::span<const GaussPoint> gauss_;
  const BoxView& view_;
  Box<double> box_;
  int& linesLeft_;
  RulePoints& to_;
  SweepAxes axes_;
  std::uint32_t sweep_ = 0;  // the number of this one
  bool isGraph_ = true;
  LineCrossings found_;
};

}  // namespace cutwater
