#pragma once

#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Shapes/Detail/PlanarEdge.hpp>

#include <vector>

namespace cutwater {

extern template class LinearBVH<float, detail::PlanarEdge<float>>;
extern template class LinearBVH<double, detail::PlanarEdge<double>>;

namespace detail {

/// The number of edges accepted by `counts` that the ray from p along x crosses. An edge includes
/// its lower end but not its upper one; an edge on which the ray starts does not count.
template <std::floating_point T>
[[nodiscard]] std::size_t crossingsToTheRight(const LinearBVH<T, PlanarEdge<T>>& edges,
                                              const Vec2<T>& p, T farthest,
                                              FunctionRef<bool(std::uint32_t)> counts);

extern template std::size_t crossingsToTheRight(const LinearBVH<float, PlanarEdge<float>>&,
                                                const Vec2<float>&, float,
                                                FunctionRef<bool(std::uint32_t)>);
extern template std::size_t crossingsToTheRight(const LinearBVH<double, PlanarEdge<double>>&,
                                                const Vec2<double>&, double,
                                                FunctionRef<bool(std::uint32_t)>);

}  // namespace detail

}  // namespace cutwater
