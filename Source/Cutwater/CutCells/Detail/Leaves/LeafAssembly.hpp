#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafTile.hpp>
#include <Cutwater/CutCells/Detail/Quadrature/GaussPoints.hpp>

#include <string>
#include <vector>

namespace cutwater {

/// The leaves of an octree that are cut, and what they are cut by.
struct LeafParts {
  const LeafGrid& grid;
  std::span<const LeafTile> tiles;  ///< in any order
  const CutFrame& frame;
  const std::vector<std::string>& patchNames;
  const CutSurface* surface = nullptr;  ///< of a mesh
  /// Of quadrature along each axis of a face, if it is wanted.
  std::span<const GaussPoint> gauss = {};
};

/// The rows of leaves, with these classes.
[[nodiscard]] CutLeaves assembledLeaves(const LeafParts& parts, std::vector<FluidClass> classes,
                                        const CutOptions& options);

}  // namespace cutwater
