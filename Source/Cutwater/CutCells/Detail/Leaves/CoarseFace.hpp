#pragma once

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafSources.hpp>

namespace cutwater {

/// A face of a leaf that has finer ones across: the open parts of their faces, and which piece of
/// the leaf is behind each.
///
/// A triangle's part in a cell is convex, so it bounds one piece there: the piece of the leaf that
/// is behind an open part is that which the triangles on the part's rim bound in the leaf. Parts
/// without rims in the surface are joined to others through the edges between the finer faces;
/// where none of them has such a rim, all of the leaf's face is open. So no coordinates of
/// different levels are compared but where nothing is near.
///
/// In a leaf where triangles meet, it is the piece behind a point within the open part: by the
/// convex regions of the leaf's own face. Where the solid is no mesh, its leaf knows.
class CoarseFace {
 public:
  /// An open part of the face of a finer leaf.
  struct Part {
    std::uint32_t leaf = 0;
    std::uint32_t arc = kNone;     ///< of that leaf's tile; kNone: all of the face of one not cut
    std::uint32_t behind = kNone;  ///< the coarse leaf's piece, in its tile; kNone if it is dropped
  };

  /// `coarse`: the source of the leaf, which is cut or touched.
  CoarseFace(const LeafGrid& grid, const LeafSources& sources, std::span<const FluidClass> classes,
             std::uint32_t coarse, int axis, bool isHigh);

  /// In the order of leaves.
  [[nodiscard]] std::span<const Part> parts() const { return parts_; }
  /// With polygons: those that count for nothing, but have an outline.
  [[nodiscard]] std::span<const Part> points() const { return points_; }

 private:
  /// What is behind a part whose rim says nothing.
  static constexpr std::uint32_t kUnknown = kNone - 1;

  void findParts(std::span<const FluidClass> classes);
  void lookUpBehind();
  void findBehind(Part& part) const;
  [[nodiscard]] Vec3<double> pointIn(const Part& part) const;
  [[nodiscard]] std::uint32_t behindPoint(const Vec3<double>& point) const;
  void joinThroughEdges();
  void joinThroughEdge(std::uint32_t finer, int side);
  void settle();
  [[nodiscard]] std::uint32_t wholeFacePiece() const;

  /// The face of a finer leaf.
  [[nodiscard]] std::uint32_t finerFace(std::uint32_t source) const {
    return sources_.faceOf(source, axis_, !isHigh_);
  }
  /// The part at a place of an edge of a finer leaf's face; kNone if it is not open there.
  [[nodiscard]] std::uint32_t partAt(std::uint32_t finer, int side, double place,
                                     bool ifWhole) const;
  [[nodiscard]] std::uint32_t partOf(std::uint32_t finer, std::uint32_t arc) const;

  const LeafGrid& grid_;
  const LeafSources& sources_;
  std::uint32_t coarse_;
  int axis_;
  bool isHigh_;
  std::vector<std::uint32_t> finer_;      // leaves
  std::vector<std::uint32_t> firstPart_;  // of each; then the number of all
  std::vector<Part> parts_;
  std::vector<Part> points_;
  detail::DisjointSets sets_;
};

}  // namespace cutwater
