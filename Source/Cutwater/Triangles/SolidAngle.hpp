#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cmath>

namespace cutwater {

/// The sum of the solid angles that oriented triangles subtend at a point, in turns of 4 pi:
/// positive for a triangle whose corners run clockwise as seen from the point, as those of a closed
/// surface do from within.
///
/// Half a solid angle is the argument of den + i num of van Oosterom and Strackee (1983, "The solid
/// angle of a plane triangle", IEEE Trans. Biomed. Eng. 30), so a sum of them is the argument of a
/// product: one atan2 for all triangles. The windings of the product around zero are counted.
///
/// The side of a triangle on which the point lies is decided exactly, and by sideOf()'s
/// perturbation if it is on neither, so sums agree with passage(). Coordinates: see
/// ExactPredicates.hpp.
class SolidAngleSum {
 public:
  explicit SolidAngleSum(const Vec3<double>& p) : p_(p) {}

  /// Corners counter-clockwise seen from outside.
  void add(const std::array<Vec3<double>, 3>& triangle);

  /// The sum over all triangles so far, in units of 4 pi.
  [[nodiscard]] double turns() const;
  /// turns() differs from the true sum by at most this.
  [[nodiscard]] double error() const { return error_ + 0x1p-48 * (count_ + 1); }

 private:
  /// The complex number den + i num, and the product of the lengths of the three vectors from which
  /// it is computed, to which its rounding is proportional.
  struct Factor {
    double re;
    double im;
    double size;
  };

  void addNearby(const std::array<Vec3<double>, 3>& triangle, const Factor& rounded);
  void addClosely(const std::array<Vec3<double>, 3>& triangle);
  void multiply(double re, double im);
  void rescale(double magnitude);

  Vec3<double> p_;
  double re_ = 1;
  double im_ = 0;
  double windings_ = 0;
  double count_ = 0;  // of triangles with the least error
  double error_ = 0;  // of the others
};

inline void SolidAngleSum::multiply(double re, double im) {
  const double productRe = re_ * re - im_ * im;
  const double productIm = re_ * im + im_ * re;
  // Two arguments in [0, pi] whose sum is above pi, or in [-pi, 0] with a sum below -pi. The sign
  // bit shows which: it is right for zeros, too, and atan2 agrees with it.
  const bool negative = std::signbit(im);
  if (negative == std::signbit(im_) && negative != std::signbit(productIm)) {
    windings_ += negative ? -1 : 1;
  }
  re_ = productRe;
  im_ = productIm;
  const double magnitude = std::abs(re_) + std::abs(im_);
  if (!(magnitude > 0x1p-300 && magnitude < 0x1p300)) rescale(magnitude);
}

inline void SolidAngleSum::add(const std::array<Vec3<double>, 3>& triangle) {
  const Vec3<double> a = triangle[0] - p_;
  const Vec3<double> b = triangle[1] - p_;
  const Vec3<double> c = triangle[2] - p_;
  const double la = length(a);
  const double lb = length(b);
  const double lc = length(c);
  const double size = la * lb * lc;
  const double re = size + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  const double im = dot(a, cross(b, c));
  // With u = 2^-53: differences are within u, lengths within 3.5 u, re and im within 50 u and 16 u
  // of size; so here the argument is within 110 u, the product's rounding included, and an argument
  // of 2 pi is a turn. (Below 2^-300 the squares in the lengths may have underflowed.)
  if (re > 0.5 * size && size > 0x1p-300) {
    multiply(re, im);
    count_ += 1;
  } else {
    addNearby(triangle, {re, im, size});
  }
}

}  // namespace cutwater
