#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>

namespace cutwater {

/// The patches in each cell of a mesh, row after row.
struct CellPatches {
  /// Row n is patches[offsets[n]] ... patches[offsets[n + 1] - 1].
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint32_t> patches;  ///< each once in a row, ascending
  /// No patch that meets a cell is left out: all of the surface was seen, and no mere samples.
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

/// All patches that meet each cell, see patchNames(); rows of cells that are certainly Inside or
/// Outside are empty. Rows are those of mesh.cells().
///
/// Made from facetsIn(): complete for meshes, their motions, unions, intersections and complements,
/// with a patch that comes within rounding of a cell, or lies within another operand there, perhaps
/// named as well. Of other solids, patches that 27 samples of a cell find.
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
