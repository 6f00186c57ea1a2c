#pragma once

#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>

#include <map>
#include <span>
#include <vector>

namespace cutwater {

/// The stretches of edges as sides of rectangles: divided where baffles cross them, and without
/// what baffles cover. The same for the rectangles on both sides, as baffles reach an edge from
/// both, see TileSurface.
class SideStretches {
 public:
  /// Views the stretches.
  SideStretches(const TileSurface& surface, const EdgeStretches& stretches,
                const GridPlanes& planes);

  /// Of the edge along an axis, x or y, that begins at a node; in ascending order.
  [[nodiscard]] std::span<const EdgeStretch> of(int axis, const TilePlace& first) const;

 private:
  /// Of an edge.
  struct Baffles {
    std::vector<double> crossings;
    std::vector<Interval<double>> covers;
  };
  [[nodiscard]] static std::vector<EdgeStretch> divided(std::span<const EdgeStretch> stretches,
                                                        const Baffles& baffles);

  const EdgeStretches& stretches_;
  TileNumbers numbers_;
  std::map<std::uint32_t, std::vector<EdgeStretch>> divided_;  // by edge: those with baffles
};

}  // namespace cutwater
