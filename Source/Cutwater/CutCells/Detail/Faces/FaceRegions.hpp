#pragma once

#include <Cutwater/CutCells/Detail/Faces/BaffleWays.hpp>
#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>

namespace cutwater {

/// A connected open part of a face between two cells.
struct FacePiece {
  std::uint32_t face = 0;
  double area = 0;
  Vec3<double> centroid;   ///< on the face; of the whole face if the area is 0
  bool isNothing = false;  ///< its rim is a point
};

/// A face between two cells, divided along the traces on it into convex regions: for faces on which
/// the surface meets itself or has baffles, and for the cells beside them. In floating point; the
/// same for both cells.
class FaceRegions {
 public:
  struct Region {
    SheetTree::Polygon polygon;  ///< counterclockwise as seen against the face's axis
    Vec3<double> point;          ///< within it; not in a place that symmetry would make special
    bool isFluid = false;        ///< and not within a baffle in the face
    std::uint32_t part = kNone;  ///< the open part that it belongs to
  };

  /// A straight part of what bounds an open part. Seen against the face's axis, fluid is on its
  /// left.
  struct Wall {
    std::uint32_t part = 0;
    std::uint32_t patch = 0;  ///< kNone for what closes the gap between copies of vertices
    Vec3<double> from;
    Vec3<double> to;
  };

  FaceRegions(const TileSurface& surface, const EdgeStretches& stretches, const GridPlanes& planes,
              std::uint32_t face);

  [[nodiscard]] std::span<const Region> regions() const { return regions_; }
  /// The connected open parts; what has no area, but for rounding, is nothing.
  [[nodiscard]] std::span<const FacePiece> parts() const { return parts_; }
  /// Within the face.
  [[nodiscard]] std::span<const Wall> walls() const { return walls_; }
  /// Shares a part of one of the face's edges, see edgeOfFace(), out among the patches of traces in
  /// it, the first that has a place; calls visit(patch, part). What none has is another one's.
  void shareRim(int side, const Interval<double>& part,
                FunctionRef<void(std::uint32_t patch, const Interval<double>& part)> visit) const;

 private:
  /// A trace in an edge.
  struct RimTrace {
    int side = 0;
    std::uint32_t patch = 0;
    Interval<double> ends;
  };

  void joinRegions(const SheetTree& tree, std::span<const std::uint32_t> regionOf,
                   const BaffleWays& ways, double least);
  void addWalls(const SheetTree& tree, std::span<const std::uint32_t> regionOf, double plane);
  void addWall(std::uint32_t part, std::uint32_t patch, const SheetTree::Polygon& polygon,
               const Vec3<double>& normal, double plane);
  void noteRimTraces(const SheetTree& tree);
  [[nodiscard]] std::uint32_t patchAt(int side, double place) const;
  void measure(std::uint32_t face, double least);

  int axis_ = 0;
  std::uint32_t somePatch_ = kNone;
  std::vector<Region> regions_;
  std::vector<FacePiece> parts_;
  std::vector<Wall> walls_;
  std::vector<RimTrace> rimTraces_;
};

/// The sheet of a fragment, in its triangle's plane; false if that has no area.
[[nodiscard]] bool makeSheet(const TileSurface& surface, const TileFragment& fragment,
                             Sheet& sheet);

/// An area that counts for nothing, in cells and faces where the surface meets itself: in shares of
/// a face.
inline constexpr double kSliver = 1e-12;

}  // namespace cutwater
