#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A closed way in a plane across an axis, by its corners.
using OutlineLoop = std::vector<Vec3<double>>;

/// One outline of a connected region: of its loops, which have it on the left as seen against the
/// axis, the one around it, with the others cut open by an edge there and back.
[[nodiscard]] OutlineLoop joinedLoops(std::vector<OutlineLoop> loops, const FaceAxes& axes);

/// The same of the region that polygons make up together, counterclockwise as seen against the
/// axis: edges that two of them have, to the bit, are within it.
[[nodiscard]] OutlineLoop unitedOutline(std::span<const OutlineLoop> polygons,
                                        const FaceAxes& axes);

}  // namespace cutwater
