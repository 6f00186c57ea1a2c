// The cells of surfaces from real files: what always holds, and the surface's own volume and area.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "Oracle/RealFiles.hpp"
#include "Support/CutPolygons.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

/// Those with up to so many bytes of text.
std::vector<std::filesystem::path> realFiles() {
  const auto most = static_cast<std::uintmax_t>(scaled(300'000));
  std::vector<std::filesystem::path> found;
  for (const char* folder : {CUTWATER_CGAL_MESHES, CUTWATER_OPENFOAM_EXAMPLES}) {
    for (const auto& file : surfacesIn(folder)) {
      const std::uintmax_t packing = file.extension() == ".gz" ? 5 : 1;
      if (packing * file_size(file) <= most) found.push_back(file);
    }
  }
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
void expectBothSides(const Solid<double>& solid, double cellsAlong, const CutterOptions& options) {
  const double width = widthOf(solid, cellsAlong);
  const auto grid = gridAround(solid, width);
  double sum = 0;
  std::array<double, 2> walls{};
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    const auto report = check(CellCutter(solid, side, options).cut(grid));
    EXPECT_EQ(report.outOfRange, 0U);
    EXPECT_EQ(report.lostPieces, 0U);
    EXPECT_LT(report.worstClosure, 1e-12);
    sum += report.fluidVolume;
    walls[side == FluidSide::Inside ? 1 : 0] = report.wallArea;
  }
  const auto cells = static_cast<double>(grid.indices.count());
  EXPECT_NEAR(sum, cells * width * width * width, 1e-10 * cells * width * width * width);
  // Caps may be thin, and cross the surface at angles as small.
  EXPECT_NEAR(walls[0], walls[1], (options.capHoles ? 1e-6 : 1e-9) * walls[0]);
}

/// Cells across the largest side; the finest in long runs.
std::span<const double> spacings() {
  static constexpr std::array<double, 4> kAll{3, 7, 23, 61};
  return std::span(kAll).first(scaled(1) > 1 ? 4 : 3);
}

enum class Kind { Empty, Flat, Open, Unorientable, Meeting, Sound };

/// All in one plane, but for rounding.
bool isFlat(const PolygonSoup& triangles) {
  const double near = 1e-6 * triangles.boundingBox().diagonal();
  Vec3<double> normal;
  for (std::size_t i = 0; i < triangles.polygonCount() && normal == Vec3<double>{}; ++i) {
    std::vector<Vec3<double>> corners;
    for (const auto corner : triangles.polygon(i)) corners.push_back(triangles.points[corner]);
    normal = polygonArea(corners).normal;
  }
  const auto& origin = triangles.points[triangles.corners[0]];
  return std::ranges::all_of(triangles.corners, [&](const auto corner) {
    return std::abs(dot(triangles.points[corner] - origin, normal)) <= near;
  });
}

Kind kindOf(const MeshSDF<double>& mesh) {
  const auto& signs = mesh.signReport();
  if (signs.unorientable > 0) return Kind::Unorientable;
  if (!signs.isClosed()) return isFlat(mesh.soup()) ? Kind::Flat : Kind::Open;
  return signs.isSound() ? Kind::Sound : Kind::Meeting;
}

/// As it is, and turned.
void expectCellsOf(const MeshSDF<double>& mesh, Kind kind) {
  const auto measured = sizeOfSurface(mesh.soup());
  Solid<double> solid(mesh);
  for (const double angle : {0.0, 40.0}) {
    solid.rotate(angle, Vec3<double>{1, 2, 3});
    for (const double cellsAlong : spacings()) {
      SCOPED_TRACE(cellsAlong);
      if (kind == Kind::Sound) {
        expectCells(solid, measured, cellsAlong);
      } else {
        expectBothSides(solid, cellsAlong, {.capHoles = kind != Kind::Meeting});
      }
    }
  }
}

/// Cuts a surface's cells, where it can be done.
Kind expectCellsOf(PolygonSoup soup) {
  weldExactly(soup);
  if (soup.polygonCount() == 0) return Kind::Empty;
  const MeshSDF<double> mesh(soup);
  const auto kind = kindOf(mesh);
  if (kind != Kind::Sound && kind != Kind::Meeting) {
    EXPECT_THROW(CellCutter{Solid<double>(mesh)}, Error);
  }
  if (kind == Kind::Unorientable) {
    EXPECT_THROW(CellCutter(Solid<double>(mesh), FluidSide::Outside, {.capHoles = true}), Error);
    return kind;
  }
  try {
    expectCellsOf(mesh, kind);
  } catch (const Error& error) {
    // Caps may be the same triangles, the other way round.
    EXPECT_EQ(kind, Kind::Flat) << error.what();
    EXPECT_STREQ(error.what(), "cut cells: the surface bounds nothing");
  }
  return kind;
}

TEST(CutMeshesTest, TheirCellsCloseAndMakeTheWhole) {
  std::map<Kind, int> seen;
  for (const auto& file : realFiles()) {
    SCOPED_TRACE(file.string());
    if (isNoSurface(file)) continue;
    try {
      ++seen[expectCellsOf(readSurface(file).soup)];
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GT(seen[Kind::Sound], 40);
  EXPECT_GE(seen[Kind::Meeting], 3);
  EXPECT_GT(seen[Kind::Open], 20);
}

}  // namespace
}  // namespace cutwater::test
