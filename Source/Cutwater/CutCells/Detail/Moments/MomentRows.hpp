#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>

namespace cutwater {

/// The moments of an arc, or of the whole face below a cell for kNoRow, in its plane about a point.
[[nodiscard]] inline std::array<double, Monomials<2>::kCount> momentsOfFace(
    const CutCells& cells, std::uint32_t arc, const Index3& cell, int axis,
    const Vec3<double>& about) {
  if (arc == CutCells::kNoRow) {
    const auto box = cells.boxOf(cell);
    return momentsOfBox(alongFace(box.lower - about, axis), alongFace(box.upper - about, axis));
  }
  std::array<double, Monomials<2>::kCount> result{};
  std::ranges::copy(cells.moments.ofArc(arc), result.begin());
  shift(std::span(result), cells.moments.degree, alongFace(cells.arcs.centroid[arc] - about, axis));
  return result;
}

/// Rows of moments that are sums of others, for the pieces of a CutCells.
class MomentRows {
 public:
  /// Of pieces whose centroids are known.
  MomentRows(CutCells& cells, int degree) : cells_(cells), moments_(cells.moments) {
    moments_.degree = degree;
    moments_.volume.resize(cells.pieces.volume.size() * moments_.perPiece());
    moments_.wall.resize(moments_.volume.size());
    moments_.wallVector.resize(moments_.volume.size());
  }

  /// Those of a piece of other cells.
  void addPiece(std::size_t to, const CutCells& cells, std::size_t piece) {
    add(cells.moments.ofVolume(piece), cells.pieces.centroid[piece] - cells_.pieces.centroid[to],
        moments_.volume, to);
    const auto ofWall = cells.pieces.wallCentroid[piece] - cells_.pieces.wallCentroid[to];
    add(cells.moments.ofWall(piece), ofWall, moments_.wall, to);
    add(cells.moments.ofWallVector(piece), ofWall, moments_.wallVector, to);
  }
  /// Those of a box of fluid.
  void addBox(std::size_t to, const Box<double>& box) {
    const auto& centroid = cells_.pieces.centroid[to];
    const auto own = momentsOfBox(asArray(box.lower - centroid), asArray(box.upper - centroid));
    for (std::size_t i = 0; i < moments_.perPiece(); ++i) {
      moments_.volume[to * moments_.perPiece() + i] += own[i];
    }
  }
  /// Those of a part of a face, in the piece's wall: `ofFace` about the wall's centroid, at a
  /// distance from it. `sign`: of the normal's component out of the piece.
  void addClosedFace(std::size_t to, std::span<const double> ofFace, int axis, double distance,
                     int sign) {
    const auto own = inSpace(ofFace, moments_.degree, axis, distance);
    for (std::size_t i = 0; i < moments_.perPiece(); ++i) {
      const auto at = to * moments_.perPiece() + i;
      moments_.wall[at] += own[i];
      moments_.wallVector[at][axis] += sign * own[i];
    }
  }

 private:
  template <typename Value>
  void add(std::span<const Value> row, const Vec3<double>& by, std::vector<Value>& rows,
           std::size_t to) const {
    addShifted(row, moments_.degree, asArray(by),
               std::span(rows).subspan(to * row.size(), row.size()));
  }

  CutCells& cells_;
  CutCells::Moments& moments_;
};

}  // namespace cutwater
