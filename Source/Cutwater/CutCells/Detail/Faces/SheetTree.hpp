#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/FunctionRef.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cutwater {

/// A plane, with a normal of unit length.
struct SheetPlane {
  Vec3<double> normal;
  double offset = 0;

  [[nodiscard]] double height(const Vec3<double>& p) const { return dot(normal, p) - offset; }
};

/// A convex polygon of a surface in a box.
struct Sheet {
  std::vector<Vec3<double>> points;
  SheetPlane plane;  ///< its normal points into the fluid
  /// Of the triangle or trace that it is a part of, across its longest edge: the narrower that is,
  /// the more its corners' rounding tilts the plane.
  double width = 0;
  std::uint32_t patch = 0;
  bool isBaffle = false;   ///< the fluid is on both sides
  bool isDivider = false;  ///< it only divides, before others do
};

/// A box, divided by planes through the sheets in it into convex leaves that no sheet passes
/// through (Fuchs, Kedem and Naylor, SIGGRAPH 1980). Where sheets crowd, it is halved first.
///
/// All is in floating point: leaves thinner than kFlat may be lost, and nothing else depends on it.
/// But where baffles that share an edge are nearly parallel, their planes may cross far away from
/// it, and leave a way through: there, the space is divided along the edge first.
class SheetTree {
 public:
  using Polygon = std::vector<Vec3<double>>;

  /// Distances from planes below this are rounding. Coordinates are up to about 1.
  static constexpr double kNear = 0x1p-48;
  /// Sheets no farther from the plane of another one lie in it: between two planes that are nearly
  /// one, leaves would be so thin that their sides are not found alike. Nor are there sheets
  /// narrower than this, whose planes are nearly any.
  static constexpr double kFlat = 0x1p-40;
  /// Openings beside baffles that are narrower are none: rounding leaves such gaps between those
  /// that share an edge.
  static constexpr double kGap = 0x1p-36;

  /// A polygon in a plane of the tree, and the leaves below it and above it, where its normal
  /// points.
  struct Portal {
    std::uint32_t below = 0;
    std::uint32_t above = 0;
    std::uint32_t node = 0;
    Polygon polygon;
  };

  SheetTree(const Box<double>& box, std::vector<Sheet> sheets);

  [[nodiscard]] std::uint32_t leafCount() const { return leafCount_; }
  /// Between all leaves that are neighbours.
  [[nodiscard]] std::span<const Portal> portals() const { return portals_; }
  /// The sheets in the plane of a portal.
  [[nodiscard]] std::span<const Sheet> sheetsAt(const Portal& portal) const {
    return nodes_[portal.node].sheets;
  }
  /// The sheets in one of the box's faces: two for each axis, low and high.
  [[nodiscard]] std::span<const Sheet> sheetsIn(std::size_t face) const { return inFaces_[face]; }

  /// The parts of a polygon that leaves have; of one in a plane of the tree, those on this side.
  void divide(const Polygon& polygon, const Vec3<double>& side,
              FunctionRef<void(std::uint32_t leaf, const Polygon& part)> visit) const {
    divideFrom(root_, polygon, side, visit);
  }
  /// The leaf at a point, or on this side of it.
  [[nodiscard]] std::uint32_t leafAt(const Vec3<double>& p, const Vec3<double>& side) const;
  /// A point within each leaf that has any portals or faces of the box; not in a place that
  /// symmetry would make special.
  [[nodiscard]] std::vector<Vec3<double>> pointsIn() const;

  /// One of the box's faces, counterclockwise as seen from outside.
  [[nodiscard]] Polygon face(std::size_t face) const;
  /// The direction into the box from one of its faces.
  [[nodiscard]] static Vec3<double> inwards(std::size_t face);

 private:
  struct Node {
    SheetPlane plane;
    std::array<std::uint32_t, 2> children{};  ///< below and above
    std::vector<Sheet> sheets;                ///< in the plane
  };
  /// A child that is a leaf.
  static constexpr std::uint32_t kLeaf = 0x80000000;

  struct Choice;
  [[nodiscard]] Choice chosenPlane(std::span<const Sheet> sheets) const;
  std::uint32_t build(std::vector<Sheet> sheets);
  void findPortals(std::uint32_t node, std::vector<SheetPlane>& path);
  [[nodiscard]] Polygon inBox(const SheetPlane& plane, std::span<const SheetPlane> path) const;
  void divideFrom(std::uint32_t node, const Polygon& polygon, const Vec3<double>& side,
                  FunctionRef<void(std::uint32_t, const Polygon&)> visit) const;

  Box<double> box_;
  std::array<std::vector<Sheet>, 6> inFaces_;
  std::vector<Node> nodes_;
  std::uint32_t root_ = kLeaf;
  std::uint32_t leafCount_ = 0;
  std::vector<Portal> portals_;
};

/// Twice the area of a polygon, times its normal.
[[nodiscard]] Vec3<double> twiceArea(std::span<const Vec3<double>> polygon);
/// Whether its area is less than half of this width times its perimeter.
[[nodiscard]] bool isNarrow(std::span<const Vec3<double>> polygon, double width);
/// Whether it is narrower than SheetTree::kGap.
[[nodiscard]] inline bool isGap(std::span<const Vec3<double>> polygon) {
  return isNarrow(polygon, SheetTree::kGap);
}
/// The mean of its corners.
[[nodiscard]] Vec3<double> middleOf(std::span<const Vec3<double>> polygon);

/// Shares a polygon out among the patches of the sheets in its plane that face its way, as baffles
/// always do, the first that has a part of it; calls visit(patch, part). What none has is the last
/// one's. There must be sheets.
void sharedOut(const SheetTree::Polygon& polygon, const Vec3<double>& normal,
               std::span<const Sheet> sheets,
               FunctionRef<void(std::uint32_t patch, const SheetTree::Polygon& part)> visit);

/// Takes from a polygon what baffles in its plane have of it, and calls visit(patch, part) for it;
/// returns the rest.
[[nodiscard]] std::vector<SheetTree::Polygon> withoutBaffles(
    const SheetTree::Polygon& polygon, std::span<const Sheet> sheets,
    FunctionRef<void(std::uint32_t patch, const SheetTree::Polygon& part)> visit);

}  // namespace cutwater
