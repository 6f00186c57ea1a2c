#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "Support/VoxelSolid.hpp"

namespace cutwater::test {

/// A cube of n^3 cells, cut by a surface, fluid outside.
struct CutTile {
  CutTile(const IndexedTriangles& surface, double lower, double upper, int n)
      : positions(planesBetween(lower, upper, n)),
        planes{{positions, positions, positions}},
        moved(surface.positions, surface.triangles),
        patches(surface.triangles.size()),
        tile(moved, patches, allOf(moved.triangleCount()), planes),
        stretches(tile, planes, windingAt({lower, lower, lower})),
        faces(tile, stretches, planes),
        result(findCellPieces(tile, stretches, faces, planes)) {}
  CutTile(const CutTile&) = delete;
  CutTile& operator=(const CutTile&) = delete;
  ~CutTile() = default;

  [[nodiscard]] double width() const { return positions[1] - positions[0]; }

  /// The volumes of the pieces of each cell; of cells that are not cut: all, or nothing.
  [[nodiscard]] std::vector<std::vector<double>> volumes() const {
    std::vector<std::vector<double>> found(tile.numbers().cellCount());
    std::vector<char> isCut(found.size());
    for (const auto& fragment : tile.fragments()) isCut[fragment.cell] = 1;
    for (const auto& piece : result.pieces) found[piece.cell].push_back(piece.volume);
    for (std::uint32_t cell = 0; cell < found.size(); ++cell) {
      const auto place = tile.numbers().placeOfCell(cell);
      if (isCut[cell] == 0 && stretches.isFluid(place)) found[cell] = {volumeOf(place)};
    }
    return found;
  }
  [[nodiscard]] double fluidVolume() const {
    double sum = 0;
    for (const auto& cell : volumes()) sum = std::accumulate(cell.begin(), cell.end(), sum);
    return sum;
  }
  [[nodiscard]] double wallArea() const {
    double sum = 0;
    for (const auto& piece : result.pieces) sum += piece.area;
    return sum;
  }
  /// The largest sum of apertures and wall of a piece, in faces: 0 but for rounding.
  [[nodiscard]] double worstClosure() const {
    std::vector<Vec3<double>> sums(result.pieces.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = result.pieces[i].areaVector;
    for (const auto& arc : result.arcs) {
      const int axis = tile.numbers().axisOfFace(arc.face);
      if (arc.below != kNone) sums[arc.below][axis] += arc.area;
      if (arc.above != kNone) sums[arc.above][axis] -= arc.area;
    }
    double worst = 0;
    for (const auto& sum : sums) worst = std::max(worst, length(sum) / (width() * width()));
    return worst;
  }

  std::vector<double> positions;
  GridPlanes planes;
  MovedSurface moved;
  std::vector<std::uint32_t> patches;
  TileSurface tile;
  EdgeStretches stretches;
  FacePieces faces;
  CellPieces result;

 private:
  static std::vector<double> planesBetween(double lower, double upper, int n) {
    std::vector<double> planes;
    for (int i = 0; i <= n; ++i) planes.push_back(lower + (upper - lower) * i / n);
    return planes;
  }
  static std::vector<std::uint32_t> allOf(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
  }
  /// How often the moved surface winds around a node.
  [[nodiscard]] int windingAt(const Vec3<double>& node) const {
    int winding = 0;
    for (std::uint32_t id = 0; id < moved.triangleCount(); ++id) {
      winding += riseBelowNode(moved.triangle(id), node, 2);
    }
    return winding;
  }
  [[nodiscard]] double volumeOf(const TilePlace& place) const {
    double volume = 1;
    for (const auto i : place) {
      volume *= positions[static_cast<std::size_t>(i) + 1] - positions[static_cast<std::size_t>(i)];
    }
    return volume;
  }
};

}  // namespace cutwater::test
