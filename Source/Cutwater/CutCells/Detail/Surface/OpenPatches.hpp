#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/CutCells/Detail/Surface/MovedSurface.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// What a triangle is to open patches, see CutterOptions::openPatches. One that lies across an
/// axis may be part of an aperture, where the grid has its plane.
enum class OpenKind : std::int8_t { AcrossX, AcrossY, AcrossZ, Inclined, Wall };

/// The axis that it lies across, if it does.
[[nodiscard]] inline bool hasAxis(OpenKind kind) {
  return kind <= OpenKind::AcrossZ;
}
[[nodiscard]] inline int axisOf(OpenKind kind) {
  return static_cast<int>(kind);
}

/// For what patches are named.
enum class PatchRole : std::uint8_t { Open, Baffle };

/// The numbers of patches with these names.
/// @throws Error(Argument) if there is none of a name, or a name is given twice.
[[nodiscard]] std::vector<std::uint32_t> patchesCalled(std::span<const std::string> names,
                                                       std::span<const std::string> patchNames,
                                                       PatchRole role);

/// The kinds of the triangles of the mesh, by exact comparisons; empty if no patch is open. One
/// without area lies in a plane of its patch, if it does in any; else it is a wall.
[[nodiscard]] std::vector<OpenKind> findOpenKinds(const MovedSurface& surface,
                                                  std::span<const std::uint32_t> patches,
                                                  std::span<const std::uint32_t> openPatches);

}  // namespace cutwater
