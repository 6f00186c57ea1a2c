#pragma once

#include <Cutwater/Core/Vec2.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// An area in a plane, bounded by closed loops of straight edges: outlines, holes and islands in
/// holes.
///
/// Loops nest: points surrounded by an odd number of loops are solid (even-odd rule), whatever the
/// orientation of the loops. No two edges may cross or touch, except neighbours in their corner.
template <std::floating_point T>
class Polygon {
 public:
  /// Corners, in order.
  using Loop = std::vector<Vec2<T>>;

  /// A loop's last corner is joined to its first; a corner equal to the one before is dropped.
  /// O(n log n) for n corners, unless the bounding boxes of many edges overlap.
  /// @throws Error if a coordinate is not finite, a loop has fewer than three different corners, or
  /// edges cross, touch or fold back on each other.
  explicit Polygon(const Loop& outline, const std::vector<Loop>& others = {});

  /// The loops with the solid to the left: outlines run counterclockwise, holes clockwise.
  [[nodiscard]] std::span<const Loop> loops() const { return loops_; }
  [[nodiscard]] T area() const;

 private:
  std::vector<Loop> loops_;
};

extern template class Polygon<float>;
extern template class Polygon<double>;

}  // namespace cutwater
