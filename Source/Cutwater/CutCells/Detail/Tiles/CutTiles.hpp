#pragma once

#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileNumbers.hpp>

#include <vector>

namespace cutwater {

/// A box of up to kTileWidth^3 cells, and what is needed to cut them.
struct TileInput {
  GridPlanes planes;
  std::span<const std::uint32_t> triangles;  ///< ascending: all that meet wanted cells
  int winding = 0;                           ///< that of the node of lowest indices
  /// Those of all nodes; or none, if all triangles are there that meet the box.
  std::span<const std::int32_t> windings = {};
  const CellMask* wanted = nullptr;  ///< others are left out; null: none is
};

/// Boxes of up to kWidth^3 cells that together are a grid, and the triangles that meet each of
/// them.
class CutTiles {
 public:
  static constexpr int kWidth = kTileWidth;

  /// Without triangles. Views the planes.
  explicit CutTiles(const GridPlanes& planes);
  /// Views both.
  CutTiles(const CutSurface& surface, const GridPlanes& planes);

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  [[nodiscard]] const TilePlace& sizes() const { return sizes_; }
  /// In ascending order.
  [[nodiscard]] std::span<const std::uint32_t> triangles(std::size_t tile) const {
    return std::span(triangles_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
  }
  [[nodiscard]] TilePlace placeOf(std::size_t tile) const;
  [[nodiscard]] std::size_t tileAt(const TilePlace& place) const {
    const auto n = [](int i) { return static_cast<std::size_t>(i); };
    return (n(place[2]) * n(sizes_[1]) + n(place[1])) * n(sizes_[0]) + n(place[0]);
  }
  /// The cell of lowest indices.
  [[nodiscard]] TilePlace firstCell(std::size_t tile) const;
  [[nodiscard]] GridPlanes planesOf(std::size_t tile) const;
  /// The winding number of the node of lowest indices.
  [[nodiscard]] int winding(std::size_t tile) const { return windings_[tile]; }
  [[nodiscard]] TileInput input(std::size_t tile) const {
    return {.planes = planesOf(tile), .triangles = triangles(tile), .winding = winding(tile)};
  }

 private:
  void sortTriangles(const CutSurface& surface, std::span<const std::uint32_t> triangles);
  void findWindings(const CutSurface& surface, std::span<const std::uint32_t> triangles);

  const GridPlanes& planes_;
  TilePlace sizes_;
  std::vector<std::uint64_t> first_;
  std::vector<std::uint32_t> triangles_;
  std::vector<std::int32_t> windings_;
};

}  // namespace cutwater
