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
  task_.solid.signedDistances(points_.first(count_), values, {.threads = 1});
  for (std::size_t i = 0; i < count_; ++i) storeDistance(offsets_[i], values[i]);
  if (takesSurfacePoints(task_.targets)) storeSurfacePoints(values);
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
