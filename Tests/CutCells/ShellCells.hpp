#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <gtest/gtest.h>

#include "Support/CutIdentities.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Shells.hpp"

namespace cutwater::test {

inline Solid<double> solidOf(const PolygonSoup& soup) {
  return Solid<double>(MeshSDF<double>(soup));
}

inline CutCells cellsOfShells(const PolygonSoup& soup, int n, FluidSide side = FluidSide::Outside,
                              const CutOptions& options = {}) {
  return CellCutter(solidOf(soup), side)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, {1.0 / n, 1.0 / n, 1.0 / n}),
                             IndexBox::ofSize(n, n, n)},
           options);
}

inline void expectClosed(const CutCells& cells) {
  expectIdentities(cells, 1e-13);
}

inline PolygonSoup ball(double radius, const Vec3<double>& center, int level = 3) {
  return moved(tessellation::icosphere(radius, level), center);
}
inline constexpr Vec3<double> kMiddle{0.51, 0.49, 0.47};

}  // namespace cutwater::test
