#pragma once

#include <Cutwater/Surface/Cleaning/Detail/PlanarView.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace cutwater::detail {

/// Flips edges between two triangles until no corner lies in the circle through the corners of a
/// neighbour by more than two hundredths of the larger radius: triangles are as well shaped as
/// their boundary lets them be, which stays, and points on a common circle keep the triangles they
/// have.
///
/// Seen along the axis, the triangles must turn `way`, see PlanarView::turn(), and not overlap;
/// flat ones are flipped away. At most n^2 / 2 flips for n corners, in practice about n. Lawson,
/// "Software for C1 surface interpolation", Mathematical Software III, 1977; the result is the
/// triangulation of Lee and Lin, "Generalized Delaunay triangulation for planar graphs", Discrete
/// Comput. Geom. 1 (1986).
void flipToDelaunay(const PlanarView& view, int way,
                    std::span<std::array<std::uint32_t, 3>> triangles);

}  // namespace cutwater::detail
