#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Polyhedra/Detail/KeptRegions.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
KeptRegions::KeptRegions(const CutLeaves& leaves, const OctreeCells<T>& mesh, const LeafGrid& grid,
                         const FluidMeshOptions& options)
    : regions_(leaves, mesh) {
  const auto regions = regions_.regions();
  const bool isAnyOpen = std::ranges::any_of(regions, &CutRegion::goesOn);
  const auto wanted = options.within ? regionAt(*options.within, leaves, grid) : kNone;
  for (std::uint32_t n = 0; n < regions.size(); ++n) {
    const bool isKept = options.within                       ? n == wanted
                        : options.cavities == Cavities::Kept ? true
                        : isAnyOpen                          ? regions[n].goesOn
                                                             : n == 0;
    number_.push_back(isKept ? static_cast<std::uint32_t>(volumes_.size()) : kNone);
    if (isKept) {
      volumes_.push_back(regions[n].volume);
    } else {
      lostVolume_ += regions[n].volume;
      ++lostCount_;
    }
  }
}

/// Of the leaf that has the point, if all of its fluid is one region.
std::uint32_t KeptRegions::regionAt(const Vec3<double>& point, const CutLeaves& leaves,
                                    const LeafGrid& grid) const {
  std::uint32_t region = kNone;
  const auto add = [&](std::uint32_t other) {
    require(region == kNone || region == other,
            "fluidMesh: need a point that is farther from walls", Named{"within", point});
    region = other;
  };
  for (std::uint32_t leaf = 0; leaf < leaves.classes.size() && region == kNone; ++leaf) {
    if (!grid.boxOf(leaf).contains(point)) continue;
    if (leaves.classes[leaf] == FluidClass::Fluid) add(regions_.ofLeaf(leaf));
    const auto row = leaves.rowOf(leaf);
    if (row == CutLeaves::kNoRow) continue;
    for (auto p = leaves.cut.firstPiece[row]; p < leaves.cut.firstPiece[row + 1]; ++p) {
      add(regions_.ofPiece(p));
    }
  }
  require(region != kNone, "fluidMesh: need a point in the fluid", Named{"within", point});
  return region;
}

template KeptRegions::KeptRegions(const CutLeaves&, const OctreeCells<float>&, const LeafGrid&,
                                  const FluidMeshOptions&);
template KeptRegions::KeptRegions(const CutLeaves&, const OctreeCells<double>&, const LeafGrid&,
                                  const FluidMeshOptions&);

}  // namespace cutwater
