#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstddef>
#include <optional>

namespace cutwater::detail {

/// Directions of a box's sides: orthonormal up to rounding to float.
using BoxAxes = std::array<Vec3<float>, 3>;

/// Directions of a box that fits triangles: the last along their mean normal, whichever way they
/// face, the first along their longest extent across it. Corners should be relative to a point
/// among them. None if the triangles have no such directions.
[[nodiscard]] std::optional<BoxAxes> fittingAxes(
    std::size_t count, FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> triangle);

/// A point's coordinates along axes.
[[nodiscard]] inline Vec3<double> along(const BoxAxes& axes, const Vec3<double>& p) {
  return {dot(Vec3<double>(axes[0]), p), dot(Vec3<double>(axes[1]), p),
          dot(Vec3<double>(axes[2]), p)};
}

}  // namespace cutwater::detail
