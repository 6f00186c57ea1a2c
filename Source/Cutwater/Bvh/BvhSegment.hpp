#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cmath>

namespace cutwater {

/// A segment for separating-axis tests against boxes; all in a tree's frame.
class BvhSegment {
 public:
  CUTWATER_INLINE BvhSegment(const Vec3<double>& start, const Vec3<double>& end)
      : start_(start), half_(0.5 * (end - start)), middle_(start + half_) {
    // Positions in the frame are off by a few 2^-53 of their size; boxes are at most 1 wide.
    const double size = 1 + maxComponent(abs(start)) + maxComponent(abs(end));
    slack_ = 0x1p-48 * size;
    crossSlack_ = 0x1p-46 * size * size;
    const double lengthSquared = 4 * dot(half_, half_);
    direction_ = lengthSquared > 0 ? (2 / lengthSquared) * half_ : Vec3<double>{};
    parameterSlack_ = 0x1p-20 + 0x1p-48 * size * length(direction_);
  }

  /// Whether an axis of the box, or one across it and the segment, separates the two.
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
  /// No point of the box projects onto the segment at a smaller parameter.
  [[nodiscard]] CUTWATER_INLINE float firstParameter(const Vec3<double>& boxMiddle,
                                                     const Vec3<double>& boxHalf) const {
    const double first = dot(boxMiddle - start_, direction_) - dot(boxHalf, abs(direction_));
    return static_cast<float>(first - parameterSlack_);
  }

 private:
  Vec3<double> start_;
  Vec3<double> half_;
  Vec3<double> middle_;
  Vec3<double> direction_;  // times a vector: its share of the segment
  double slack_ = 0;
  double crossSlack_ = 0;
  double parameterSlack_ = 0;
};

}  // namespace cutwater
