#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <span>

namespace cutwater {

/// Whether a surface has an edge between those of some points near it whose unit normals differ
/// most, but are not opposite. `flatAxis`: the axis across their plane; -1: they are in space.
[[nodiscard]] bool isKinked(const FluidField& field, std::span<const Vec3<double>> points,
                            std::span<const Vec3<double>> normals, int flatAxis);

}  // namespace cutwater
