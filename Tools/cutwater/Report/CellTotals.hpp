#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <optional>
#include <string>

namespace cutwater::tool {

/// A surface where it is placed, which all cells around it must give again.
struct PlacedSurface {
  /// That of a mesh; of another solid, triangles about it within a box, from a coarse grid.
  PlacedSurface(const Solid<double>& solid, const Box<double>& within,
                const CutterOptions& options = {});

  /// Cells of a size that it cuts: about as many as its sheets have faces of cells in their
  /// shadows.
  [[nodiscard]] double expectedCells(const Vec3<double>& size) const;

  Box<double> box;  ///< without baffles, as its measure
  SurfaceMeasure measure;
  bool boundsBody = true;  ///< whether its volume is the body's: no images, no caps
  bool isAllWall = true;   ///< and its area the walls', but for open patches: no baffles
  double openArea = 0;     ///< of open patches
  Vec3<double> projected;  ///< the areas of its shadows along the axes, all sheets counted
  std::size_t triangles = 0;

 private:
  void take(PolygonSoup soup, const CutterOptions& options);
};

/// What cut cells together give, beside what the surface says itself.
struct CellTotals {
  /// `all`: cells, those that are not cut among them, which fill the box.
  CellTotals(const CutCellsReport& report, std::size_t all, std::size_t allPieces,
             const Box<double>& filled, const PlacedSurface& placed, FluidSide side);
  /// Adds the errors that cells state: of the volume of all together, and the largest share of a
  /// cell or a face.
  void state(double volume, double largest);

  [[nodiscard]] std::string json(const std::string& input) const;
  /// Two lines for people.
  [[nodiscard]] std::string text() const;

  CutCellsReport found;
  std::size_t cells;
  std::size_t pieces;
  std::optional<double> volumeError;  ///< relative; nothing if the surface does not tell it
  std::optional<double> areaError;
  std::string whyUnknown;             ///< why it does not
  std::optional<double> statedError;  ///< of the volume of fluid or body, the smaller one, relative
  std::optional<double> largestError;
  double seconds = 0;
};

}  // namespace cutwater::tool
