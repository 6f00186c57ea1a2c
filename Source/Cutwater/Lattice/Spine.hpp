#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A point of a curve with three unit vectors at right angles: binormal = tangent x normal.
struct SpineFrame {
  Vec3<double> point;
  Vec3<double> tangent;
  Vec3<double> normal;
  Vec3<double> binormal;
};

/// A smooth curve through points, with a frame that follows it without rotating about it.
///
/// The curve is the natural cubic spline over the lengths of the chords, parametrised by arc
/// length; its curvature is 0 at both ends, and it continues straight beyond them. The frame is the
/// rotation-minimizing one, by double reflection at 32 places per chord (Wang, Juettler, Zheng and
/// Liu 2008, "Computation of rotation minimizing frames"), whose error falls with the fourth power
/// of the step.
class Spine {
 public:
  /// `side`: the direction of the normal at the first point, made perpendicular to the curve; if
  /// zero, the coordinate axis that is most nearly perpendicular to the curve.
  /// @throws Error unless there are at least two points, all are finite, each differs from the
  /// next, `side` is not along the curve, and the curve does not reverse its direction at a point.
  explicit Spine(std::span<const Vec3<double>> points, const Vec3<double>& side = {});

  /// Arc length from the first point to the last.
  [[nodiscard]] double length() const { return samples_.back().arc; }
  /// The frame at this arc length from the first point. Accurate to about 1e-9 of a chord.
  [[nodiscard]] SpineFrame frameAt(double arc) const;

 private:
  /// A cubic in a parameter in [0, chord], given by its ends and the second derivatives there.
  struct Span {
    Vec3<double> begin, end;
    Vec3<double> bendAtBegin, bendAtEnd;
    double chord;

    [[nodiscard]] Vec3<double> point(double t) const;
    [[nodiscard]] Vec3<double> derivative(double t) const;
    /// Arc length from one parameter to another.
    [[nodiscard]] double arc(double from, double to) const;
  };
  struct Sample {
    std::uint32_t span;
    double t;
    double arc;
    SpineFrame frame;
  };

  void bend();
  void sample(const Vec3<double>& side);
  [[nodiscard]] SpineFrame moved(const SpineFrame& frame, const Span& span, double t) const;

  std::vector<Span> spans_;
  std::vector<Sample> samples_;
};

}  // namespace cutwater
