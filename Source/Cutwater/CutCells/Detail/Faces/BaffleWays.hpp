#pragma once

#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Tiles/TileSurface.hpp>

#include <span>
#include <vector>

namespace cutwater {

/// Straight ways between baffles. What is joined by ways that cross none is connected, whatever
/// rounding makes of the planes of baffles: a way passes on the same side of an edge for both
/// polygons that share it, so none passes between them.
class BaffleWays {
 public:
  BaffleWays() = default;
  /// Between those in a cell; views them.
  BaffleWays(const TileSurface& surface, std::span<const TileFragment> fragments);
  /// Between those on a face, in its plane; views their traces.
  BaffleWays(const TileSurface& surface, std::uint32_t face);

  [[nodiscard]] bool areAny() const { return !polygons_.empty() || !traces_.empty(); }
  /// From p by q to r.
  [[nodiscard]] bool isOpen(const Vec3<double>& p, const Vec3<double>& q,
                            const Vec3<double>& r) const {
    return isOpen(p, q) && isOpen(q, r);
  }
  [[nodiscard]] bool isOpen(const Vec3<double>& p, const Vec3<double>& q) const;

 private:
  std::vector<std::span<const Vec3<double>>> polygons_;
  std::vector<const FaceTrace*> traces_;
  FaceAxes axes_{0};
};

}  // namespace cutwater
