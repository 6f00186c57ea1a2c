#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>

namespace cutwater {

/// The outline of the arc of an open patch, made up by these polygons with normals into the fluid;
/// `isBelow`: where the fluid is.
[[nodiscard]] std::vector<Vec3<double>> openOutline(const CutCells::Polygons& parts,
                                                    const FaceAxes& axes, bool isBelow);

/// Notes that an arc is a part of an open patch.
inline void addOpenRow(std::size_t arc, std::uint32_t patch, CutCells::OpenArcs& rows) {
  rows.arc.push_back(static_cast<std::uint32_t>(arc));
  rows.patch.push_back(patch);
}

/// Throws Error(Topology) that names the first of these by triangle and place, if there are any.
void refuseMisfits(const CutSurface& surface, std::span<const OpenMisfit> misfits);

}  // namespace cutwater
