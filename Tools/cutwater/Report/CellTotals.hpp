#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <optional>
#include <span>
#include <string>

namespace cutwater::tool {

/// A surface where it is placed, which all cells around it must give again.
struct PlacedSurface {
  /// `openPatches`: the names of those that are no walls.
  explicit PlacedSurface(const MeshSDF<double>& mesh,
                         std::span<const std::string> openPatches = {});

  /// Cells of a size that it cuts: about as many as its sheets have faces of cells in their
  /// shadows.
  [[nodiscard]] double expectedCells(const Vec3<double>& size) const;

  Box<double> box;
  SurfaceMeasure measure;
  double openArea = 0;     ///< of open patches
  Vec3<double> projected;  ///< the areas of its shadows along the axes, all sheets counted
  std::size_t triangles = 0;
};

/// What cut cells together give, beside what the surface says itself.
struct CellTotals {
  /// `all`: cells, those that are not cut among them, which fill the box.
  CellTotals(const CutCellsReport& report, std::size_t all, std::size_t allPieces,
             const Box<double>& filled, const PlacedSurface& placed, FluidSide side);

  [[nodiscard]] std::string json(const std::string& input) const;
  /// Two lines for people.
  [[nodiscard]] std::string text() const;

  CutCellsReport found;
  std::size_t cells;
  std::size_t pieces;
  std::optional<double> volumeError;  ///< relative; nothing if part of the surface is elsewhere
  std::optional<double> areaError;
  double seconds = 0;
};

}  // namespace cutwater::tool
