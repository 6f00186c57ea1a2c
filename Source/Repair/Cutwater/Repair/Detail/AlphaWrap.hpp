#pragma once

#include <Cutwater/Repair/Detail/Deadline.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// The alpha wrap of triangles, with all faces in patch 0. Needs coordinates of magnitude about 1.
/// @throws Error(Limit) if the time is up, Error(Topology) where CGAL fails.
[[nodiscard]] PolygonSoup alphaWrap(const PolygonSoup& triangles, double alpha, double offset,
                                    const Deadline& deadline);

}  // namespace cutwater::detail
