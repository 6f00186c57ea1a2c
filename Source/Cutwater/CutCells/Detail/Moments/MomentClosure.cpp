#include <Cutwater/CutCells/Detail/Moments/MomentClosure.hpp>
#include <Cutwater/CutCells/Detail/Moments/Monomials.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cutwater {

namespace {

/// Adds up, for each piece, each axis d and each monomial m of offsets from the piece's centroid,
///
///     integral of m n_d over the wall and the open faces - integral of dm / dx_d over the volume
///
/// with n out of the fluid.
template <typename Cut>
class MomentClosure {
 public:
  explicit MomentClosure(const Cut& cells)
      : cells_(cells),
        moments_(cells.moments),
        count_(moments_.perPiece()),
        sums_(pieceCount(cells) * count_) {}

  double worst() {
    for (std::size_t piece = 0; piece < pieceCount(cells_); ++piece) addWallAndVolume(piece);
    for (std::size_t arc = 0; arc < cells_.arcs.area.size(); ++arc) {
      if (cells_.arcs.below[arc] < pieceCount(cells_)) addArc(arc, cells_.arcs.below[arc], 1);
      if (cells_.arcs.above[arc] < pieceCount(cells_)) addArc(arc, cells_.arcs.above[arc], -1);
    }
    for (std::size_t piece = 0; piece < pieceCount(cells_); ++piece) take(piece);
    return worst_;
  }

 private:
  void addWallAndVolume(std::size_t piece) {
    const auto wall = shifted(moments_.ofWallVector(piece), cells_.pieces.wallCentroid[piece],
                              cells_.pieces.centroid[piece]);
    std::ranges::copy(wall, sums_.begin() + static_cast<std::ptrdiff_t>(piece * count_));
    const auto volume = moments_.ofVolume(piece);
    for (std::size_t i = 0; i < Monomials<3>::count(moments_.degree - 1); ++i) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& monomial = kMonomials<3>[i];
        sums_[piece * count_ + monomial.raised[axis]][static_cast<int>(axis)] -=
            (monomial.powers[axis] + 1) * volume[i];
      }
    }
  }
  void addArc(std::size_t arc, std::uint32_t piece, int sign) {
    const auto& arcs = cells_.arcs;
    const int axis = arcs.axis[arc];
    const auto& centroid = cells_.pieces.centroid[piece];
    const auto inPlane = shifted(moments_.ofArc(arc), axis, arcs.centroid[arc], centroid);
    const double distance = planeOf(piece, axis, sign) - centroid[axis];
    const auto moments = inSpace(inPlane, moments_.degree, axis, distance);
    for (std::size_t i = 0; i < count_; ++i) sums_[piece * count_ + i][axis] += sign * moments[i];
    note(moments[0] - arcs.area[arc], cells_.pieces.cell[piece], 0);
  }
  /// The plane of a face of a piece's cell. `sign`: whether it is the high one, or the low one.
  [[nodiscard]] double planeOf(std::uint32_t piece, int axis, int sign) const {
    const auto& box = boxOfRow(cells_, cells_.pieces.cell[piece]);
    return sign > 0 ? box.upper[axis] : box.lower[axis];
  }
  void take(std::size_t piece) {
    const auto row = cells_.pieces.cell[piece];
    for (std::size_t i = 0; i < count_; ++i) {
      note(length(sums_[piece * count_ + i]), row, kMonomials<3>[i].degree);
    }
    const auto wall = moments_.ofWall(piece)[0];
    const auto vector = moments_.ofWallVector(piece)[0];
    note(moments_.ofVolume(piece)[0] - cells_.pieces.volume[piece], row, 1);
    note(wall - cells_.pieces.wallArea[piece], row, 0);
    note(length(vector - cells_.pieces.wallVector[piece]), row, 0);
  }
  /// A difference in the units of areas times lengths to the power of a degree.
  void note(double difference, std::size_t row, int degree) {
    double unit = largestFace(cells_, row);
    for (int n = 0; n < degree; ++n) unit *= maxComponent(boxOfRow(cells_, row).size());
    const double share = std::abs(difference) / unit;
    worst_ = std::isnan(share) ? std::numeric_limits<double>::infinity() : std::max(worst_, share);
  }

  const Cut& cells_;
  const CutCells::Moments& moments_;
  std::size_t count_;
  std::vector<Vec3<double>> sums_;  // a row for each piece
  double worst_ = 0;
};

}  // namespace

double worstMoments(const CutCells& cells) {
  return cells.moments.degree < 0 ? 0 : MomentClosure(cells).worst();
}

double worstMoments(const CutLeaves& leaves) {
  return leaves.moments.degree < 0 ? 0 : MomentClosure(leaves).worst();
}

}  // namespace cutwater
