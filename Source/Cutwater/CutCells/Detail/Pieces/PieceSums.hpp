#pragma once

#include <Cutwater/CutCells/Detail/Tiles/TileSurface.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// A connected part of the fluid in a cell.
struct CellPiece {
  std::uint32_t cell = 0;
  double volume = 0;
  Vec3<double> centroid;
  Vec3<double> areaVector;  ///< of the wall, out of the fluid
  double area = 0;          ///< of the wall
  Vec3<double> wallCentroid;
  std::uint8_t wallFaces = 0;  ///< as in CutCells::Pieces
};

/// What a patch of the surface has of a piece's wall.
struct PieceWall {
  std::uint32_t piece = 0;
  std::uint32_t patch = 0;
  double area = 0;
  Vec3<double> areaVector;
  Vec3<double> centroid;
};

/// A piece with its volume and its centroids within its cell. Films have no volume but for
/// rounding, and so any centroid.
[[nodiscard]] CellPiece withinCell(CellPiece piece, const Box<double>& cell);

/// Sums up the moments of a piece by the divergence theorem: each triangle of its wall, and each
/// open part of a face, adds its distance from a point of the piece times the integral of the
/// monomial over it.
class PieceSums {
 public:
  /// Moments refer to this point, which is near the piece so that they do not cancel.
  explicit PieceSums(const Vec3<double>& reference) : reference_(reference) {}

  /// A convex polygon, with its normal into the fluid; `patch`: kNone for one without area.
  void addWall(std::span<const Vec3<double>> polygon, std::uint32_t patch);
  /// The same of an open patch.
  void addOpenPatch(std::span<const Vec3<double>> polygon) { addPolygon(polygon, openPatches_); }
  /// An open part at this distance from the reference, outwards.
  [[nodiscard]] const Vec3<double>& reference() const { return reference_; }
  void addOpenPart(double distance, double area, const Vec3<double>& centroid);

  /// Whether the piece is a point or an edge, but for rounding: what copies of vertices leave.
  /// `share`: of a face, which is rounding.
  [[nodiscard]] bool isNothing(const Vec3<double>& cellSize, double share = kRounding) const;
  /// An area that is rounding in a cell of this size.
  [[nodiscard]] static double nothing(const Vec3<double>& cellSize, double share = kRounding) {
    return share * dot(cellSize, {cellSize.y, cellSize.z, cellSize.x});
  }
  /// Of all that bounds the piece.
  [[nodiscard]] double area() const;
  [[nodiscard]] CellPiece piece(std::uint32_t cell) const;
  /// Appends the parts of the wall in the order of patches.
  void appendWalls(std::uint32_t piece, std::vector<PieceWall>& walls);

 private:
  static constexpr double kRounding = 1e-14;

  PieceWall& wallOf(std::uint32_t patch);
  void addPolygon(std::span<const Vec3<double>> polygon, PieceWall& wall);

  Vec3<double> reference_;
  double volume_ = 0;  // times 3
  double openArea_ = 0;
  Vec3<double> moment_;
  std::vector<PieceWall> walls_;  // centroids are integrals from the reference
  PieceWall openPatches_{.areaVector = {}, .centroid = {}};
};

}  // namespace cutwater
