#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/SolidAngle.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater {

void SolidAngleSum::addNearby(const std::array<Vec3<double>, 3>& triangle, const Factor& rounded) {
  const auto& [re, im, size] = rounded;
  const double largest = std::max(std::abs(re), std::abs(im));
  // The sign of im matters where re is negative. It is certain beyond 2^-49 of size.
  const bool sideIsCertain = re > 0 || std::abs(im) > 0x1p-40 * size;
  if (size > 0x1p-300 && largest > 0x1p-10 * size && sideIsCertain) {
    multiply(re, im);
    error_ += 0x1p-49 * size / largest;  // 53 u of size, over 2 pi, and the product's rounding
  } else {
    addClosely(triangle);
  }
}

/// Uses twice the precision, for a point very close to an edge, a vertex or the triangle itself.
void SolidAngleSum::addClosely(const std::array<Vec3<double>, 3>& triangle) {
  const int side = -sideOf(p_, triangle);
  if (side == 0) return;
  const auto a = DoubleDouble3::difference(triangle[0], p_);
  const auto b = DoubleDouble3::difference(triangle[1], p_);
  const auto c = DoubleDouble3::difference(triangle[2], p_);
  const auto la = sqrt(dot(a, a));
  const auto lb = sqrt(dot(b, b));
  const auto lc = sqrt(dot(c, c));
  const auto size = static_cast<double>(la * lb * lc);
  const auto re =
      static_cast<double>(la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  const auto im = side * std::abs(static_cast<double>(dot(a, cross(b, c))));
  const double largest = std::max(std::abs(re), std::abs(im));
  // About a hundred roundings of 2^-102. Closer to an edge the result is undetermined: the solid
  // angle of a triangle is at most half a turn.
  const bool representable = std::min({la.high, lb.high, lc.high}) > 0x1p-300;
  if (!representable || !(largest > 0x1p-84 * size)) {
    error_ += 0.5;
    return;
  }
  multiply(re / largest, im / largest);
  error_ += 0x1p-50 + 0x1p-94 * size / largest;
}

/// Scales to about 1 by a power of two. One factor is between 2^-320 and 2^190, so nothing is lost
/// before.
void SolidAngleSum::rescale(double magnitude) {
  const int exponent = -std::ilogb(magnitude);
  re_ = std::ldexp(re_, exponent);
  im_ = std::ldexp(im_, exponent);
}

double SolidAngleSum::turns() const {
  return windings_ + std::atan2(im_, re_) / (2 * std::numbers::pi);
}

}  // namespace cutwater
