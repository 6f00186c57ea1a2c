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
/// evaluated together. Parts are divided less often if the solid itself finds the points in the
/// band, see signedDistancesWithin().
template <std::floating_point T>
class TileFill {
 public:
  explicit TileFill(const FillTask<T>& task) : task_(task), batch_(task) {}

  void fill(const OffsetBox& tile);
  /// After the last tile.
  void finish() {
    fillBeyond();
    batch_.flush();
  }

 private:
  /// A part of the tile, and what is known about it. It is settled if all of it is beyond the
  /// limit.
  struct Part : TilePart {
    Box<T> box = {};             // around its positions
    T sign = 1;                  // on which side it is beyond: the value at the centre
    Vec3<T> center = {};         // all is beyond within a radius of it;
    T beyondSquared = -1;        // that radius squared, if positive
    std::optional<T> lipschitz;  // of values in the part's box, where known
  };

  void placePositions();
  [[nodiscard]] Vec3<T> position(const Offset& inTile) const {
    return {positions_[inTile[0]].x, positions_[inTile[1]].y, positions_[inTile[2]].z};
  }

  void fillBand();
  /// Determines which of the parts, of 2^bits points, are beyond the limit.
  void settle(std::span<Part> parts, int bits);
  void findBoxes(std::span<Part> parts) const;
  /// By their classes and a room as wide as the limit around them.
  void classifyParts(std::span<Part> parts) const;
  /// Of values in a part's box, where known.
  [[nodiscard]] std::optional<T> lipschitzIn(const Part& part) const;
  /// By values at their centres where there is one.
  void boundParts(std::span<Part> parts) const;
  /// Whether the value at the centre of an earlier tile proves that all of a tile is beyond.
  [[nodiscard]] bool isBeyondByLast(Part& tile) const;
  /// Determines it from the value at the centre of the part's box, or of a box around that in which
  /// its Lipschitz constant holds.
  void boundByLipschitz(Part& part, const OrientedBox<T>& box, T atCenter) const;
  /// Indices beyond the limit on one side.
  struct Beyond {
    OffsetBox indices = {};
    bool isInside = false;
  };
  /// Parts that go on along x are filled together: long rows take a third of the time of short
  /// ones.
  void noteBeyond(const Beyond& part);
  void fillBeyond();
  void addPoints(const Part& part, int bits);

  const FillTask<T>& task_;
  OffsetBox tile_;
  std::array<Vec3<T>, TileOrder::kLongest> positions_;  // coordinates of each offset in the tile
  PointBatch<T> batch_;
  typename PointBatch<T>::Known last_;  // the centre of a tile; 0 if none is of use
  Beyond beyond_;                       // noted, and not yet filled
};

extern template class TileFill<float>;
extern template class TileFill<double>;

}  // namespace cutwater::detail
