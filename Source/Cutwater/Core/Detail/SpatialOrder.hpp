#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// An order in which neighbours are close to each other in space: that of cubic cells along a
/// Z-order (Morton 1966), a cell for every two points or so if they are spread evenly. Those that
/// are not finite are in the first cell. Empty if most neighbours are close already, if there are
/// 2^32 points or more, or if there is no memory for it.
template <std::floating_point T>
[[nodiscard]] std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<T>> points, int threads);

extern template std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<float>>, int);
extern template std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<double>>, int);

}  // namespace cutwater::detail
