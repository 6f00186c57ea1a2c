#pragma once

#include <Cutwater/Grid/Octree.hpp>

namespace cutwater {

/// How the signs at a cell's corners fail to describe the surface in it.
enum class UnresolvedKind : std::uint8_t {
  Thin,      ///< all corners are on one side, yet the surface crosses edges, or meets no face
  Grazing,   ///< all corners are on one side; a bulge comes through a face but crosses no edge
  MultiCut,  ///< corners are on both sides, and there is more than one sheet
};

/// A cell whose corners do not resolve all of the surface in it.
template <std::floating_point T>
struct UnresolvedFeature {
  std::size_t cell;  ///< index in Octree::cells()
  UnresolvedKind kind;
  bool isSolid;  ///< the unresolved part is solid, e.g. a thin plate; else fluid, e.g. a slit
  /// Its extent in units of the cell size, found from samples: its thickness, or how far it reaches
  /// into the cell, at the deepest point. Of several sheets: the widest distance between two along
  /// one edge, or, if no edge meets two, the least distance between them.
  T depth;
  /// Where that was measured: a point of the surface, or the middle between two sheets. The cell's
  /// center if no point was found.
  Vec3<T> point;
  /// Level on which it would be about one cell wide; at most the domain's finest.
  int level;
};

/// Options of unresolvedFeatures().
struct UnresolvedOptions {
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// Returns all cells of a mesh in which a code that knows only the signs at corners would lose part
/// of the surface or get it wrong, sorted by kind, then by depth, the worst of each kind first.
///
/// Complete as far as classify() and crossings() are certain. A cell is listed if it is Cut with
/// all corners on one side, if an edge is crossed more than once with something in between, or if
/// corners of one side are not connected along the edges. A cell that the surface only touches is
/// not certainly cut; it is listed if samples find a part of positive depth in it. This happens
/// where faces of the solid coincide with faces of cells, because corners on the surface count as
/// outside.
template <std::floating_point T>
[[nodiscard]] std::vector<UnresolvedFeature<T>> unresolvedFeatures(
    const SignedDistanceFunction<T>& solid, const Octree<T>& mesh,
    const UnresolvedOptions& options = {});

extern template std::vector<UnresolvedFeature<float>> unresolvedFeatures(
    const SignedDistanceFunction<float>&, const Octree<float>&, const UnresolvedOptions&);
extern template std::vector<UnresolvedFeature<double>> unresolvedFeatures(
    const SignedDistanceFunction<double>&, const Octree<double>&, const UnresolvedOptions&);

}  // namespace cutwater
