#pragma once

#include <Cutwater/Grid/Octree.hpp>

#include "Options/Cutter.hpp"
#include "Options/MeshOptions.hpp"
#include "Report/CellTotals.hpp"

namespace cutwater::tool {

/// An octree whose leaves are going to be cut.
struct CutOctree {
  MeshOptions mesh;         ///< its rules, its place and its limits
  bool polygons = false;    ///< whether those of pieces are kept
  double bytesPerLeaf = 0;  ///< memory of each leaf, cut or not, beside what cutting takes
  int threads = 0;
  bool quiet = false;
};

/// Makes it around a solid, once it is known that there is room for it and for its leaves when they
/// are cut.
/// @param trial  Cutter::trial(): it cuts larger leaves, by which the time is estimated.
/// @throws Error(Limit) if there is no room.
[[nodiscard]] Octree<double> octreeToCut(const CutOctree& wanted, const Solid<double>& solid,
                                         const Cutter& trial, const PlacedSurface& placed);

}  // namespace cutwater::tool
