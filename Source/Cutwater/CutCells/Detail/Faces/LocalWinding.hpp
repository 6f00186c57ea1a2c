#pragma once

#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>

namespace cutwater {

/// The winding number at points of a face, which need not lie in its plane: along the face's first
/// edge, then along its second axis. In floating point: near traces it may be that across.
///
/// A point takes the time of a search, and of the traces on the way.
class WindingOnFace {
 public:
  /// Views both.
  WindingOnFace(const TileSurface& surface, const EdgeStretches& stretches, std::uint32_t face);

  [[nodiscard]] int at(const Vec3<double>& p) const;

 private:
  FaceAxes axes_;
  int atCorner_;
  std::span<const EdgeCrossing> crossings_;  // of the first edge
  std::vector<const FaceTrace*> traces_;
  detail::BinaryBvh tree_;  // over what they have of the first axis
};

/// The winding number at points of a cell: up from its lower face. The same holds.
class WindingInCell {
 public:
  /// Views both.
  WindingInCell(const TileSurface& surface, const EdgeStretches& stretches, std::uint32_t cell);

  [[nodiscard]] int at(const Vec3<double>& p) const;

 private:
  WindingOnFace onFace_;
  std::vector<std::span<const Vec3<double>>> polygons_;
  detail::BinaryBvh tree_;  // over them
};

}  // namespace cutwater
