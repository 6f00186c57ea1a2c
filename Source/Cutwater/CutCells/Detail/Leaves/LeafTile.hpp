#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafBlocks.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileCut.hpp>

#include <tuple>

namespace cutwater {

/// What leaves know about the open parts of their faces to leaves of other levels, by which these
/// are joined to the pieces across: see CoarseFace.hpp. Faces, arcs and rows are those of the tile.
struct LeafRims {
  /// A triangle on the rim of an open part of a face to a coarser leaf.
  struct RimTriangle {
    std::uint32_t arc = 0;
    std::uint32_t triangle = 0;
    [[nodiscard]] auto key() const { return std::pair(arc, triangle); }
  };
  /// A stretch of an edge of such a face: `side` as in edgeOfFace(), ends in the frame.
  struct RimStretch {
    std::uint32_t face = 0;
    int side = 0;
    bool isWhole = false;  ///< it is all of the edge, and nothing crosses that
    std::uint32_t arc = 0;
    Interval<double> ends;
  };
  /// A triangle in a leaf with finer ones across a face, and the piece that it bounds, or kNone.
  struct WallTriangle {
    std::uint32_t row = 0;
    std::uint32_t triangle = 0;
    std::uint32_t piece = 0;
  };
  /// If the surface meets itself: a point within an open part of such a face, in the frame.
  struct InnerPoint {
    std::uint32_t arc = 0;
    Vec3<double> point;
  };
  /// A convex open region of a face to finer leaves, of a leaf in which triangles meet, and the
  /// piece behind it, or kNone. In the frame.
  struct OpenRegion {
    std::uint32_t face = 0;
    std::uint32_t piece = 0;
    SheetTree::Polygon polygon;
  };
  /// With polygons: the trace of a triangle on a face to a coarser leaf, in the frame.
  struct Trace {
    std::uint32_t face = 0;
    std::uint32_t triangle = 0;
    Vec3<double> from;  ///< as FaceTrace
    Vec3<double> to;
    [[nodiscard]] auto key() const { return std::pair(face, triangle); }
  };
  /// With polygons: an edge of a part of a wall, see TilePolygons, in a face of its leaf to finer
  /// ones.
  struct WallEdge {
    std::uint32_t wall = 0;
    std::uint32_t edge = 0;  ///< from this corner to the next
    std::uint32_t triangle = 0;
    int axis = 0;  ///< across the face
    bool isHigh = false;
    [[nodiscard]] auto key() const { return std::pair(wall, edge); }
  };

  /// Of a solid that is no mesh: which piece of a leaf is behind an open part of the face of a
  /// finer one.
  struct PieceBehind {
    std::uint32_t face = 0;   ///< of the leaf
    std::uint32_t finer = 0;  ///< the leaf across
    std::uint32_t part = 0;   ///< its number among those of that leaf's face
    std::uint32_t piece = 0;
    [[nodiscard]] auto key() const { return std::tuple(face, finer, part); }
  };

  std::vector<RimTriangle> triangles;   ///< sorted
  std::vector<RimStretch> stretches;    ///< sorted by face and side
  std::vector<WallTriangle> walls;      ///< sorted by row and triangle
  std::vector<InnerPoint> innerPoints;  ///< sorted by arc
  std::vector<OpenRegion> openRegions;  ///< sorted by face
  std::vector<std::uint32_t> cutFaces;  ///< ascending: those that the surface meets
  std::vector<Trace> traces;            ///< sorted by face and triangle
  std::vector<WallEdge> wallEdges;      ///< sorted by wall and edge
  std::vector<PieceBehind> behind;      ///< sorted by face, leaf and part
};

/// The leaves of one level in a block that are cut.
struct LeafTile {
  int level = 0;
  Index3 first;  ///< the cell of lowest indices
  TileCut cut;
  std::vector<std::uint32_t> leaves;  ///< of the rows of `cut`
  /// The arcs that count, by face: pairs of a face and an arc.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> arcs;
  /// With polygons: those that count for nothing, but have an outline.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> points;
  /// The arcs of open patches, which are not among `arcs`.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> openArcs;
  LeafRims rims;

  /// A face of one of the cells that are cut.
  [[nodiscard]] std::uint32_t faceOf(std::uint32_t row, int axis, bool isHigh) const;
  /// Its arcs that count: see `arcs`.
  [[nodiscard]] std::span<const std::pair<std::uint32_t, std::uint32_t>> arcsOf(
      std::uint32_t face) const;
  [[nodiscard]] std::span<const std::pair<std::uint32_t, std::uint32_t>> pointsOf(
      std::uint32_t face) const;
  [[nodiscard]] std::span<const std::pair<std::uint32_t, std::uint32_t>> openArcsOf(
      std::uint32_t face) const;
};

/// Cuts the leaves of an octree, and sets the classes of all of them. The order of tiles says
/// nothing.
[[nodiscard]] std::vector<LeafTile> cutLeafTiles(const CutSurface& surface, const LeafGrid& grid,
                                                 const CutOptions& options,
                                                 std::span<FluidClass> classes);

}  // namespace cutwater
