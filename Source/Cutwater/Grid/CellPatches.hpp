#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>

namespace cutwater {

/// The patches in each cell of a mesh, row after row.
struct CellPatches {
  /// Row n is patches[offsets[n]] ... patches[offsets[n + 1] - 1].
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint32_t> patches;  ///< each once in a row, ascending
  /// True if the rows have every patch that meets a cell, because the whole surface was examined
  /// and not only samples.
  bool isComplete = true;

  /// The patches in one cell.
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t cell) const {
    return std::span(patches).subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
  }
};

/// Options of cellPatches().
struct CellPatchesOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Returns all patches that meet each cell (see patchNames()), one row for each of mesh.cells().
/// Rows of cells that are certainly Inside or Outside are empty.
///
/// Based on facetsIn(). Complete for meshes, their motions, unions, intersections and complements;
/// a patch that comes within round-off of a cell, or lies inside another operand there, may be
/// listed as well. For other solids, lists the patches that 27 samples of a cell find.
/// @throws Error if `threads` is negative.
template <std::floating_point T>
[[nodiscard]] CellPatches cellPatches(const SignedDistanceFunction<T>& solid,
                                      const OctreeCells<T>& mesh,
                                      const CellPatchesOptions& options = {});

extern template CellPatches cellPatches(const SignedDistanceFunction<float>&,
                                        const OctreeCells<float>&, const CellPatchesOptions&);
extern template CellPatches cellPatches(const SignedDistanceFunction<double>&,
                                        const OctreeCells<double>&, const CellPatchesOptions&);

}  // namespace cutwater
