#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Repair/Detail/Deadline.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater::detail {

/// Triangles between the points of a rim, given by their indices in it, oriented like the rim. The
/// face beside edge i, from point i to the next, has the third corner `third[i]`. Empty if there is
/// no good triangulation. @throws Error(Limit) if the time is up, Error(Topology) where CGAL fails.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> fillRim(std::span<const Vec3<double>> rim,
                                                                std::span<const Vec3<double>> third,
                                                                const Deadline& deadline);

}  // namespace cutwater::detail
