#pragma once

#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Core/Box.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutPeriod.hpp>
#include <Cutwater/CutCells/Detail/Surface/OpenPatches.hpp>
#include <Cutwater/CutCells/Detail/Surface/SheetKinds.hpp>
#include <Cutwater/Sdf/FluidSide.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

namespace cutwater {

/// Coordinates in which cells are cut: those of the world minus an origin, times a power of two.
/// Both are exact for all vertices and for the planes between them; but what is below 2^-340 is
/// rounded away, in the same way everywhere, so that predicates of products of it are exact.
struct CutFrame {
  Vec3<double> origin;
  double scale = 1;
  Vec3<double> shift = {};  ///< of what was cut elsewhere, whole periods away, into the world

  [[nodiscard]] double toFrame(int axis, double x) const {
    return coarse((x - origin[axis]) * scale);
  }
  [[nodiscard]] Vec3<double> toWorld(const Vec3<double>& p) const {
    return p / scale + origin + shift;
  }
};

/// A closed surface as cells are cut by it: in its frame, with the fluid outside, and moved; and
/// baffles in the fluid.
class CutSurface {
 public:
  /// Equal points of the soup are one. `meetings`: but for these it is known not to meet itself,
  /// and no shell lies within another's solid. `openPatches`, `baffles`: the numbers of these
  /// patches. `period`: of a surface with its images.
  /// @throws Error(Topology) if the triangles of the soup are not closed, or cancel each
  /// other.
  CutSurface(const PolygonSoup& triangles, FluidSide side, MeetingsOf meetings,
             std::span<const std::uint32_t> openPatches = {},
             std::span<const std::uint32_t> baffles = {}, const CutPeriod& period = {});

  [[nodiscard]] const CutFrame& frame() const { return frame_; }
  [[nodiscard]] const CutPeriod& period() const { return period_; }
  [[nodiscard]] const MovedSurface& moved() const { return moved_; }
  /// Of each triangle of the moved surface its patch; kNone of one that closes a gap.
  [[nodiscard]] std::span<const std::uint32_t> patches() const { return patches_; }
  [[nodiscard]] const std::vector<std::string>& patchNames() const { return patchNames_; }
  /// Around each triangle of the moved surface, in the frame.
  [[nodiscard]] const Box<double>& box(std::uint32_t triangle) const { return boxes_[triangle]; }
  /// The triangles of the moved surface whose boxes meet this one, in ascending order.
  [[nodiscard]] std::vector<std::uint32_t> trianglesIn(const Box<double>& box) const;
  [[nodiscard]] const Box<double>& boundingBox() const { return tree_.nodes.front().box; }
  /// Of all triangles of the moved surface; empty: all are walls.
  [[nodiscard]] std::span<const SheetKind> kinds() const { return kinds_; }
  /// Of the triangles of the mesh; empty: no patch is open.
  [[nodiscard]] std::span<const OpenKind> openKinds() const { return openKinds_; }
  /// Whether parts of it meet, or there are baffles.
  [[nodiscard]] bool meetsItself() const { return meetsItself_; }
  /// Whether a triangle of a baffle lies at this height, in the frame.
  [[nodiscard]] bool hasBaffleAt(double z) const;
  /// The winding number far away.
  [[nodiscard]] int windingOutside() const { return windingOutside_; }

 private:
  /// Triangles of a soup, by number.
  struct Selection {
    std::vector<std::uint32_t> walls;
    std::vector<std::uint32_t> baffles;
  };
  static Selection selected(const PolygonSoup& soup, MeetingsOf meetings,
                            std::span<const std::uint32_t> baffles);
  CutSurface(const PolygonSoup& soup, const Selection& selection, FluidSide side,
             MeetingsOf meetings, std::span<const std::uint32_t> openPatches,
             const CutPeriod& period);
  /// In the frame; where there is a period, cells elsewhere are those whole periods away.
  [[nodiscard]] Box<double> whereCut() const;
  void addBaffles(const PolygonSoup& soup, std::span<const std::uint32_t> baffles);

  CutFrame frame_;
  CutPeriod period_;
  int windingOutside_;
  std::vector<std::uint32_t> patches_;
  std::vector<std::string> patchNames_;
  MovedSurface moved_;
  std::vector<OpenKind> openKinds_;
  std::vector<Box<double>> boxes_;
  detail::BinaryBvh tree_;  // over the boxes
  std::vector<SheetKind> kinds_;
  bool meetsItself_ = false;
};

}  // namespace cutwater
