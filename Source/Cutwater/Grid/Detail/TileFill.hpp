#pragma once

#include <Cutwater/Grid/Detail/PointBatch.hpp>
#include <Cutwater/Grid/Detail/TileParts.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>

namespace cutwater::detail {

/// Fills tiles of a grid patch, one at a time. Points are evaluated in the tile's order, because
/// the value at one tells much about its neighbours', and in batches.
///
/// With a band, a tile is divided into ever smaller parts as long as the value in a part's middle
/// does not prove that the whole part is beyond the band. Middles of parts of one size are
/// evaluated together.
template <std::floating_point T>
class TileFill {
 public:
  explicit TileFill(const FillTask<T>& task) : task_(task), batch_(task) {}

  void fill(const OffsetBox& tile);
  /// After the last tile.
  void finish() { batch_.flush(); }

 private:
  /// A part of the tile, and what is known about it. It is settled if all of it is beyond the
  /// limit.
  struct Part : TilePart {
    Box<T> box = {};       // around its positions
    T sign = 1;            // on which side it is beyond
    Vec3<T> center = {};   // all is beyond within a radius of it;
    T beyondSquared = -1;  // that radius squared, if positive
  };

  void placePositions();
  [[nodiscard]] Vec3<T> position(const Offset& inTile) const {
    return {positions_[inTile[0]].x, positions_[inTile[1]].y, positions_[inTile[2]].z};
  }

  void fillBand();
  /// Determines which of the parts are beyond the limit.
  void boundParts(std::span<Part> parts) const;
  /// Determines it from the value at the centre of the part's box.
  void boundByLipschitz(Part& part, const OrientedBox<T>& box, T atCenter) const;
  void fillBeyond(const Part& part) const;
  void addPoints(const Part& part, int bits);

  const FillTask<T>& task_;
  OffsetBox tile_;
  std::array<Vec3<T>, TileOrder::kLongest> positions_;  // coordinates of each offset in the tile
  PointBatch<T> batch_;
};

extern template class TileFill<float>;
extern template class TileFill<double>;

}  // namespace cutwater::detail
