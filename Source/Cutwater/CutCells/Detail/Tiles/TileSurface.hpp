#pragma once

#include <Cutwater/CutCells/Detail/Surface/OpenPatches.hpp>
#include <Cutwater/CutCells/Detail/Surface/SheetKinds.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileNumbers.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TriangleSplitter.hpp>

#include <algorithm>
#include <vector>

namespace cutwater {

/// The records that have this number, among those sorted by it. (clang 14 does not take
/// std::ranges::equal_range() of a span.)
template <typename Record>
std::span<const Record> sortedUnder(std::span<const Record> records, std::uint32_t number,
                                    std::uint32_t Record::*member) {
  return {std::ranges::lower_bound(records, number, {}, member),
          std::ranges::upper_bound(records, number, {}, member)};
}

/// Where a piece of a trace ends: on an edge of the mesh, which the next triangle shares, or on an
/// edge of the grid.
struct TraceEnd {
  std::uint32_t meshEdge = kNone;  ///< only if gridEdge is kNone
  std::uint32_t gridEdge = kNone;
  bool operator==(const TraceEnd&) const = default;
};

/// The trace of a triangle on a face, or an edge of a baffle in it. Seen against the face's axis,
/// fluid is on its left.
struct FaceTrace {
  std::uint32_t face = 0;
  std::uint32_t triangle = 0;
  /// The fragments on both sides, where they are in the tile. None of the outline of a baffle that
  /// lies in the face.
  std::uint32_t below = kNone;
  std::uint32_t above = kNone;
  Vec3<double> from;
  Vec3<double> to;
  TraceEnd start;
  TraceEnd end;
};

/// Where a triangle crosses an edge of the grid.
struct EdgeCrossing {
  std::uint32_t edge = 0;
  std::uint32_t triangle = 0;
  double position = 0;  ///< along the edge's axis
  int rise = 0;         ///< of the winding number, going up the axis
};

/// A triangle's part in a cell.
struct TileFragment {
  std::uint32_t cell = 0;
  std::uint32_t triangle = 0;
  std::uint32_t first = 0;  ///< of its points and edges
  std::uint32_t size = 0;
};

/// What a surface has in a box of cells, sorted by cell, face and edge, and in each of these by
/// triangle.
class TileSurface {
 public:
  /// Takes the triangles of these numbers, in ascending order; all that meet the box. `patches`: of
  /// all triangles, or of those of the mesh; `kinds`: of all, or none if all are walls;
  /// `openKinds`: of those of the mesh, or none if no patch is open. All but the numbers and the
  /// planes is viewed.
  ///
  /// Baffles are cut as if they were moved up, and as if they were moved down: so where they end in
  /// a plane, they reach it from both sides, and where they lie in one, both cells have them.
  TileSurface(const MovedSurface& surface, std::span<const std::uint32_t> patches,
              std::span<const std::uint32_t> triangles, const GridPlanes& planes,
              std::span<const SheetKind> kinds = {}, std::span<const OpenKind> openKinds = {});

  [[nodiscard]] const TileNumbers& numbers() const { return numbers_; }
  /// Those of walls, and of triangles that meet others.
  [[nodiscard]] std::span<const TileFragment> fragments() const { return fragments_; }
  [[nodiscard]] std::span<const FaceTrace> traces() const { return traces_; }
  /// Those of triangles that are no walls, without their triangles' edges.
  [[nodiscard]] std::span<const TileFragment> buriedFragments() const { return buriedFragments_; }
  [[nodiscard]] std::span<const FaceTrace> buriedTraces() const { return buriedTraces_; }
  /// Those of all triangles but baffles.
  [[nodiscard]] std::span<const EdgeCrossing> crossings() const { return crossings_; }
  /// Those of baffles, in no order, some of them repeatedly; they have no rise.
  [[nodiscard]] std::span<const EdgeCrossing> baffleCrossings() const { return baffleCrossings_; }
  [[nodiscard]] std::span<const EdgeCrossing> crossingsOf(std::uint32_t edge) const;

  [[nodiscard]] SheetKind kindOf(std::uint32_t triangle) const {
    return kinds_.empty() ? SheetKind::Wall : kinds_[triangle];
  }
  [[nodiscard]] OpenKind openKindOf(std::uint32_t triangle) const {
    return triangle < openKinds_.size() ? openKinds_[triangle] : OpenKind::Wall;
  }
  /// Whether there may be others than walls.
  [[nodiscard]] bool hasOpenPatches() const { return !openKinds_.empty(); }
  /// The coordinate along an axis of a triangle that lies across it.
  [[nodiscard]] double placeOf(std::uint32_t triangle, int axis) const {
    return surface_.triangle(triangle)[0].position[axis];
  }
  /// In the frame, before they are moved.
  [[nodiscard]] std::array<Vec3<double>, 3> cornersOf(std::uint32_t triangle) const {
    return surface_.positionsOf(triangle);
  }
  [[nodiscard]] bool isBaffle(std::uint32_t triangle) const {
    return kindOf(triangle) == SheetKind::Baffle;
  }
  /// Whether triangles that meet others, or baffles, are among these fragments or traces.
  template <typename Parts>
  [[nodiscard]] bool meetAny(const Parts& parts) const {
    return !kinds_.empty() && std::ranges::any_of(parts, [&](const auto& part) {
      const auto kind = kindOf(part.triangle);
      return kind == SheetKind::Meeting || kind == SheetKind::Baffle;
    });
  }

  [[nodiscard]] std::span<const Vec3<double>> points(const TileFragment& fragment) const {
    return std::span(points_).subspan(fragment.first, fragment.size);
  }
  /// The patch of a triangle; kNone for one without area that closes the gap between copies.
  [[nodiscard]] std::uint32_t patchOf(std::uint32_t triangle) const {
    return triangle < patches_.size() ? patches_[triangle] : kNone;
  }
  /// The edges of the mesh that bound the fragment, in place of planes kNone.
  [[nodiscard]] std::span<const std::uint32_t> meshEdges(const TileFragment& fragment) const {
    return std::span(meshEdges_).subspan(fragment.first, fragment.size);
  }

 private:
  void splitBaffle(std::uint32_t triangle, const GridPlanes& planes, TriangleSplitter& splitter);
  void add(std::uint32_t triangle, const Fragment& fragment);
  void addOutline(std::uint32_t triangle, const Fragment& fragment, const GridPlanes& planes);
  void addTrace(std::uint32_t triangle, const Fragment& fragment, std::size_t side);
  [[nodiscard]] bool isOwner(const Fragment& fragment, const FragmentEdge& plane) const;
  void sort();
  void sortTraces(std::span<const std::uint32_t> numberOf);
  void sortBuried();

  /// The fragment below a face of which the cell above gives the trace.
  struct FragmentBelow {
    std::uint32_t face = 0;
    std::uint32_t triangle = 0;
    std::uint32_t fragment = 0;
  };

  const MovedSurface& surface_;
  TileNumbers numbers_;
  std::span<const std::uint32_t> patches_;
  std::span<const SheetKind> kinds_;
  std::span<const OpenKind> openKinds_;
  std::vector<TileFragment> fragments_;
  std::vector<Vec3<double>> points_;
  std::vector<std::uint32_t> meshEdges_;
  std::vector<FaceTrace> traces_;
  std::vector<FragmentBelow> below_;
  std::vector<EdgeCrossing> crossings_;
  std::vector<EdgeCrossing> baffleCrossings_;
  std::vector<TileFragment> buriedFragments_;
  std::vector<FaceTrace> buriedTraces_;
};

}  // namespace cutwater
