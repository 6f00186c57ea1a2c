#include <Cutwater/Grid/Detail/PointBatch.hpp>

namespace cutwater::detail {

template <std::floating_point T>
void PointBatch<T>::flush() {
  if (!takesSurfacePoints(task_.targets) || task_.hasBand()) {
    storeDistances();
  } else {
    storeAll();
  }
  count_ = 0;
}

template <std::floating_point T>
void PointBatch<T>::storeDistances() {
  Scratch<T, kMost> distances;
  const auto values = distances.first(count_);
  evaluate(values);
  for (std::size_t i = 0; i < count_; ++i) storeDistance(offsets_[i], values[i]);
  if (takesSurfacePoints(task_.targets)) storeSurfacePoints(values);
}

template <std::floating_point T>
void PointBatch<T>::evaluate(std::span<T> values) {
  const std::span<const Vec3<T>> points = points_.first(count_);
  if (known_) {
    evaluateOwnWay(values);
  } else {
    task_.solid.signedDistances(points, values, {.threads = 1});
  }
}

/// On the way between two points, values change by no more than its length. So both have one sign
/// if their sizes add up to more. Of a value beyond the limit, the limit is known.
template <std::floating_point T>
void PointBatch<T>::evaluateOwnWay(std::span<T> values) {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const std::span<const Vec3<T>> points = points_.first(count_);
  task_.solid.signedDistancesWithin(points, task_.limit, values);
  const auto knows = [&](const Known& known, const Vec3<T>& point) {
    return length(point - known.point) + 4 * task_.rounding < std::abs(known.value) + task_.limit;
  };
  Known last = *known_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      const T sign = knows(last, points[i])      ? last.value
                     : knows(*known_, points[i]) ? known_->value
                                                 : task_.solid.signedDistance(points[i]);
      values[i] = std::copysign(kInf, sign);
      last = {points[i], std::copysign(task_.limit, sign)};
    } else {
      last = {points[i], values[i]};
    }
  }
}

template <std::floating_point T>
void PointBatch<T>::storeAll() {
  // The closest point also gives the distance.
  Scratch<SurfacePoint<T>, kMost> hits;
  task_.solid.closestPoints(points_.first(count_), hits.first(count_), {.threads = 1});
  for (std::size_t i = 0; i < count_; ++i) {
    storeDistance(offsets_[i], hits[i].distance);
    storeSurfacePoint(offsets_[i], &hits[i]);
  }
}

template <std::floating_point T>
void PointBatch<T>::storeSurfacePoints(std::span<const T> distances) {
  Scratch<Vec3<T>, kMost> within;
  Scratch<Offset, kMost> where;
  std::size_t count = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    if (std::abs(distances[i]) > task_.limit) {
      storeSurfacePoint(offsets_[i], nullptr);
    } else {
      within[count] = points_[i];
      where[count++] = offsets_[i];
    }
  }
  if (count == 0) return;
  Scratch<SurfacePoint<T>, kMost> hits;
  task_.solid.closestPoints(within.first(count), hits.first(count), {.threads = 1});
  for (std::size_t i = 0; i < count; ++i) storeSurfacePoint(where[i], &hits[i]);
}

template class PointBatch<float>;
template class PointBatch<double>;

}  // namespace cutwater::detail
