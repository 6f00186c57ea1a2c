#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace cutwater {

/// Indices of a cell, a face, an edge or a node in a box of cells; a face or an edge has those of
/// the node where it begins.
using TilePlace = std::array<std::int32_t, 3>;

/// The most cells that a tile has along each axis: a power of two.
inline constexpr int kTileBits = 3;
inline constexpr int kTileWidth = 1 << kTileBits;

/// Some of the cells of a tile, by number.
using CellMask = std::bitset<std::size_t{kTileWidth} * kTileWidth * kTileWidth>;

/// Whether a cell is wanted: null for all.
inline bool isWanted(const CellMask* wanted, std::uint32_t cell) {
  return wanted == nullptr || (*wanted)[cell];
}

/// Numbers of the cells, faces, edges and nodes of a box of cells. Faces and edges are numbered
/// axis by axis: faces by the axis that they are across, edges by the one along which they run.
class TileNumbers {
 public:
  explicit TileNumbers(const TilePlace& cells) : cells_(cells) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      TilePlace faces = cells;
      ++faces[a];
      TilePlace edges{cells[0] + 1, cells[1] + 1, cells[2] + 1};
      --edges[a];
      faceSizes_[a] = faces;
      edgeSizes_[a] = edges;
      firstFace_[a + 1] = firstFace_[a] + product(faces);
      firstEdge_[a + 1] = firstEdge_[a] + product(edges);
    }
  }

  [[nodiscard]] const TilePlace& cells() const { return cells_; }
  [[nodiscard]] std::uint32_t cellCount() const { return product(cells_); }
  [[nodiscard]] std::uint32_t faceCount() const { return firstFace_[3]; }
  [[nodiscard]] std::uint32_t edgeCount() const { return firstEdge_[3]; }
  [[nodiscard]] std::uint32_t nodeCount() const {
    return product({cells_[0] + 1, cells_[1] + 1, cells_[2] + 1});
  }

  [[nodiscard]] std::uint32_t cell(const TilePlace& p) const { return number(p, cells_); }
  /// The face below the cell at this place.
  [[nodiscard]] std::uint32_t face(int axis, const TilePlace& p) const {
    const auto a = static_cast<std::size_t>(axis);
    return firstFace_[a] + number(p, faceSizes_[a]);
  }
  /// The edge that begins at the node of this place.
  [[nodiscard]] std::uint32_t edge(int axis, const TilePlace& p) const {
    const auto a = static_cast<std::size_t>(axis);
    return firstEdge_[a] + number(p, edgeSizes_[a]);
  }
  [[nodiscard]] std::uint32_t node(const TilePlace& p) const {
    return number(p, {cells_[0] + 1, cells_[1] + 1, cells_[2] + 1});
  }

  [[nodiscard]] TilePlace placeOfCell(std::uint32_t number) const { return place(number, cells_); }
  [[nodiscard]] int axisOfFace(std::uint32_t face) const { return axisOf(face, firstFace_); }
  [[nodiscard]] int axisOfEdge(std::uint32_t edge) const { return axisOf(edge, firstEdge_); }
  [[nodiscard]] TilePlace placeOfEdge(std::uint32_t edge) const {
    const auto a = static_cast<std::size_t>(axisOfEdge(edge));
    return place(edge - firstEdge_[a], edgeSizes_[a]);
  }
  [[nodiscard]] TilePlace placeOfFace(std::uint32_t face) const {
    const auto a = static_cast<std::size_t>(axisOfFace(face));
    return place(face - firstFace_[a], faceSizes_[a]);
  }
  /// Whether one of the cells on both sides of a face is wanted.
  [[nodiscard]] bool isBeside(std::uint32_t face, const CellMask* wanted) const {
    if (wanted == nullptr) return true;
    const auto a = static_cast<std::size_t>(axisOfFace(face));
    auto place = placeOfFace(face);
    if (place[a] < cells_[a] && (*wanted)[cell(place)]) return true;
    return --place[a] >= 0 && (*wanted)[cell(place)];
  }

 private:
  static std::uint32_t product(const TilePlace& sizes) {
    return static_cast<std::uint32_t>(sizes[0]) * static_cast<std::uint32_t>(sizes[1]) *
           static_cast<std::uint32_t>(sizes[2]);
  }
  static std::uint32_t number(const TilePlace& p, const TilePlace& sizes) {
    return static_cast<std::uint32_t>((p[2] * sizes[1] + p[1]) * sizes[0] + p[0]);
  }
  static TilePlace place(std::uint32_t number, const TilePlace& sizes) {
    const auto n = static_cast<std::int32_t>(number);
    return {n % sizes[0], n / sizes[0] % sizes[1], n / sizes[0] / sizes[1]};
  }
  static int axisOf(std::uint32_t number, const std::array<std::uint32_t, 4>& first) {
    return number >= first[2] ? 2 : number >= first[1] ? 1 : 0;
  }

  TilePlace cells_;
  std::array<TilePlace, 3> faceSizes_;
  std::array<TilePlace, 3> edgeSizes_;
  std::array<std::uint32_t, 4> firstFace_{};
  std::array<std::uint32_t, 4> firstEdge_{};
};

}  // namespace cutwater
