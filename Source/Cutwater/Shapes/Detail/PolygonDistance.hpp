#pragma once

#include <Cutwater/Shapes/Detail/PolygonEdges.hpp>
#include <Cutwater/Shapes/Polygon.hpp>

#include <array>

namespace cutwater::detail {

/// Treatment of edges on the line x = 0. They are part of the boundary or, if the polygon is a
/// profile to be revolved about that line, inside the solid.
enum class EdgesOnAxis : std::uint8_t { Boundary, Dropped };

/// The exact signed distance of a polygon in its plane. The time of a query grows with the
/// logarithm of the number of edges.
///
/// The sign is given by the side of the nearest edge, or by the wedge between two neighbours that
/// are equally near up to rounding. If other edges are equally near, crossings of a ray are
/// counted. Sides are exact, and so is the sign.
template <std::floating_point T>
class PolygonDistance {
 public:
  /// With EdgesOnAxis::Dropped, neither corners nor query points may have x < 0.
  PolygonDistance(const Polygon<T>& polygon, EdgesOnAxis edgesOnAxis);

  [[nodiscard]] T distance(const Vec2<T>& p) const;
  /// The gradient; zero where it is not defined.
  [[nodiscard]] Vec2<T> gradient(const Vec2<T>& p) const;

  /// Calls visit(edge) for those whose boxes meet that of x and y.
  template <typename Visit>
  void forEdgesIn(Box<T> box, const Visit& visit) const {
    box.lower.z = box.upper.z = 0;
    tree_.overlapping(box, [&](std::uint32_t i) {
      visit(edge(i));
      return true;
    });
  }

  [[nodiscard]] const Vec2<T>& lower() const { return lower_; }
  [[nodiscard]] const Vec2<T>& upper() const { return upper_; }
  /// Distance of the farthest corner from the origin.
  [[nodiscard]] T size() const { return size_; }

 private:
  using Nearest = NearestPrimitive<T>;
  /// The edges nearest to a point: up to three that are equally near up to rounding; none where
  /// squares of distances overflow.
  struct NearestEdges {
    std::array<Nearest, 3> edges;
    std::size_t count;
  };
  [[nodiscard]] NearestEdges nearest(const Vec2<T>& p) const;
  [[nodiscard]] bool isInside(const Vec2<T>& p, const NearestEdges& near) const;
  /// Whether p is in the solid's wedge between an edge and the next.
  [[nodiscard]] bool isInWedge(const Vec2<T>& p, std::uint32_t edge) const;
  [[nodiscard]] const PlanarEdge<T>& edge(std::uint32_t i) const { return tree_.primitives()[i]; }
  std::vector<PlanarEdge<T>> edgesOf(const Polygon<T>& polygon, EdgesOnAxis edgesOnAxis);

  std::vector<std::uint32_t> next_;  // edge after each; kNone if dropped
  Vec2<T> lower_;
  Vec2<T> upper_;
  T size_ = 0;
  LinearBVH<T, PlanarEdge<T>> tree_;
};

extern template class PolygonDistance<float>;
extern template class PolygonDistance<double>;

}  // namespace cutwater::detail
