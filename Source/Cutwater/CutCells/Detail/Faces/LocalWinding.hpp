#pragma once

#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>

namespace cutwater {

/// The winding number at a point of a face, which need not lie in its plane: along the face's first
/// edge, then along its second axis. In floating point: near traces it may be that across.
[[nodiscard]] int windingOnFace(const TileSurface& surface, const EdgeStretches& stretches,
                                std::uint32_t face, const Vec3<double>& p);

/// The winding number at a point in a cell: up from its lower face. The same holds.
[[nodiscard]] int windingInCell(const TileSurface& surface, const EdgeStretches& stretches,
                                std::uint32_t cell, const Vec3<double>& p);

}  // namespace cutwater
