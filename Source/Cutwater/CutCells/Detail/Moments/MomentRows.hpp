#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>

namespace cutwater {

/// The moments of an arc of cells or leaves in its plane, about a point; for kNoRow, of the whole
/// face of this box across the axis.
template <typename Cut>
[[nodiscard]] std::array<double, Monomials<2>::kCount> momentsOfFace(const Cut& cut,
                                                                     std::uint32_t arc,
                                                                     const Box<double>& box,
                                                                     int axis,
                                                                     const Vec3<double>& about) {
  if (arc == CutCells::kNoRow) {
    return momentsOfBox(alongFace(box.lower - about, axis), alongFace(box.upper - about, axis));
  }
  std::array<double, Monomials<2>::kCount> result{};
  std::ranges::copy(cut.moments.ofArc(arc), result.begin());
  shift(std::span(result), cut.moments.degree, alongFace(cut.arcs.centroid[arc] - about, axis));
  return result;
}

/// Rows of moments that are sums of others, for the pieces of cells or leaves.
class MomentRows {
 public:
  /// Of pieces whose centroids are known, to the degree of `moments`.
  MomentRows(const CutCells::Pieces& pieces, CutCells::Moments& moments)
      : pieces_(pieces), moments_(moments) {
    moments_.volume.resize(pieces.volume.size() * moments_.perPiece());
    moments_.wall.resize(moments_.volume.size());
    moments_.wallVector.resize(moments_.volume.size());
  }

  /// Those of a piece of other cells.
  void addPiece(std::size_t to, const CutCells::Pieces& pieces, const CutCells::Moments& moments,
                std::size_t piece) {
    add(moments.ofVolume(piece), pieces.centroid[piece] - pieces_.centroid[to], moments_.volume,
        to);
    const auto ofWall = pieces.wallCentroid[piece] - pieces_.wallCentroid[to];
    add(moments.ofWall(piece), ofWall, moments_.wall, to);
    add(moments.ofWallVector(piece), ofWall, moments_.wallVector, to);
  }
  /// Those of a box of fluid.
  void addBox(std::size_t to, const Box<double>& box) {
    const auto& centroid = pieces_.centroid[to];
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

  const CutCells::Pieces& pieces_;
  CutCells::Moments& moments_;
};

}  // namespace cutwater
