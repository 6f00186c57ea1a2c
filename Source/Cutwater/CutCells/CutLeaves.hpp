#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// The fluid in the leaves of an octree that a surface cuts, in arrays as those of CutCells. Leaves
/// are given by their index in OctreeCells::cells().
///
/// Leaves that are cut are sorted by index; pieces by leaf; parts of the wall by piece and patch.
/// An arc lies in one face of the finer of its two leaves: across from finer leaves, the open parts
/// of a leaf's face are the arcs of theirs. Arcs are sorted by the finer leaf, of equal ones by
/// that above, then by axis, and low faces come before high ones.
struct CutLeaves {
  /// In place of a piece, as in CutCells: kBeyond where there is no leaf across the face, and
  /// beyond open patches, where the leaf is said to be kNoLeaf.
  static constexpr std::uint32_t kWholeCell = CutCells::kWholeCell;
  static constexpr std::uint32_t kBeyond = CutCells::kBeyond;
  /// In place of a row or a leaf: there is none.
  static constexpr std::uint32_t kNoRow = CutCells::kNoRow;
  static constexpr std::uint32_t kNoLeaf = 0xffffffff;

  /// Leaves that are cut.
  struct Leaves {
    std::vector<std::uint32_t> leaf;  ///< its index
    std::vector<Box<double>> box;
    std::vector<std::uint32_t> firstPiece;  ///< one more than leaves: the last is the number of all
    std::vector<std::uint8_t> fluidCorners;  ///< as in CutCells::Cells
    std::vector<std::uint8_t> meets;         ///< the same
    std::vector<std::uint8_t> wallFaces;     ///< the same
    std::vector<double> error;               ///< the same

    /// See CutCells::Cells::isThin().
    [[nodiscard]] bool isThin(std::size_t row) const { return CutCells::isThin(fluidCorners[row]); }
  };
  /// Open parts of a face between two leaves.
  struct Arcs {
    std::vector<std::uint32_t> below;  ///< the piece on this side, kWholeCell or kBeyond
    std::vector<std::uint32_t> above;
    std::vector<std::uint32_t> leafBelow;  ///< the leaf on this side, or kNoLeaf
    std::vector<std::uint32_t> leafAbove;
    std::vector<double> area;
    std::vector<Vec3<double>> centroid;
    std::vector<double> faceArea;    ///< of the finer leaf's face, which it lies in
    std::vector<std::uint8_t> axis;  ///< across the face
  };

  Leaves cut;                           ///< see above, as all rows
  CutCells::Pieces pieces;              ///< their volumes and walls; `cell` is the row of the leaf
  Arcs arcs;                            ///< what connects pieces across faces
  CutCells::OpenArcs openArcs;          ///< which of them are open patches
  CutCells::WallParts wallParts;        ///< walls by patch
  std::vector<std::string> patchNames;  ///< of the surface
  std::vector<FluidClass> classes;      ///< of every leaf; never Unknown
  CutCells::Moments moments;            ///< on request, of pieces and arcs
  CutCells::Quadrature quadrature;      ///< the same
  double wholeFluid = 0;                ///< the volume of the leaves that are all fluid
  double wholeBody = 0;                 ///< and of those without fluid

  /// On request, see CutOptions: as in CutCells. Where leaves of other levels are across a face or
  /// an edge of a leaf, polygons have their corners, too: those of a wall are convex but for
  /// rounding then.
  CutCells::Polygons arcPolygons;
  CutCells::Polygons wallPolygons;
  std::vector<std::uint64_t> firstWallPolygon;  ///< of each part of the wall; then their number

  /// The row of a leaf; kNoRow if it is not cut.
  [[nodiscard]] std::uint32_t rowOf(std::uint32_t leaf) const;
  /// As CutCells::isTouchedOnly().
  [[nodiscard]] bool isTouchedOnly(std::uint32_t row) const;
  /// The volume of a leaf that is cut, by its row.
  [[nodiscard]] double leafVolume(std::uint32_t row) const;
  /// The share that a piece has of its leaf, from 0 to 1.
  [[nodiscard]] double volumeFraction(std::uint32_t piece) const;
  /// The share that an arc has of the finer leaf's face, from 0 to 1.
  [[nodiscard]] double aperture(std::uint32_t arc) const;
};

/// Checks what holds for leaves of any surface that together fill their domain, see check() of
/// CutCells.
[[nodiscard]] CutCellsReport check(const CutLeaves& leaves);

/// A piece of a leaf that was covered.
struct LostLeafPiece {
  std::uint32_t leaf = 0;
  double volume = 0;
};

/// Cut leaves with one piece each, and what was lost.
struct MergedLeaves {
  CutLeaves leaves;
  std::vector<LostLeafPiece> lost;  ///< sorted by leaf
};

/// One piece a leaf, as merged() of CutCells leaves one a cell. Where leaves of other levels are
/// across a face, the arcs to them are closed one by one, each in the face of the finer leaf. A
/// leaf that was all fluid is cut once a part of one of its faces is closed. An octree of one level
/// gives what its grid gives, to the bit. What is beyond the leaves is kBeyond, and nothing of it
/// is covered. `mesh`: the octree whose leaves were cut.
/// @throws Error(Argument) unless options are within their ranges, and if the octree has another
/// number of leaves.
template <std::floating_point T>
[[nodiscard]] MergedLeaves merged(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                                  const MergeOptions& options = {});
extern template MergedLeaves merged(const CutLeaves&, const OctreeCells<float>&,
                                    const MergeOptions&);
extern template MergedLeaves merged(const CutLeaves&, const OctreeCells<double>&,
                                    const MergeOptions&);

/// Cut leaves as bytes, see toBytes() of CutCells.
/// @throws Error(Argument) if rows do not belong together, as they do in all cut leaves made here.
[[nodiscard]] std::vector<std::byte> toBytes(const CutLeaves& leaves);

/// The cut leaves of which toBytes() made these bytes, to the bit. The octree is not among them.
/// @throws Error(File) as cutCellsFrom() does.
[[nodiscard]] CutLeaves cutLeavesFrom(std::span<const std::byte> bytes);

/// Writes toBytes() to a file that appears under its name only once it is complete.
/// @throws Error(Argument) as toBytes() does; Error(File) if it cannot be written.
void saveCutLeaves(const std::filesystem::path& path, const CutLeaves& leaves);

/// Reads a file that saveCutLeaves() wrote.
/// @throws Error(File) "path: ..." as cutLeavesFrom() does, and if it cannot be read.
[[nodiscard]] CutLeaves loadCutLeaves(const std::filesystem::path& path);

}  // namespace cutwater
