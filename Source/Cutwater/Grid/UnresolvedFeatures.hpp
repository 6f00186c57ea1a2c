#pragma once

#include <Cutwater/Grid/Octree.hpp>

namespace cutwater {

/// What signs at the corners of a cell do not tell of the surface in it.
enum class UnresolvedKind : std::uint8_t {
  Thin,      ///< all corners are on one side, yet the surface crosses edges, or no face at all
  Grazing,   ///< all corners are on one side, a bulge comes through a face and crosses no edge
  MultiCut,  ///< corners are on both sides, and there is more than one sheet
};

/// A cell whose corners do not tell all of the surface in it.
template <std::floating_point T>
struct UnresolvedFeature {
  std::size_t cell;  ///< place in Octree::cells()
  UnresolvedKind kind;
  bool isSolid;  ///< what corners do not see is solid, e.g. a thin plate; else fluid, e.g. a slit
  /// How far it reaches, across its thickness or into the cell, in sizes of the cell, as found from
  /// samples: where it is deepest; of several sheets, where an edge passes from one to the next
  /// over the widest stretch, or, if none does, where they are closest.
  T depth;
  Vec3<T> point;  ///< of the surface, there
  /// On which it would be about a cell wide; at most the domain's finest.
  int level;
};

/// Options of unresolvedFeatures().
struct UnresolvedOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// All cells of a mesh in which a code that knows no more than the signs at corners would lose a
/// part of the surface or get it wrong, the worst of each kind first: kinds in order, then by
/// depth.
///
/// Complete as far as classify() and crossings() are certain: a cell is listed if it is Cut with
/// all corners on one side; or if an edge is crossed more than once and something is between, or
/// corners of one side are not connected along the edges. Cells that are not certainly cut, which
/// the surface but touches, are listed if a part of positive depth is found in them: that of a
/// solid whose faces are those of cells, as corners on the surface count as outside.
template <std::floating_point T>
[[nodiscard]] std::vector<UnresolvedFeature<T>> unresolvedFeatures(
    const SignedDistanceFunction<T>& solid, const Octree<T>& mesh,
    const UnresolvedOptions& options = {});

extern template std::vector<UnresolvedFeature<float>> unresolvedFeatures(
    const SignedDistanceFunction<float>&, const Octree<float>&, const UnresolvedOptions&);
extern template std::vector<UnresolvedFeature<double>> unresolvedFeatures(
    const SignedDistanceFunction<double>&, const Octree<double>&, const UnresolvedOptions&);

}  // namespace cutwater
