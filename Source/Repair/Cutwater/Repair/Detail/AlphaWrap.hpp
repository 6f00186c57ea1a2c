#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Repair/Detail/Deadline.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

namespace cutwater::detail {

/// The alpha wrap of triangles, with all faces in patch 0. Needs coordinates of magnitude about 1.
/// `points`: how many the wrap is expected to have, for the progress.
/// @throws Error(Limit) if the time is up, Error(Topology) where CGAL fails.
[[nodiscard]] PolygonSoup alphaWrap(const PolygonSoup& triangles, double alpha, double offset,
                                    const Deadline& deadline, double points = 0,
                                    const Progress& progress = {});

}  // namespace cutwater::detail
