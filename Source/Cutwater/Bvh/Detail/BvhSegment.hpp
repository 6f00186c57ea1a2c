#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cmath>

namespace cutwater {

/// A segment for separating-axis tests against boxes. All coordinates are in the frame of a node,
/// where boxes are at most about 2 wide and at most about 2 from the origin.
class BvhSegment {
 public:
  CUTWATER_INLINE BvhSegment(const Vec3<double>& start, const Vec3<double>& end)
      : start_(start), half_(0.5 * (end - start)), middle_(start + half_) {
    // Positions are off by a few 2^-53 of their magnitude in the tree's frame, which is at most 1
    // larger.
    const double size = 1 + maxComponent(abs(start)) + maxComponent(abs(end));
    slack_ = 0x1p-48 * size;
    crossSlack_ = 0x1p-46 * size * size;
    const double lengthSquared = 4 * dot(half_, half_);
    direction_ = lengthSquared > 0 ? (2 / lengthSquared) * half_ : Vec3<double>{};
    directionLength_ = length(direction_);
    parameterSlack_ = 0x1p-20 + 0x1p-48 * size * directionLength_;
  }

  /// Whether an axis of the box, or a cross product of one with the segment, separates the two.
  [[nodiscard]] CUTWATER_INLINE bool isApart(const Vec3<double>& boxMiddle,
                                             const Vec3<double>& boxHalf) const {
    const Vec3<double> m = boxMiddle - middle_;
    for (int i = 0; i < 3; ++i) {
      if (std::abs(m[i]) > boxHalf[i] + std::abs(half_[i]) + slack_) return true;
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double reach = boxHalf[j] * std::abs(half_[k]) + boxHalf[k] * std::abs(half_[j]);
      if (std::abs(m[j] * half_[k] - m[k] * half_[j]) > reach + crossSlack_) return true;
    }
    return false;
  }
  /// Lower bound on the parameters at which points of the box project onto the segment; at least
  /// -1, which is before its start.
  [[nodiscard]] CUTWATER_INLINE float firstParameter(const Vec3<double>& boxMiddle,
                                                     const Vec3<double>& boxHalf) const {
    const Vec3<double> m = boxMiddle - start_;
    const double first = dot(m, direction_) - dot(boxHalf, abs(direction_));
    // The frame's axes are off by 2^-24, so products in it are off by less than 2^-20 of the
    // lengths.
    const Vec3<double> far = abs(m) + boxHalf;
    const double skew = 0x1p-20 * directionLength_ * (far.x + far.y + far.z);
    const double parameter = first - skew - parameterSlack_;
    return parameter > -1 ? static_cast<float>(parameter) : -1.0F;
  }

 private:
  Vec3<double> start_;
  Vec3<double> half_;
  Vec3<double> middle_;
  Vec3<double> direction_;  // dot product with it: parameter along the segment
  double slack_ = 0;
  double crossSlack_ = 0;
  double directionLength_ = 0;
  double parameterSlack_ = 0;
};

}  // namespace cutwater
