#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Vec2.hpp>

namespace cutwater::detail {

/// 1 if `p` lies to the left of the line from a to b, -1 if to the right; 0 if on the line, or if
/// twice the precision cannot decide.
[[nodiscard]] int sideOfLine(const Vec2<double>& a, const Vec2<double>& b, const Vec2<double>& p);

/// An edge of a polygon in the plane z = 0, with the solid to its left; a primitive of LinearBVH.
template <std::floating_point T>
class PlanarEdge {
 public:
  PlanarEdge(const Vec2<T>& start, const Vec2<T>& end);

  [[nodiscard]] const Vec2<T>& start() const { return start_; }
  [[nodiscard]] const Vec2<T>& end() const { return end_; }
  /// Unit vector to the right.
  [[nodiscard]] Vec2<T> outward() const { return {along_.y, -along_.x}; }
  [[nodiscard]] int side(const Vec2<T>& p) const;

  /// Relative to the nearest point of the edge; `isInside`: that point is no end of the edge.
  struct Foot {
    T distance;
    Vec2<T> toPoint;
    bool isInside;
  };
  [[nodiscard]] Foot foot(const Vec2<T>& p) const;

  [[nodiscard]] T distance(const Vec3<T>& p) const { return foot({p.x, p.y}).distance; }
  [[nodiscard]] Box<T> boundingBox() const;

 private:
  Vec2<T> start_;
  Vec2<T> end_;
  Vec2<T> along_;  // unit vector
  T length_;
};

extern template class PlanarEdge<float>;
extern template class PlanarEdge<double>;

}  // namespace cutwater::detail
