#pragma once

// Poisson's equation on cut cells, by finite volumes of second order.

#include <functional>
#include <vector>

#include "ControlVolumes.hpp"

/// What is known at a boundary.
struct Condition {
  enum class Kind {
    Value,       ///< Dirichlet's
    Derivative,  ///< Neumann's: along the normal out of the fluid
  };
  Kind kind = Kind::Value;
  double value = 0;
};

/// A point of a wall, or of a side of the box.
struct BoundaryPoint {
  static constexpr std::uint32_t kSide = ControlVolumes::kNone;

  cutwater::Vec3<double> at;
  cutwater::Vec3<double> normal;  ///< unit, out of the fluid
  std::uint32_t patch = kSide;    ///< of CutCells::patchNames
};

/// The Laplacian of u is `source`, with `condition` at walls and sides.
struct Problem {
  std::function<double(const cutwater::Vec3<double>& at)> source;
  std::function<Condition(const BoundaryPoint& point)> condition;
};

/// Fluxes through open parts are derivatives at their centroids: central differences between cells
/// that are all fluid, and otherwise those of a polynomial of degree two that fits values and
/// conditions around by weighted least squares, along connected fluid only, so that nothing is
/// taken through a plate (Johansen and Colella 1998 and Schwartz et al. 2006 interpolate; least
/// squares: Devendran et al. 2017). What leaves a volume through its open parts enters the next
/// one.
///
/// Where there are derivatives alone, the source is shifted by a number so that they can be met,
/// and the mean of u is 0. All fluid must be connected then.
class Poisson {
 public:
  Poisson(const ControlVolumes& volumes, Problem problem);

  /// The value of u in each volume, at its centroid.
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// The gradient at a point, by the same fit. 0 in the body.
  [[nodiscard]] cutwater::Vec3<double> gradient(const cutwater::Vec3<double>& at) const;
  /// What is left of the equations, over their right side.
  [[nodiscard]] double residual() const { return residual_; }
  /// Of the linear solver.
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  /// A linear combination of values, and a number.
  struct Combination {
    struct Term {
      std::uint32_t volume;
      double factor;
    };
    std::vector<Term> terms = {};
    double constant = 0;
  };
  class Fit;
  struct System;

  [[nodiscard]] std::vector<std::uint32_t> around(std::vector<std::uint32_t> seeds) const;
  /// The derivative along a unit direction.
  [[nodiscard]] Combination derivative(const cutwater::Vec3<double>& at,
                                       const cutwater::Vec3<double>& direction,
                                       const std::vector<std::uint32_t>& seeds) const;
  /// Along the axis of the open part, times its area.
  [[nodiscard]] Combination fluxThrough(const OpenPart& part) const;
  [[nodiscard]] Combination fluxInto(const WallPart& wall, std::uint32_t volume) const;
  [[nodiscard]] System assemble() const;
  void solve();

  const ControlVolumes& volumes_;
  Problem problem_;
  std::vector<double> values_;
  double residual_ = 0;
  int iterations_ = 0;
};
