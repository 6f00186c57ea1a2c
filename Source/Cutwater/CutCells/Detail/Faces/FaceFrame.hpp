#pragma once

#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>

#include <utility>

namespace cutwater {

/// A face: its corners and the stretches around it, in the axes of the face.
class FaceFrame {
 public:
  FaceFrame(const TileNumbers& numbers, const GridPlanes& planes, std::uint32_t face)
      : planes_(planes), axes_(numbers.axisOfFace(face)), place_(numbers.placeOfFace(face)) {}

  [[nodiscard]] const FaceAxes& axes() const { return axes_; }
  [[nodiscard]] const TilePlace& place() const { return place_; }
  /// Corner 0 is the lowest along both axes, 1 the highest along the first, 2 along the second.
  [[nodiscard]] Vec3<double> corner(int corner) const {
    auto place = place_;
    place[asIndex(axes_.first)] += corner % 2;
    place[asIndex(axes_.second)] += corner / 2;
    return {planes_.at(0, place[0]), planes_.at(1, place[1]), planes_.at(2, place[2])};
  }

  /// Whether a walk around the face with the face on its left goes up a side, see edgeOfFace(); as
  /// seen against the face's axis.
  [[nodiscard]] static bool goesUp(int side) { return side == 0 || side == 3; }
  /// The ends of a stretch of a side, in the order of that walk.
  [[nodiscard]] std::array<Vec3<double>, 2> endsOf(int side, const EdgeStretch& stretch) const {
    const int along = side < 2 ? axes_.first : axes_.second;
    auto from = corner(side == 1 ? 2 : side == 3 ? 1 : 0);
    auto to = from;
    from[along] = stretch.from;
    to[along] = stretch.to;
    if (!goesUp(side)) std::swap(from, to);
    return {from, to};
  }

 private:
  const GridPlanes& planes_;
  FaceAxes axes_;
  TilePlace place_;
};

}  // namespace cutwater
