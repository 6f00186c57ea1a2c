#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <optional>

namespace cutwater {

/// What is certain about boxes and rectangles: by whether the surface may be in parts of them.
class Certifier {
 public:
  /// Views all. `period`: of the field, which has the images of the body where cells are cut.
  Certifier(const FluidField& field, const CutPeriod& period, const CertifyOptions& options)
      : field_(field), period_(period), options_(options) {}

  /// What is known of a box that others lie in.
  struct Around {
    Vec3<double> shift;
    BoxHint hint;
  };
  /// Whether the surface may be in a box. Notes for boxes within it what was found.
  [[nodiscard]] bool mayBeCut(const Box<double>& box, Around& around) const;

  /// The share of the fluid.
  [[nodiscard]] Interval<double> shareOf(const Box<double>& box) const {
    return shareOf(box, options_.width, options_.boxes);
  }
  /// The same, if nothing proves that all is fluid or all is body.
  [[nodiscard]] std::optional<Interval<double>> doubtAt(const Box<double>& box) const;

  /// Whether it is certain that the fluid in a box is so many connected parts, as far as boxes are
  /// small enough that all in which the surface may be are no larger together than the width: no
  /// more parts are known to be fluid, or all of these are known to be connected with one of them,
  /// and so many are apart.
  [[nodiscard]] bool arePieces(const Box<double>& box, std::size_t count) const;

 private:
  [[nodiscard]] Interval<double> shareOf(const Box<double>& box, double width,
                                         std::size_t boxes) const;
  [[nodiscard]] Vec3<double> shiftOf(const Box<double>& box) const;
  [[nodiscard]] int axisBeyond(const Box<double>& box) const;

  const FluidField& field_;
  const CutPeriod& period_;
  const CertifyOptions& options_;
};

}  // namespace cutwater
