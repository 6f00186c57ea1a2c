#pragma once

#include <Cutwater/Core/Vec3.hpp>

namespace cutwater {

/// Sums up the area and the centroid of a plane region by the divergence theorem: each straight
/// part of its rim adds its distance from a point times the integral of the monomial along it. The
/// region is on the left of its rim, as seen with the second axis of the plane upwards.
class FaceSum {
 public:
  /// Moments refer to this point, which is near the region so that they do not cancel.
  FaceSum(int firstAxis, int secondAxis, const Vec3<double>& reference)
      : first_(firstAxis), second_(secondAxis), reference_(reference) {}

  void addTrace(const Vec3<double>& from, const Vec3<double>& to) {
    const auto p = from - reference_;
    const auto q = to - reference_;
    add((p[first_] * (q[second_] - p[second_]) - p[second_] * (q[first_] - p[first_])),
        0.5 * (p[first_] + q[first_]), 0.5 * (p[second_] + q[second_]));
  }
  /// A part of an edge along the first axis or the second, at a place across it; above the region
  /// or below it.
  void addEdge(bool isAlongFirst, bool isAbove, double place, double middle, double length) {
    const double across = place - reference_[isAlongFirst ? second_ : first_];
    const double along = middle - reference_[isAlongFirst ? first_ : second_];
    const double twice = (isAbove ? across : -across) * length;
    add(twice, isAlongFirst ? along : across, isAlongFirst ? across : along);
  }

  [[nodiscard]] double area() const { return 0.5 * twiceArea_; }
  /// The reference where there is no area.
  [[nodiscard]] Vec3<double> centroid() const {
    auto result = reference_;
    if (!(twiceArea_ > 0)) return result;
    result[first_] += alongFirst_ / 1.5 / twiceArea_;
    result[second_] += alongSecond_ / 1.5 / twiceArea_;
    return result;
  }

 private:
  void add(double twice, double alongFirst, double alongSecond) {
    twiceArea_ += twice;
    alongFirst_ += twice * alongFirst;
    alongSecond_ += twice * alongSecond;
  }

  int first_;
  int second_;
  Vec3<double> reference_;
  double twiceArea_ = 0;
  double alongFirst_ = 0;  // integrals of coordinates from the reference, times 3
  double alongSecond_ = 0;
};

}  // namespace cutwater
