#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

namespace cutwater::detail {

/// All defects of a surface, the worst first. `mesh`: of the soup; `found`: what the checks found
/// so far, that is, the report, self-intersections and signs.
[[nodiscard]] std::vector<Defect> findDefects(const PolygonSoup& soup, const DcelMesh<double>& mesh,
                                              const Diagnosis& found);

/// The axis along which the surface has no extent, up to rounding, if there is one.
[[nodiscard]] std::optional<int> flatAxis(const PolygonSoup& soup);

}  // namespace cutwater::detail
