#pragma once

#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <cstdint>
#include <vector>

namespace cutwater {

/// The regions of fluid that a FluidMesh keeps, numbered from the largest one.
class KeptRegions {
 public:
  static constexpr std::uint32_t kNone = CutRegions::kNone;

  /// @throws Error(Argument) if FluidMeshOptions::within is not in one of them.
  template <std::floating_point T>
  KeptRegions(const CutLeaves& leaves, const OctreeCells<T>& mesh, const LeafGrid& grid,
              const FluidMeshOptions& options);

  /// The region of a piece, or of a leaf that is all fluid; kNone, if it is left out.
  [[nodiscard]] std::uint32_t ofPiece(std::uint32_t piece) const {
    return numberOf(regions_.ofPiece(piece));
  }
  [[nodiscard]] std::uint32_t ofLeaf(std::uint32_t leaf) const {
    return numberOf(regions_.ofLeaf(leaf));
  }
  [[nodiscard]] const std::vector<double>& volumes() const { return volumes_; }
  [[nodiscard]] double lostVolume() const { return lostVolume_; }
  [[nodiscard]] std::size_t lostCount() const { return lostCount_; }

 private:
  [[nodiscard]] std::uint32_t numberOf(std::uint32_t region) const {
    return region == kNone ? kNone : number_[region];
  }
  [[nodiscard]] std::uint32_t regionAt(const Vec3<double>& point, const CutLeaves& leaves,
                                       const LeafGrid& grid) const;

  CutRegions regions_;
  std::vector<std::uint32_t> number_;  // of each region
  std::vector<double> volumes_;
  double lostVolume_ = 0;
  std::size_t lostCount_ = 0;
};

}  // namespace cutwater
