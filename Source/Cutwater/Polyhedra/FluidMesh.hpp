#pragma once

#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// The fluid as a mesh of polyhedra, as finite-volume codes take it: cells, each bounded by faces
/// that lie between two cells or in a patch. The faces of a cell meet edge by edge.
///
/// Inner faces come first, in the order of their owners, those of one owner in the order of their
/// neighbours, and an owner's number is less than its neighbour's; then come the faces of each
/// patch, in the order of their owners. That is what OpenFOAM asks for.
struct FluidMesh {
  /// What a patch of faces is.
  enum class PatchKind : std::uint8_t {
    Wall,  ///< a patch of the surface
    Open,  ///< an open patch of the surface, see CutterOptions::openPatches
    Side,  ///< a side of the octree's domain
  };
  /// Faces that follow each other.
  struct Patch {
    std::string name;  ///< of the surface's patch; "xMin", "xMax", ... of sides
    PatchKind kind = PatchKind::Wall;
    std::uint32_t firstFace = 0;
    std::uint32_t faceCount = 0;
  };
  /// Rows of faces.
  struct Faces {
    std::vector<std::uint64_t> first{0};  ///< where each begins in corners; then their number
    std::vector<std::uint32_t>
        corners;                       ///< points, counterclockwise as seen from outside the owner
    std::vector<std::uint32_t> owner;  ///< cells
    std::vector<std::uint32_t> neighbour;  ///< of inner faces

    /// The number of faces, and the corners of one of them.
    [[nodiscard]] std::size_t count() const { return owner.size(); }
    [[nodiscard]] std::span<const std::uint32_t> of(std::size_t face) const {
      return std::span(corners).subspan(first[face], first[face + 1] - first[face]);
    }
  };
  /// In the order of their leaves.
  struct Cells {
    std::vector<std::uint32_t> leaf;    ///< that it is in; the first one, if pieces were joined
    std::vector<double> volume;         ///< of its fluid, as its pieces state it
    std::vector<std::uint32_t> region;  ///< index into regions
  };

  std::vector<Vec3<double>> points;  ///< corners of faces
  Faces faces;                       ///< see above
  std::vector<Patch> patches;        ///< those that have faces
  Cells cells;
  /// The volumes of the connected regions of fluid that were kept, the largest first.
  std::vector<double> regions;

  double lostVolume = 0;         ///< of the regions that were left out
  std::size_t lostRegions = 0;   ///< their number
  std::size_t joinedPieces = 0;  ///< pieces and cells that are parts of others' cells
};

/// Which regions of fluid are kept.
enum class Cavities : std::uint8_t {
  LeftOut,  ///< those that lead out of the domain or through an open patch; the largest, if none
            ///< does
  Kept,     ///< all
};

/// Options of fluidMesh().
struct FluidMeshOptions {
  /// What a patch has of a cell's wall is one face if its rim is one loop, and else as few as each
  /// have one. Such a face has the exact area vector, but is not plane, so that volumes differ from
  /// the fluid's by the second order of the cell's width. If true, the polygons of the wall are
  /// faces, which are plane, and volumes are those of the fluid.
  bool wallPolygons = false;
  /// Pieces with less than this share of their leaf are joined to the cell across their largest
  /// face, from 0 to 1.
  double smallest = 0.1;
  Cavities cavities = Cavities::LeftOut;
  /// If given, the only region that is kept is that of this point.
  std::optional<Vec3<double>> within = {};
  int threads = 0;  ///< see ParallelOptions
};

/// The fluid in the leaves of an octree as a mesh of polyhedra: leaves that are all fluid, and the
/// pieces of those that are cut.
///
/// Cells beside faces that check() would count as inverted, skew or non-orthogonal are joined,
/// divided by planes, or joined and divided otherwise, and their walls of one patch become one
/// face, if that leaves fewer of them; with wallPolygons they are divided only. Where a cell is
/// divided, its volume is shared out as those of the two polyhedra.
///
/// @param leaves  what CellCutter::cut() or SolidCutter::cut() gave for it with polygons.
/// @param mesh  the octree, all of it.
/// @param options  see there.
/// @throws Error(Argument) unless options are within their ranges, without polygons, if the octree
/// has another number of leaves or does not fill its domain, and if `within` is not in the fluid;
/// Error(Limit) for 2^31 points, faces or cells or more.
template <std::floating_point T>
[[nodiscard]] FluidMesh fluidMesh(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                                  const FluidMeshOptions& options = {});
extern template FluidMesh fluidMesh(const CutLeaves&, const OctreeCells<float>&,
                                    const FluidMeshOptions&);
extern template FluidMesh fluidMesh(const CutLeaves&, const OctreeCells<double>&,
                                    const FluidMeshOptions&);

/// What check() has found about a mesh. Centres, areas and volumes are as OpenFOAM computes them:
/// of a face by the triangles between its edges and the mean of its corners, of a cell by the
/// pyramids between its faces and the mean of their centres. Limits are those of its checkMesh.
struct FluidMeshReport {
  double fluidVolume = 0;  ///< of the cells as they state it
  double meshVolume = 0;   ///< of their polyhedra
  /// The largest length of the sum of a cell's area vectors, over the sum of their lengths.
  double worstClosure = 0;
  std::size_t openCells = 0;        ///< that have an edge along which faces do not meet
  std::size_t repeatedCorners = 0;  ///< faces that have a corner twice, or fewer than three
  std::size_t disordered = 0;       ///< faces not in the order that FluidMesh describes
  std::size_t flatFaces = 0;        ///< of no area at all
  std::size_t fewFaces = 0;         ///< cells that have fewer than four
  std::size_t invertedCells = 0;    ///< of no volume, or less
  std::size_t invertedFaces = 0;    ///< pyramids of no volume, or less, over the faces of cells
  std::size_t skewFaces = 0;        ///< of a skewness above 4
  double worstSkewness = 0;
  std::size_t nonOrthogonalFaces = 0;  ///< by more than 70 degrees
  double worstNonOrthogonality = 0;    ///< in degrees
  double meanNonOrthogonality = 0;     ///< that of the mean cosine of inner faces
  double worstAspectRatio = 0;
};

/// Checks what finite-volume codes ask of a mesh.
/// @param mesh  all of it.
/// @param threads  see ParallelOptions; what is found does not depend on it.
[[nodiscard]] FluidMeshReport check(const FluidMesh& mesh, int threads = 0);

}  // namespace cutwater
