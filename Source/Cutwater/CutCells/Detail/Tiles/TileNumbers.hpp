#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace cutwater {

/// Indices of a cell, a face, an edge or a node in a box of cells; a face or an edge has those of
/// the node where it begins.
using TilePlace = std::array<std::int32_t, 3>;

/// Calls visit(place) for places below these along each axis, x first.
template <typename Visit>
void forTilePlaces(const TilePlace& sizes, Visit&& visit) {
  for (std::int32_t k = 0; k < sizes[2]; ++k) {
    for (std::int32_t j = 0; j < sizes[1]; ++j) {
      for (std::int32_t i = 0; i < sizes[0]; ++i) visit(TilePlace{i, j, k});
    }
  }
}

/// The most cells that a tile has along each axis: a power of two.
inline constexpr int kTileBits = 3;
inline constexpr int kTileWidth = 1 << kTileBits;

/// Some of the cells of a tile, by number.
using CellMask = std::bitset<std::size_t{kTileWidth} * kTileWidth * kTileWidth>;

/// Whether a cell is wanted: null for all.
inline bool isWanted(const CellMask* wanted, std::uint32_t cell) {
  return wanted == nullptr || (*wanted)[cell];
}

/// Numbers the places below some sizes, x first.
class TileSizes {
 public:
  TileSizes() = default;
  explicit TileSizes(const TilePlace& sizes) : sizes_(sizes) {
    for (std::size_t a = 0; a < 2; ++a) {
      reciprocals_[a] = kOne / static_cast<std::uint64_t>(std::max(1, sizes[a])) + 1;
    }
  }

  [[nodiscard]] const TilePlace& sizes() const { return sizes_; }
  [[nodiscard]] std::uint32_t count() const {
    return static_cast<std::uint32_t>(sizes_[0]) * static_cast<std::uint32_t>(sizes_[1]) *
           static_cast<std::uint32_t>(sizes_[2]);
  }
  [[nodiscard]] std::uint32_t number(const TilePlace& p) const {
    return static_cast<std::uint32_t>((p[2] * sizes_[1] + p[1]) * sizes_[0] + p[0]);
  }
  [[nodiscard]] TilePlace place(std::uint32_t number) const {
    const auto row = quotient(number, 0);
    const auto layer = quotient(row, 1);
    const auto n = [](std::uint32_t i) { return static_cast<std::int32_t>(i); };
    return {n(number) - n(row) * sizes_[0], n(row) - n(layer) * sizes_[1], n(layer)};
  }

 private:
  static constexpr std::uint64_t kOne = std::uint64_t{1} << 32U;

  /// By multiplication, which is exact as long as the number times the divisor is below 2^32:
  /// Granlund and Montgomery, Division by invariant integers using multiplication, PLDI 1994.
  [[nodiscard]] std::uint32_t quotient(std::uint32_t number, std::size_t axis) const {
    return static_cast<std::uint32_t>(number * reciprocals_[axis] >> 32U);
  }

  TilePlace sizes_{};
  std::array<std::uint64_t, 2> reciprocals_{};
};

/// Numbers of the cells, faces, edges and nodes of a box of cells. Faces and edges are numbered
/// axis by axis: faces by the axis that they are across, edges by the one along which they run.
class TileNumbers {
 public:
  explicit TileNumbers(const TilePlace& cells)
      : cells_(cells), nodes_({cells[0] + 1, cells[1] + 1, cells[2] + 1}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      TilePlace faces = cells;
      ++faces[axis];
      TilePlace edges = nodes_.sizes();
      --edges[axis];
      faces_[axis] = TileSizes(faces);
      edges_[axis] = TileSizes(edges);
      firstFace_[axis + 1] = firstFace_[axis] + faces_[axis].count();
      firstEdge_[axis + 1] = firstEdge_[axis] + edges_[axis].count();
    }
  }

  [[nodiscard]] const TilePlace& cells() const { return cells_.sizes(); }
  [[nodiscard]] std::uint32_t cellCount() const { return cells_.count(); }
  [[nodiscard]] std::uint32_t faceCount() const { return firstFace_[3]; }
  [[nodiscard]] std::uint32_t edgeCount() const { return firstEdge_[3]; }
  [[nodiscard]] std::uint32_t nodeCount() const { return nodes_.count(); }

  [[nodiscard]] std::uint32_t cell(const TilePlace& p) const { return cells_.number(p); }
  /// The face below the cell at this place.
  [[nodiscard]] std::uint32_t face(int axis, const TilePlace& p) const {
    const auto a = static_cast<std::size_t>(axis);
    return firstFace_[a] + faces_[a].number(p);
  }
  /// The edge that begins at the node of this place.
  [[nodiscard]] std::uint32_t edge(int axis, const TilePlace& p) const {
    const auto a = static_cast<std::size_t>(axis);
    return firstEdge_[a] + edges_[a].number(p);
  }
  [[nodiscard]] std::uint32_t node(const TilePlace& p) const { return nodes_.number(p); }

  [[nodiscard]] TilePlace placeOfCell(std::uint32_t number) const { return cells_.place(number); }
  [[nodiscard]] int axisOfFace(std::uint32_t face) const { return axisOf(face, firstFace_); }
  [[nodiscard]] int axisOfEdge(std::uint32_t edge) const { return axisOf(edge, firstEdge_); }
  [[nodiscard]] TilePlace placeOfEdge(std::uint32_t edge) const {
    const auto a = static_cast<std::size_t>(axisOfEdge(edge));
    return edges_[a].place(edge - firstEdge_[a]);
  }
  [[nodiscard]] TilePlace placeOfFace(std::uint32_t face) const {
    const auto a = static_cast<std::size_t>(axisOfFace(face));
    return faces_[a].place(face - firstFace_[a]);
  }
  /// Whether one of the cells on both sides of a face is wanted.
  [[nodiscard]] bool isBeside(std::uint32_t face, const CellMask* wanted) const {
    if (wanted == nullptr) return true;
    const auto a = static_cast<std::size_t>(axisOfFace(face));
    auto place = placeOfFace(face);
    if (place[a] < cells()[a] && (*wanted)[cell(place)]) return true;
    return --place[a] >= 0 && (*wanted)[cell(place)];
  }

 private:
  static int axisOf(std::uint32_t number, const std::array<std::uint32_t, 4>& first) {
    return number >= first[2] ? 2 : number >= first[1] ? 1 : 0;
  }

  TileSizes cells_;
  TileSizes nodes_;
  std::array<TileSizes, 3> faces_;
  std::array<TileSizes, 3> edges_;
  std::array<std::uint32_t, 4> firstFace_{};
  std::array<std::uint32_t, 4> firstEdge_{};
};

}  // namespace cutwater
