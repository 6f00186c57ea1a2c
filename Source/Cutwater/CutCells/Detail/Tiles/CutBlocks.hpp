#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Tiles/CutTiles.hpp>

#include <deque>

namespace cutwater {

/// The tiles of a grid. Along axes with a period, cells are cut in the same place wherever they
/// are, whole periods away from it: so a grid may be several boxes of tiles, each with a shift.
class CutBlocks {
 public:
  /// Cells next to each other along an axis that are cut in the same place: the planes there, in
  /// the surface's frame, and how far away from them the cells are, in the world.
  struct Stretch {
    int first = 0;  ///< the lowest cell, counted in the grid
    std::vector<double> positions;
    double shift = 0;

    [[nodiscard]] int cells() const { return static_cast<int>(positions.size()) - 1; }
  };
  using Stretches = std::array<std::vector<Stretch>, 3>;

  /// Without triangles, and with the period of these stretches.
  explicit CutBlocks(Stretches stretches, const CutPeriod& period = {});
  /// Views the surface, whose period they have.
  CutBlocks(const CutSurface& surface, Stretches stretches);
  CutBlocks(const CutBlocks&) = delete;
  CutBlocks& operator=(const CutBlocks&) = delete;
  ~CutBlocks() = default;

  [[nodiscard]] std::size_t count() const { return last().firstTile + last().tiles.count(); }
  [[nodiscard]] std::span<const std::uint32_t> triangles(std::size_t tile) const {
    return of(tile).tiles.triangles(tile - of(tile).firstTile);
  }
  [[nodiscard]] TileInput input(std::size_t tile) const {
    return of(tile).tiles.input(tile - of(tile).firstTile);
  }
  [[nodiscard]] GridPlanes planesOf(std::size_t tile) const {
    return of(tile).tiles.planesOf(tile - of(tile).firstTile);
  }
  /// The winding number of the node of lowest indices.
  [[nodiscard]] int winding(std::size_t tile) const {
    return of(tile).tiles.winding(tile - of(tile).firstTile);
  }
  /// The cell of lowest indices, counted in the grid.
  [[nodiscard]] TilePlace firstCell(std::size_t tile) const;
  /// From where a tile is cut to where it is, in the world.
  [[nodiscard]] const Vec3<double>& shiftOf(std::size_t tile) const { return of(tile).shift; }

  /// Tiles next to each other along the x axis, whose numbers ascend by one.
  struct Row {
    std::size_t tile = 0;  ///< the first of them
    TilePlace within;      ///< a cell in it
    int end = 0;           ///< the first cell along x behind the last of them, counted in the grid
  };
  /// From the tile that holds a cell.
  [[nodiscard]] Row rowFrom(const TilePlace& cell) const;

 private:
  struct Block {
    Block(const GridPlanes& between, const CutSurface* surface)
        : planes(between),
          tiles(surface != nullptr ? CutTiles(*surface, planes) : CutTiles(planes)) {}

    GridPlanes planes;
    CutTiles tiles;
    TilePlace first{};
    Vec3<double> shift;
    std::size_t firstTile = 0;
  };
  void addBlocks(const CutPeriod& period, const CutFrame& frame, const CutSurface* surface);
  [[nodiscard]] const Block& last() const { return blocks_.back(); }
  [[nodiscard]] const Block& of(std::size_t tile) const;

  Stretches stretches_;
  std::deque<Block> blocks_;  // x fastest
};

}  // namespace cutwater
