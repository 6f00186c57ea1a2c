#include <Cutwater/Shapes/Detail/PolygonDistance.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
PolygonDistance<T>::PolygonDistance(const Polygon<T>& polygon, EdgesOnAxis edgesOnAxis)
    : lower_(polygon.loops()[0][0]), upper_(lower_), tree_(edgesOf(polygon, edgesOnAxis)) {}

template <std::floating_point T>
std::vector<PlanarEdge<T>> PolygonDistance<T>::edgesOf(const Polygon<T>& polygon,
                                                       EdgesOnAxis edgesOnAxis) {
  std::vector<PlanarEdge<T>> edges;
  for (const auto& loop : polygon.loops()) {
    const auto first = static_cast<std::uint32_t>(edges.size());
    bool isFirstKept = false;
    bool isLastKept = false;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& a = loop[i];
      const auto& b = loop[(i + 1) % loop.size()];
      lower_ = {std::min(lower_.x, a.x), std::min(lower_.y, a.y)};
      upper_ = {std::max(upper_.x, a.x), std::max(upper_.y, a.y)};
      size_ = std::max(size_, length(a));
      const bool isKept = edgesOnAxis == EdgesOnAxis::Boundary || a.x != 0 || b.x != 0;
      if (i == 0) isFirstKept = isKept;
      if (!isKept && isLastKept) next_.back() = kNone;
      isLastKept = isKept;
      if (!isKept) continue;
      edges.emplace_back(a, b);
      next_.push_back(static_cast<std::uint32_t>(edges.size()));
    }
    if (isLastKept) next_.back() = isFirstKept ? first : kNone;
  }
  return edges;
}

template <std::floating_point T>
auto PolygonDistance<T>::nearest(const Vec2<T>& p) const -> NearestEdges {
  NearestEdges near{};
  near.count = tree_.nearest({p.x, p.y, 0}, near.edges);
  const T rounding = 16 * std::numeric_limits<T>::epsilon() * (length(p) + size_);
  while (near.count > 1 &&
         near.edges[near.count - 1].distance > near.edges[0].distance + rounding) {
    --near.count;
  }
  return near;
}

template <std::floating_point T>
bool PolygonDistance<T>::isInWedge(const Vec2<T>& p, std::uint32_t first) const {
  const auto& a = edge(first);
  const auto& b = edge(next_[first]);
  const bool isConvex = a.side(b.end()) >= 0;
  const bool isLeftOfA = a.side(p) > 0;
  const bool isLeftOfB = b.side(p) > 0;
  return isConvex ? isLeftOfA && isLeftOfB : isLeftOfA || isLeftOfB;
}

template <std::floating_point T>
bool PolygonDistance<T>::isInside(const Vec2<T>& p, const NearestEdges& near) const {
  // Near a single edge the solid is to the left of it, also at a corner that it shares with a
  // dropped edge: no query point lies to the right of that one.
  if (near.count == 0) return false;
  const auto first = near.edges[0].primitive;
  if (near.count == 1) return edge(first).side(p) > 0;
  const auto second = near.edges[1].primitive;
  if (near.count == 2 && next_[first] == second) return isInWedge(p, first);
  if (near.count == 2 && next_[second] == first) return isInWedge(p, second);
  if (p.x < lower_.x || p.x > upper_.x || p.y < lower_.y || p.y > upper_.y) return false;
  const auto all = [](std::uint32_t) { return true; };
  return crossingsToTheRight<T>(tree_, p, upper_.x, all) % 2 == 1;
}

template <std::floating_point T>
T PolygonDistance<T>::distance(const Vec2<T>& p) const {
  const auto near = nearest(p);
  const T distance = near.edges[0].distance;
  return isInside(p, near) ? -distance : distance;
}

template <std::floating_point T>
Vec2<T> PolygonDistance<T>::gradient(const Vec2<T>& p) const {
  const auto near = nearest(p);
  if (near.count == 0) return {};
  const bool inside = isInside(p, near);
  const auto slopeFrom = [&](const Nearest& nearest) {
    const auto foot = edge(nearest.primitive).foot(p);
    if (foot.isInside) return edge(nearest.primitive).outward();
    return normalized(inside ? -foot.toPoint : foot.toPoint);
  };
  const auto slope = slopeFrom(near.edges[0]);
  for (std::size_t i = 1; i < near.count; ++i) {
    const bool isTie = near.edges[i].distance == near.edges[0].distance;
    // Neighbours that meet at the nearest point give the same gradient.
    if (isTie && length(slopeFrom(near.edges[i]) - slope) > T(1e-3)) return {};
  }
  return slope;
}

template class PolygonDistance<float>;
template class PolygonDistance<double>;

}  // namespace cutwater::detail
