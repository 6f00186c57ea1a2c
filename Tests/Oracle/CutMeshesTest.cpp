// The cells of surfaces from real files: what always holds, and the surface's own volume and area.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Files of up to this size.
std::vector<std::filesystem::path> smallFiles() {
  const auto most = static_cast<std::uintmax_t>(scaled(300'000));
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(CUTWATER_CGAL_MESHES)) {
    if (entry.file_size() <= most) found.push_back(entry.path());
  }
  std::ranges::sort(found);
  return found;
}

struct SurfaceSize {
  double volume = 0;
  double area = 0;
};

SurfaceSize sizeOfSurface(const PolygonSoup& triangles) {
  SurfaceSize result;
  const auto& origin = triangles.points[triangles.corners[0]];
  for (std::size_t i = 0; i < triangles.polygonCount(); ++i) {
    const auto corners = triangles.polygon(i);
    const auto a = triangles.points[corners[0]] - origin;
    const auto b = triangles.points[corners[1]] - origin;
    const auto c = triangles.points[corners[2]] - origin;
    result.volume += dot(a, cross(b, c)) / 6;
    result.area += length(cross(b - a, c - a)) / 2;
  }
  return result;
}

GridPatch<double> gridAround(const Solid<double>& solid, double width) {
  const auto box = solid.boundingBox();
  const auto size = box.upper - box.lower;
  const auto along = [&](double side) { return static_cast<std::int32_t>(side / width) + 3; };
  const Level<double> level(box.lower - Vec3<double>{width, width, width}, {width, width, width});
  return {level, IndexBox::ofSize(along(size.x), along(size.y), along(size.z))};
}

double widthOf(const Solid<double>& solid, double cellsAlong) {
  return maxComponent(solid.boundingBox().size()) / cellsAlong;
}

void expectCells(const Solid<double>& solid, const SurfaceSize& measured, double cellsAlong) {
  const double width = widthOf(solid, cellsAlong);
  const auto cells = CellCutter(solid).cut(gridAround(solid, width), {.polygons = true});
  const auto report = check(cells);
  EXPECT_EQ(report.outOfRange, 0U);
  EXPECT_EQ(report.lostPieces, 0U);
  EXPECT_LT(report.worstClosure, 1e-13);
  EXPECT_NEAR(report.bodyVolume, measured.volume,
              1e-12 * (measured.volume + measured.area * width));
  EXPECT_NEAR(report.wallArea, measured.area, 1e-11 * measured.area);
  expectPolygonsOf(cells);
}

/// Of a surface that meets itself, the fluid on both sides fills its box, and pieces close.
void expectBothSides(const Solid<double>& solid, double cellsAlong) {
  const double width = widthOf(solid, cellsAlong);
  const auto grid = gridAround(solid, width);
  double sum = 0;
  std::array<double, 2> walls{};
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto report = check(CellCutter(solid, side).cut(grid));
    EXPECT_EQ(report.outOfRange, 0U);
    EXPECT_EQ(report.lostPieces, 0U);
    EXPECT_LT(report.worstClosure, 1e-12);
    sum += report.fluidVolume;
    walls[side == FluidSide::Inside ? 1 : 0] = report.wallArea;
  }
  const auto cells = static_cast<double>(grid.indices.count());
  EXPECT_NEAR(sum, cells * width * width * width, 1e-10 * cells * width * width * width);
  EXPECT_NEAR(walls[0], walls[1], 1e-9 * walls[0]);
}

TEST(CutMeshesTest, TheirCellsCloseAndMakeTheWhole) {
  int sound = 0;
  int meeting = 0;
  for (const auto& file : smallFiles()) {
    SCOPED_TRACE(file.filename().string());
    PolygonSoup soup;
    try {
      soup = readSurface(file).soup;
    } catch (const Error&) {
      continue;  // some are damaged
    }
    weldExactly(soup);
    if (soup.polygonCount() == 0) continue;
    const MeshSDF<double> mesh(soup);
    const auto& signs = mesh.signReport();
    if (!signs.isClosed() || signs.unorientable > 0) {
      EXPECT_THROW(CellCutter{Solid<double>(mesh)}, Error);
      continue;
    }
    if (!signs.isSound()) {
      ++meeting;
      for (const double cellsAlong : {3.0, 23.0}) expectBothSides(Solid<double>(mesh), cellsAlong);
      continue;
    }
    ++sound;
    const auto measured = sizeOfSurface(mesh.soup());
    Solid<double> solid(mesh);
    for (const double cellsAlong : {7.0, 23.0}) expectCells(solid, measured, cellsAlong);
    solid.rotate(40, Vec3<double>{1, 2, 3});
    for (const double cellsAlong : {7.0, 23.0}) expectCells(solid, measured, cellsAlong);
  }
  EXPECT_GT(sound, 40);
  EXPECT_GE(meeting, 3);
}

}  // namespace
}  // namespace cutwater::test
