#include <Cutwater/Shapes/Detail/PolygonEdges.hpp>

namespace cutwater {

namespace detail {

template <std::floating_point T>
std::size_t crossingsToTheRight(const LinearBVH<T, PlanarEdge<T>>& edges, const Vec2<T>& p,
                                T farthest, FunctionRef<bool(std::uint32_t)> counts) {
  std::size_t found = 0;
  edges.along({{p.x, p.y, 0}, {farthest, p.y, 0}}, [&](std::uint32_t i) {
    const auto& edge = edges.primitives()[i];
    const bool startsBelow = edge.start().y <= p.y;
    const bool endsBelow = edge.end().y <= p.y;
    // An edge is to the right of p if it runs up with p to its left, or down with p to its right.
    if (startsBelow != endsBelow && counts(i) && edge.side(p) == (startsBelow ? 1 : -1)) ++found;
    return true;
  });
  return found;
}

template std::size_t crossingsToTheRight(const LinearBVH<float, PlanarEdge<float>>&,
                                         const Vec2<float>&, float,
                                         FunctionRef<bool(std::uint32_t)>);
template std::size_t crossingsToTheRight(const LinearBVH<double, PlanarEdge<double>>&,
                                         const Vec2<double>&, double,
                                         FunctionRef<bool(std::uint32_t)>);

}  // namespace detail

template class LinearBVH<float, detail::PlanarEdge<float>>;
template class LinearBVH<double, detail::PlanarEdge<double>>;

}  // namespace cutwater
