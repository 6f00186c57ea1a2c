#pragma once

#include <Cutwater/Grid/Detail/FillTask.hpp>

#include <cmath>
#include <optional>

namespace cutwater::detail {

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

  /// A point whose value is known.
  struct Known {
    Vec3<T> point = {};
    T value = 0;
  };
  /// The points to come are close to this one, and 1-Lipschitz; if there is none, they may not be.
  void begin(const std::optional<Known>& known) {
    if (known.has_value() == known_.has_value() && (!known || known->point == known_->point)) {
      return;
    }
    flush();
    known_ = known;
  }
  /// Stores the value of a point that is known to be beyond the limit.
  void storeBeyond(const Offset& offset, T sign) const {
    storeDistance(offset, std::copysign(task_.limit, sign));
    storeSurfacePoint(offset, nullptr);
  }

 private:
  void storeDistances();
  /// Signed distances; of those beyond the limit, any number beyond it.
  void evaluate(std::span<T> values);
  void evaluateOwnWay(std::span<T> values);
  void storeAll();
  /// Stores the surface points of those within the limit, which takes another query.
  void storeSurfacePoints(std::span<const T> distances);
  void storeDistance(const Offset& offset, T distance) const {
    if (task_.targets.distance.data == nullptr) return;
    const auto [i, j, k] = offset;
    task_.targets.distance.at(i, j, k) =
        std::abs(distance) > task_.limit ? std::copysign(task_.limit, distance) : distance;
  }
  /// What is known of the closest surface point; of none if it is beyond the limit.
  void storeSurfacePoint(const Offset& offset, const SurfacePoint<T>* hit) const {
    const auto [i, j, k] = offset;
    const auto& targets = task_.targets;
    constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
    constexpr Vec3<T> kNowhere{kNaN, kNaN, kNaN};
    if (targets.patch.data != nullptr) {
      targets.patch.at(i, j, k) = hit != nullptr ? hit->owner.patch : kNone;
    }
    if (targets.closestPoint.data != nullptr) {
      targets.closestPoint.at(i, j, k) = hit != nullptr ? hit->point : kNowhere;
    }
    if (targets.normal.data != nullptr) {
      targets.normal.at(i, j, k) = hit != nullptr ? hit->normal : kNowhere;
    }
  }

  const FillTask<T>& task_;
  Scratch<Vec3<T>, kMost> points_;
  Scratch<Offset, kMost> offsets_;
  std::size_t count_ = 0;
  std::optional<Known> known_;
};

extern template class PointBatch<float>;
extern template class PointBatch<double>;

}  // namespace cutwater::detail
