#pragma once

#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>
#include <Cutwater/Grid/Fill.hpp>

#include <cmath>

namespace cutwater::detail {

/// What one call of fill() asks for, shared by all of its tiles. All that it refers to outlives it.
template <std::floating_point T>
struct FillTask {
  const SignedDistanceFunction<T>& solid;
  const GridPatch<T>& gridPatch;
  const FillTargets<T>& targets;
  T limit;          ///< values beyond it become +-limit; may be infinite
  TileOrder order;  ///< of the points in each tile
  Guarantee<T> promise = solid.guarantee();

  [[nodiscard]] bool hasBand() const { return limit < std::numeric_limits<T>::infinity(); }
};

/// Evaluates points of a grid patch together and stores their values in the targets, each at its
/// point's offset.
template <std::floating_point T>
class PointBatch {
 public:
  /// Small enough that a batch's scratch memory fits the L1 cache.
  static constexpr std::size_t kMost = 256;

  explicit PointBatch(const FillTask<T>& task) : task_(task) {}

  void add(const Vec3<T>& point, const Offset& offset) {
    points_[count_] = point;
    offsets_[count_] = offset;
    if (++count_ == kMost) flush();
  }
  /// Evaluates the points added so far and stores their values.
  void flush();
  /// Stores the value of a point that is known to be beyond the limit.
  void storeBeyond(const Offset& offset, T sign) const {
    storeDistance(offset, std::copysign(task_.limit, sign));
    if (task_.targets.patch.data != nullptr) storePatch(offset, kNone);
  }

 private:
  void storeDistances();
  void storeDistancesAndPatches();
  /// Stores the patches of those within the limit, which takes another query.
  void storePatches(std::span<const T> distances);
  void storeDistance(const Offset& offset, T distance) const {
    if (task_.targets.distance.data == nullptr) return;
    const auto [i, j, k] = offset;
    task_.targets.distance.at(i, j, k) =
        std::abs(distance) > task_.limit ? std::copysign(task_.limit, distance) : distance;
  }
  void storePatch(const Offset& offset, std::uint32_t patch) const {
    const auto [i, j, k] = offset;
    task_.targets.patch.at(i, j, k) = patch;
  }

  const FillTask<T>& task_;
  Scratch<Vec3<T>, kMost> points_;
  Scratch<Offset, kMost> offsets_;
  std::size_t count_ = 0;
};

extern template class PointBatch<float>;
extern template class PointBatch<double>;

}  // namespace cutwater::detail
