#pragma once

#include <Cutwater/Bvh/Detail/PrimitiveVisitors.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <memory>
#include <vector>

namespace cutwater {

/// A point of a PointCloud by its index, in NearestPrimitive::primitive, and its distance.
template <std::floating_point T>
using Neighbor = NearestPrimitive<T>;

/// The neighbours of many points, one row per point.
template <std::floating_point T>
struct NeighborRows {
  /// Row n is neighbors[offsets[n]] ... neighbors[offsets[n + 1] - 1].
  std::vector<std::size_t> offsets{0};
  std::vector<Neighbor<T>> neighbors;  ///< each row in order

  /// The neighbours of one point.
  [[nodiscard]] std::span<const Neighbor<T>> of(std::size_t row) const {
    return std::span(neighbors).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// A set of points for nearest-neighbour and radius searches.
///
/// Results are bit for bit those of testing every point. Neighbours are sorted by distance
/// (strictly, by its computed square), and by index where these are equal. Queries at one point do
/// not allocate; at points that are not finite, or beyond 2^60 (2^500 in double precision), they
/// find nothing. Copies share the points.
template <std::floating_point T>
class PointCloud {
 public:
  /// @throws Error if a coordinate is not finite or beyond 2^60 (2^500 in double precision);
  /// Error(Limit) beyond 2^32 - 2 points.
  explicit PointCloud(std::span<const Vec3<T>> points);

  [[nodiscard]] std::size_t size() const;

  /// The nearest point, if it is no farther than `limit`; otherwise kNone, and the limit.
  [[nodiscard]] Neighbor<T> nearest(const Vec3<T>& point,
                                    T limit = std::numeric_limits<T>::max()) const;
  /// Finds the nearest points: as many as `results` has room for, and no farther than `limit`.
  /// Returns how many were found.
  std::size_t nearest(const Vec3<T>& point, std::span<Neighbor<T>> results,
                      T limit = std::numeric_limits<T>::max()) const;
  /// Calls visit(neighbor) for all points no farther than `radius`, in no particular order, until
  /// it returns false.
  void within(const Vec3<T>& point, T radius,
              FunctionRef<bool(const Neighbor<T>& neighbor)> visit) const;

  /// Finds the nearest point for each of many points, in parallel. Faster where successive points
  /// are close to each other. @throws Error if the spans differ in size.
  void nearest(std::span<const Vec3<T>> points, std::span<Neighbor<T>> results,
               const ParallelOptions& options = {}) const;
  /// Finds the `count` nearest points for each of many points, in consecutive rows of `count`
  /// entries; kNone where there are fewer. @throws Error unless `results` has exactly that size.
  void nearest(std::span<const Vec3<T>> points, std::size_t count, std::span<Neighbor<T>> results,
               const ParallelOptions& options = {}) const;
  /// Finds all points no farther than `radius` from each of many points.
  [[nodiscard]] NeighborRows<T> within(std::span<const Vec3<T>> points, T radius,
                                       const ParallelOptions& options = {}) const;

 private:
  class Tree;

  std::shared_ptr<const Tree> tree_;
};

extern template class PointCloud<float>;
extern template class PointCloud<double>;

}  // namespace cutwater
