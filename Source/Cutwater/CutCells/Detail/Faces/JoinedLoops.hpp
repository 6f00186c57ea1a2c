#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>

#include <vector>

namespace cutwater {

/// The loops around a connected part of a face, with the part on their left, as one outline: holes
/// are cut open by an edge there and back. Empty if there are none.
[[nodiscard]] std::vector<Vec3<double>> joinedLoops(const FaceAxes& axes,
                                                    std::vector<std::vector<Vec3<double>>> loops);

}  // namespace cutwater
