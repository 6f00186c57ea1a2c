#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace cutwater::test {

using Powers = std::array<int, 3>;

/// In the order that CutCells::Moments states.
inline const std::vector<Powers> kOrder{
    {0, 0, 0},                                                                    //
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1},                                              //
    {2, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 2, 0}, {0, 1, 1}, {0, 0, 2},             //
    {3, 0, 0}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0}, {1, 1, 1}, {1, 0, 2}, {0, 3, 0},  //
    {0, 2, 1}, {0, 1, 2}, {0, 0, 3},                                              //
    {4, 0, 0}, {3, 1, 0}, {3, 0, 1}, {2, 2, 0}, {2, 1, 1}, {2, 0, 2}, {1, 3, 0},  //
    {1, 2, 1}, {1, 1, 2}, {1, 0, 3}, {0, 4, 0}, {0, 3, 1}, {0, 2, 2}, {0, 1, 3},  //
    {0, 0, 4}};

inline int degreeOf(const Powers& powers) {
  return powers[0] + powers[1] + powers[2];
}

inline double monomial(const Vec3<double>& p, const Powers& powers) {
  return std::pow(p.x, powers[0]) * std::pow(p.y, powers[1]) * std::pow(p.z, powers[2]);
}
inline double factorial(int n) {
  return n < 2 ? 1 : n * factorial(n - 1);
}

/// The integral of x^power from `lower` to `upper`.
inline double ofPower(int power, double lower, double upper) {
  return (std::pow(upper, power + 1) - std::pow(lower, power + 1)) / (power + 1);
}
/// Of a box, or of its face across an axis, on which all have this coordinate.
inline double ofBox(const Powers& powers, const Box<double>& box, int across = -1, double at = 0) {
  double result = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int power = powers[static_cast<std::size_t>(axis)];
    result *=
        axis == across ? std::pow(at, power) : ofPower(power, box.lower[axis], box.upper[axis]);
  }
  return result;
}

inline GridPatch<double> unitGrid(int n, double lower = 0, double upper = 1) {
  const double h = (upper - lower) / n;
  return {Level<double>({lower, lower, lower}, {h, h, h}), IndexBox::ofSize(n, n, n)};
}

inline CutCells cellsOf(const PolygonSoup& soup, const GridPatch<double>& grid,
                        FluidSide side = FluidSide::Inside, int degree = 4, bool polygons = true) {
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
      .cut(grid, {.polygons = polygons, .moments = degree});
}

inline PolygonSoup placedTorus() {
  auto soup = tessellation::torus(0.3, 0.1, 40, 20);
  RigidTransform<double> motion;
  motion.rotate(33.0, Vec3<double>{1, 2, 3});
  motion.translate({0.51, 0.49, 0.47});
  for (auto& p : soup.points) p = motion.toWorld(p);
  return soup;
}

inline std::vector<double> volumeAbout(const CutCells& cells, std::size_t piece,
                                       const Vec3<double>& to) {
  return shifted(cells.moments.ofVolume(piece), cells.pieces.centroid[piece], to);
}
inline std::vector<double> wallAbout(const CutCells& cells, std::size_t piece,
                                     const Vec3<double>& to) {
  return shifted(cells.moments.ofWall(piece), cells.pieces.wallCentroid[piece], to);
}
inline std::vector<Vec3<double>> wallVectorAbout(const CutCells& cells, std::size_t piece,
                                                 const Vec3<double>& to) {
  return shifted(cells.moments.ofWallVector(piece), cells.pieces.wallCentroid[piece], to);
}

}  // namespace cutwater::test
