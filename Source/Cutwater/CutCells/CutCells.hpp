#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Sdf/FluidSide.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// The cells of a box of indices, between planes across each axis: of a grid patch, or of a grid
/// whose cells grow. It includes the planes of the cells around the box, one to each side.
struct CellPlanes {
  /// Across each axis, ascending, three more than the box has cells: cell first - 1 + n lies
  /// between the planes n and n + 1.
  std::array<std::vector<double>, 3> planes;
  Index3 first;  ///< the box's cell of lowest indices
  /// The number of cells in a period along each axis: those that are so many apart are one. 0:
  /// there is none. See CutterOptions::period.
  std::array<std::int32_t, 3> period = {};

  /// The box without the cells around it.
  [[nodiscard]] IndexBox indices() const;
};

/// The cells between these planes, one more than cells along each axis, in a domain that ends
/// there: the cells around it are as wide as their neighbours.
/// @throws Error(Argument) unless there are two planes at least across each axis.
[[nodiscard]] CellPlanes cellsBetween(const std::array<std::vector<double>, 3>& planes,
                                      const Index3& first = {});

/// The fluid in the cells of a box of indices that a surface cuts, in arrays of equal length for
/// each kind of row.
///
/// Cells are sorted by index, first by k, then by j, then by i; pieces by cell; parts of the wall
/// by piece and patch; arcs by the cell above them and by axis. Lengths, areas and volumes are in
/// the units of the grid: sums over pieces are those of the whole. Nothing refers to the solid.
///
/// An arc at the rim of the box may lead to a piece beyond it. The cells that lie there, and their
/// pieces, follow those of the box; cells that were coarsened know nothing of them. What an open
/// patch (see CutterOptions) has of a piece's boundary is an arc that leads to kBeyond, whatever
/// cell is across the face: the last ones of a face.
struct CutCells {
  /// In place of a piece beside an arc: all of the cell there is fluid.
  static constexpr std::uint32_t kWholeCell = 0xfffffffe;
  /// The same: the cell there lies beyond the box, and is not known, or the piece on the other side
  /// goes on beyond an open patch.
  static constexpr std::uint32_t kBeyond = 0xfffffffd;
  /// In place of a row: there is none.
  static constexpr std::uint32_t kNoRow = 0xffffffff;

  /// Cells that are cut.
  struct Cells {
    std::vector<Index3> index;
    std::vector<std::uint32_t> firstPiece;  ///< one more than cells: the last is the number of all
    /// Bit n: corner n of the cell, see Box::corner(), is in the fluid. One in the surface is on
    /// either side.
    std::vector<std::uint8_t> fluidCorners;
    /// 1 where pieces are found in floating point, because a triangle that meets others, or one of
    /// a baffle, is in the cell: see CellCutter. Else 0.
    std::vector<std::uint8_t> meets;
    /// Bit 2 axis + side (0: low, 1: high): a part of the cell's wall lies in that face, exactly in
    /// the plane of the grid. Of its pieces together: see Pieces::wallFaces.
    std::vector<std::uint8_t> wallFaces;
    /// Empty for meshes, whose rows are exact but for rounding. For other solids, an estimate of
    /// the error of volumes and open parts, in shares of the cell and of its faces: by how much
    /// they and the wall do not close before the wall's vector is made to.
    std::vector<double> error;

    /// Whether all corners are on one side: codes that know the signs of corners alone lose what is
    /// in the cell.
    [[nodiscard]] bool isThin(std::size_t row) const { return CutCells::isThin(fluidCorners[row]); }
  };
  /// The same, by the bits of corners.
  [[nodiscard]] static constexpr bool isThin(std::uint8_t corners) {
    return corners == 0 || corners == 0xff;
  }
  /// Connected parts of the fluid in a cell.
  struct Pieces {
    std::vector<std::uint32_t> cell;  ///< its row
    std::vector<double> volume;
    std::vector<Vec3<double>> centroid;
    std::vector<double> wallArea;
    std::vector<Vec3<double>> wallVector;    ///< the integral of the wall's normal out of the fluid
    std::vector<Vec3<double>> wallCentroid;  ///< the piece's where there is no wall
    /// In which faces of its cell parts of its wall lie, by the same bits as Cells::wallFaces.
    std::vector<std::uint8_t> wallFaces;
  };
  /// Open parts of a face between two cells.
  struct Arcs {
    std::vector<std::uint32_t> below;  ///< the piece on this side, kWholeCell or kBeyond
    std::vector<std::uint32_t> above;
    std::vector<double> area;
    std::vector<Vec3<double>> centroid;
    std::vector<Index3> cell;        ///< above the face; may lie one beyond the box
    std::vector<std::uint8_t> axis;  ///< across the face

    /// The cell below the face of an arc.
    [[nodiscard]] Index3 cellBelow(std::size_t arc) const;
  };
  /// The arcs that are parts of open patches, see CutterOptions.
  struct OpenArcs {
    std::vector<std::uint32_t> arc;    ///< their rows, ascending
    std::vector<std::uint32_t> patch;  ///< index into patchNames

    /// The open patch of an arc; kNoRow for others.
    [[nodiscard]] std::uint32_t patchOf(std::uint32_t row) const;
  };
  /// What each patch of the surface has of a piece's wall.
  struct WallParts {
    std::vector<std::uint32_t> piece;
    std::vector<std::uint32_t> patch;  ///< index into patchNames
    std::vector<double> area;
    std::vector<Vec3<double>> vector;  ///< as Pieces::wallVector
    std::vector<Vec3<double>> centroid;
  };

  /// Polygons, each given by its corners in order.
  struct Polygons {
    std::vector<std::uint64_t> first{0};  ///< where each begins in points; then their number
    std::vector<Vec3<double>> points;

    /// The number of polygons, and the corners of one of them.
    [[nodiscard]] std::size_t count() const { return first.size() - 1; }
    [[nodiscard]] std::span<const Vec3<double>> of(std::size_t polygon) const {
      return std::span(points).subspan(first[polygon], first[polygon + 1] - first[polygon]);
    }
    /// Appends a polygon.
    void add(std::span<const Vec3<double>> polygon);
  };

  /// Integrals of monomials, on request: see CutOptions::moments. A row has those up to the degree,
  /// of offsets from a centroid as its row states it, to the bit: of a piece's for its volume, of
  /// its wall's for its wall, and of an arc's. So those of small and thin pieces lose no digits.
  /// shifted() gives those about other points, such as a cell's center.
  ///
  /// They are in the order of their degree, and of one degree those with higher powers of x come
  /// first, then those of y: 1, x, y, z, xx, xy, xz, yy, yz, zz, xxx, ... Of an arc they are those
  /// of the axes of its face, in ascending order: 1, x, z, xx, xz, zz for a face across y. The
  /// integral of a monomial of degree k over a volume is a length to the power of k + 3, over a
  /// wall or an arc to that of k + 2.
  struct Moments {
    static constexpr int kHighest = 4;     ///< degree
    int degree = -1;                       ///< of each row; -1: there are none
    std::vector<double> volume;            ///< of each piece
    std::vector<double> wall;              ///< of each piece, over the area of its wall
    std::vector<Vec3<double>> wallVector;  ///< the same, times the wall's normal out of the fluid
    std::vector<double> arc;               ///< of each arc

    /// The place of the monomial x^p y^q z^r in a row.
    [[nodiscard]] static constexpr std::size_t indexOf(std::size_t p, std::size_t q,
                                                       std::size_t r) {
      const auto degree = p + q + r;
      return degree * (degree + 1) * (degree + 2) / 6 + (q + r) * (q + r + 1) / 2 + r;
    }
    /// Of an arc, that of the powers of the first and the second axis of its face.
    [[nodiscard]] static constexpr std::size_t indexOf(std::size_t first, std::size_t second) {
      return (first + second) * (first + second + 1) / 2 + second;
    }
    /// The number of monomials in a row of a piece, and of an arc.
    [[nodiscard]] std::size_t perPiece() const;
    [[nodiscard]] std::size_t perArc() const;
    /// The row of a piece, or of an arc.
    [[nodiscard]] std::span<const double> ofVolume(std::size_t piece) const;
    [[nodiscard]] std::span<const double> ofWall(std::size_t piece) const;
    [[nodiscard]] std::span<const Vec3<double>> ofWallVector(std::size_t piece) const;
    [[nodiscard]] std::span<const double> ofArc(std::size_t arc) const;
  };

  /// Points with weights, in rows. The weights of a row add up to its volume or area.
  struct PointRows {
    std::vector<std::uint64_t> first;  ///< of each row; then their number. Empty: there are none
    std::vector<Vec3<double>> points;
    std::vector<double> weights;  ///< all positive

    /// The points of a row, and their weights.
    [[nodiscard]] std::span<const Vec3<double>> pointsOf(std::size_t row) const {
      return std::span(points).subspan(first[row], first[row + 1] - first[row]);
    }
    [[nodiscard]] std::span<const double> weightsOf(std::size_t row) const {
      return std::span(weights).subspan(first[row], first[row + 1] - first[row]);
    }
  };
  /// Quadrature of functions over pieces, walls and open parts, on request: see
  /// CutOptions::quadrature. An integral is the sum of the function's values at the points of a
  /// row, times their weights.
  struct Quadrature {
    PointRows volume;                       ///< of each piece
    PointRows wall;                         ///< of each piece
    std::vector<Vec3<double>> wallNormals;  ///< at each of these points, out of the fluid, unit
    PointRows arc;                          ///< of each arc
  };

  CellPlanes grid;                      ///< what was cut
  Cells cells;                          ///< see above, as all rows
  Pieces pieces;                        ///< their volumes and walls
  Arcs arcs;                            ///< what connects pieces across faces
  OpenArcs openArcs;                    ///< which of them are open patches
  WallParts wallParts;                  ///< walls by patch
  std::vector<std::string> patchNames;  ///< of the surface
  std::size_t cellCount = 0;            ///< of the box: the rows of cells beyond it follow
  std::size_t pieceCount = 0;           ///< of these cells

  Moments moments;        ///< on request, of pieces and arcs
  Quadrature quadrature;  ///< the same

  /// On request, see CutOptions: the outline of each arc, counterclockwise as seen against its
  /// axis. Holes in it are cut open by an edge there and back. Corners are the same bits in all
  /// outlines and walls that meet there.
  Polygons arcPolygons;
  /// On request: the parts of triangles that make up each part of the wall, oriented as the
  /// surface, with normals into the fluid. They are convex. In cells where triangles meet, parts in
  /// one plane may be one, and others without area close the piece. Of solids that are no meshes,
  /// triangles that are right to the second order, whose pieces are closed as well.
  Polygons wallPolygons;
  std::vector<std::uint64_t> firstWallPolygon;  ///< of each part of the wall; then their number

  /// Ranges [first, last) of cells without fluid, counted through the box in the order of cells;
  /// cells that are cut may be among them.
  std::vector<std::array<std::uint64_t, 2>> bodyRuns;

  /// Where a cell of the box lies; never Unknown. A cell that the surface merely touches is not
  /// cut.
  [[nodiscard]] FluidClass classOf(const Index3& cell) const;
  /// Whether the surface only touches the cell of a row: it is all fluid, in one piece, but for
  /// rounding, and all of its wall lies in its faces. Cells that are touched in points and along
  /// edges alone have no row. Never where triangles meet, as a baffle takes no volume.
  [[nodiscard]] bool isTouchedOnly(std::uint32_t row) const;
  /// The row of a cell of the box; kNoRow if it is not cut.
  [[nodiscard]] std::uint32_t rowOf(const Index3& cell) const;
  /// The closed box of a cell of the box, or around it.
  [[nodiscard]] Box<double> boxOf(const Index3& cell) const;
  /// Of a cell, or of the face below it along an axis.
  [[nodiscard]] double cellVolume(const Index3& cell) const;
  [[nodiscard]] double faceArea(const Index3& cell, int axis) const;
  /// The share that a piece has of its cell, from 0 to 1.
  [[nodiscard]] double volumeFraction(std::uint32_t piece) const;
  /// The share that an arc has of its face, from 0 to 1.
  [[nodiscard]] double aperture(std::uint32_t arc) const;
};

/// The moments about `to` of what has these about `from`: a row of CutCells::Moments for a volume
/// or a wall, or one for an arc, whose face is across an axis. Exact but for rounding, as moments
/// of lower degrees give those about other points.
/// @throws Error(Argument) if a row has not the size of one.
[[nodiscard]] std::vector<double> shifted(std::span<const double> moments, const Vec3<double>& from,
                                          const Vec3<double>& to);
[[nodiscard]] std::vector<Vec3<double>> shifted(std::span<const Vec3<double>> moments,
                                                const Vec3<double>& from, const Vec3<double>& to);
[[nodiscard]] std::vector<double> shifted(std::span<const double> moments, int axis,
                                          const Vec3<double>& from, const Vec3<double>& to);

/// Cells that each join as many along each axis: what cutting the coarse cells gives, up to
/// rounding and the order of a cell's pieces, without the surface. Pieces that meet in an open face
/// within a coarse cell are one; arcs between the same two pieces are one. What lies beyond the box
/// is kBeyond, but for what is across the ends of a period that it spans. There are no polygons and
/// no quadrature, and corners in the surface may be on the other side. Moments are sums of those of
/// the cells. Repeat it for further levels, down to one cell.
/// @throws Error(Argument) unless the ratios are at least 1 and divide the box's first index and
/// its number of cells along each axis, and if an open patch lies within a coarse cell.
[[nodiscard]] CutCells coarsened(const CutCells& cells, const std::array<int, 3>& ratios);

/// The numbers of cut cells in another precision, for hosts that compute in it. Rows are those of
/// the cells, whose indices hold for them. Places are offsets from the center of the cell, and for
/// arcs of the face, so that they keep their digits far away from the origin.
template <std::floating_point T>
struct CutNumbers {
  /// As CutCells::Pieces.
  struct Pieces {
    std::vector<T> volume;
    std::vector<Vec3<T>> centroid;  ///< from the cell's center
    std::vector<T> wallArea;
    std::vector<Vec3<T>> wallVector;
    std::vector<Vec3<T>> wallCentroid;  ///< from the cell's center
  };
  /// As CutCells::Arcs.
  struct Arcs {
    std::vector<T> area;
    std::vector<Vec3<T>> centroid;  ///< from the face's center
  };
  /// As CutCells::WallParts.
  struct WallParts {
    std::vector<T> area;
    std::vector<Vec3<T>> vector;
    std::vector<Vec3<T>> centroid;  ///< from the cell's center
  };

  Pieces pieces;        ///< volumes and walls
  Arcs arcs;            ///< what connects pieces
  WallParts wallParts;  ///< walls by patch
};

/// The numbers of cells, rounded. The vector of a piece's wall is what closes its rounded open
/// parts, so a piece closes within the rounding of that vector; and those of the parts of its wall
/// add up to it, within the same. Pieces beyond the box, of which not all open parts are known, are
/// rounded alone.
template <std::floating_point T>
[[nodiscard]] CutNumbers<T> inPrecision(const CutCells& cells);
extern template CutNumbers<float> inPrecision(const CutCells&);
extern template CutNumbers<double> inPrecision(const CutCells&);

/// Options of merged().
struct MergeOptions {
  /// Pieces with less than this share of their cell are covered as well, from 0 to 1.
  double smallest = 0;
};

/// A piece of fluid that was covered.
struct LostPiece {
  Index3 cell;
  double volume = 0;
};

/// Cut cells with one piece each, and what was lost.
struct MergedCells {
  CutCells cells;
  std::vector<LostPiece> lost;  ///< sorted as cells
};

/// For hosts that hold one piece a cell: keeps the largest piece of each cell, and covers the
/// others. Their volume becomes body, and faces that led to them become wall of the cells beside
/// them, in a patch named "covered", the last one. Cells that are left without a direction of their
/// wall, because its vector is zero, are covered, too; those without a wall, bounded by open
/// patches alone, are not. Nothing is joined: fluid that a plate keeps apart stays apart.
///
/// A cell that was all fluid is cut once one of its faces is closed. There are no polygons and no
/// quadrature. What lies beyond the box is kBeyond, and nothing of it is covered, but for what is
/// across the ends of a period that it spans: for boxes that must agree, cut boxes that are larger
/// by a few cells, and take what is within.
/// @throws Error(Argument) unless options are within their ranges.
[[nodiscard]] MergedCells merged(const CutCells& cells, const MergeOptions& options = {});

/// What check() has found about cut cells.
struct CutCellsReport {
  double fluidVolume = 0;  ///< of all cells
  double bodyVolume = 0;
  double wallArea = 0;
  std::size_t cutCells = 0;
  std::size_t multiPieceCells = 0;
  std::size_t thinCells = 0;     ///< see CutCells::Cells::isThin()
  std::size_t meetingCells = 0;  ///< see CutCells::Cells::meets
  std::size_t planeCells = 0;    ///< with walls in planes of the grid: CutCells::Cells::wallFaces
  std::size_t touchedCells = 0;  ///< see CutCells::isTouchedOnly()
  /// The largest length of the sum of a piece's apertures and wall, over the area of its cell's
  /// largest face: 0 but for rounding.
  double worstClosure = 0;
  /// The same for moments, where there are any: the largest difference in an identity of the
  /// divergence theorem, for monomials of offsets from a piece's centroid; over the area of that
  /// face, and over the cell's longest side for each degree. Those of degree 0 are compared with
  /// volumes and areas, too.
  double worstMoments = 0;
  std::size_t outOfRange = 0;  ///< volumes, areas or centroids beyond their cell or face
  std::size_t lostPieces = 0;  ///< pieces without wall and arc, sides of arcs without their piece
};

/// Checks what holds for cut cells of any surface.
[[nodiscard]] CutCellsReport check(const CutCells& cells);

/// Cut cells as bytes, for a file or another rank: the grid, all rows and polygons as they lie in
/// memory, and a checksum. They depend on the cells and the machine's byte order alone.
/// @throws Error(Argument) if rows do not belong together, as they do in all cut cells made here.
[[nodiscard]] std::vector<std::byte> toBytes(const CutCells& cells);

/// The cut cells of which toBytes() made these bytes, to the bit.
/// @throws Error(File) for bytes of another kind, version or byte order, and for bytes that are
/// damaged, cut off or followed by others: the checksum, counts, the order of rows and what they
/// say of each other are checked.
[[nodiscard]] CutCells cutCellsFrom(std::span<const std::byte> bytes);

/// Writes toBytes() to a file that appears under its name only once it is complete.
/// @throws Error(Argument) as toBytes() does; Error(File) if it cannot be written.
void saveCutCells(const std::filesystem::path& path, const CutCells& cells);

/// Reads a file that saveCutCells() wrote.
/// @throws Error(File) "path: ..." as cutCellsFrom() does, and if it cannot be read.
[[nodiscard]] CutCells loadCutCells(const std::filesystem::path& path);

}  // namespace cutwater
