// Private: what all cutters ask of their arguments.
#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>

#include <cmath>

namespace cutwater {

inline void checkOptions(const CutOptions& options) {
  require(options.moments >= -1 && options.moments <= CutCells::Moments::kHighest,
          "cut cells: need a degree of moments from 0 to 4, or -1",
          Named{"moments", options.moments});
  require(options.quadratureDegree >= 0 && options.quadratureDegree <= CutCells::Moments::kHighest,
          "cut cells: need a degree of quadrature from 0 to 4",
          Named{"quadratureDegree", options.quadratureDegree});
}

inline void refuseInPlane(const CutOptions& options) {
  require(options.moments < 0 && !options.quadrature && !options.polygons,
          "cut cells: there are no polygons, no moments and no quadrature in a plane");
}

inline void checkPlanes(const CellPlanes& grid) {
  for (const auto& planes : grid.planes) {
    require(planes.size() >= 4,
            "cut cells: need two planes across each axis, and one on each side");
    for (std::size_t i = 0; i < planes.size(); ++i) {
      require(std::isfinite(planes[i]) && (i == 0 || planes[i] > planes[i - 1]),
              "cut cells: need planes that ascend", Named{"plane", planes[i]});
    }
  }
}

inline void refusePeriod(const CutPeriod& period, const char* message) {
  require(!period.isOnAny(), message, Named{"period", period.length});
}

/// The layer of cells that stands for the rectangles of a grid in the plane at `z`.
inline CellPlanes layerAt(const CellPlanes& grid, double z) {
  auto layer = grid;
  layer.planes[2] = {z - 1.5, z - 0.5, z + 0.5, z + 1.5};
  checkPlanes(layer);
  return layer;
}

}  // namespace cutwater
