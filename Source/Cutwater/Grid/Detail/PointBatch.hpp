#pragma once

#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Grid/Detail/FillTask.hpp>

#include <cmath>

namespace cutwater::detail {

/// Points of a patch that are evaluated together, and the offsets at which to write their values.
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
  /// Evaluates the added points and writes their values.
  void flush();
  /// Writes a value that is known to be beyond the limit.
  void writeBeyond(const Offset& offset, T sign) const {
    writeDistance(offset, std::copysign(task_.limit, sign));
    if (task_.targets.patch.data != nullptr) writeOwner(offset, kNone);
  }

 private:
  void writeDistances();
  void writeWithOwners();
  /// Writes the owners of those within the limit.
  void writeOwners(std::span<const T> distances);
  void writeDistance(const Offset& offset, T distance) const {
    if (task_.targets.distance.data == nullptr) return;
    const auto [i, j, k] = offset;
    task_.targets.distance.at(i, j, k) =
        std::abs(distance) > task_.limit ? std::copysign(task_.limit, distance) : distance;
  }
  void writeOwner(const Offset& offset, std::uint32_t patch) const {
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
