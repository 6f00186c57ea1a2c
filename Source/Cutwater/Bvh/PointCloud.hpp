#pragma once

#include <Cutwater/Bvh/PrimitiveVisitors.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <memory>
#include <vector>

namespace cutwater {

/// A point of a PointCloud by its index, in NearestPrimitive::primitive, and its distance.
template <std::floating_point T>
using Neighbor = NearestPrimitive<T>;

/// The neighbors of many points, row after row.
template <std::floating_point T>
struct NeighborRows {
  /// Row n is neighbors[offsets[n]] ... neighbors[offsets[n + 1] - 1].
  std::vector<std::size_t> offsets{0};
  std::vector<Neighbor<T>> neighbors;  ///< of a row, in order

  /// The neighbors of one point.
  [[nodiscard]] std::span<const Neighbor<T>> of(std::size_t row) const {
    return std::span(neighbors).subspan(offsets[row], offsets[row + 1] - offsets[row]);
  }
};

/// Points in space, to be found by their distance.
///
/// Answers are those of trying all, to the bit. Neighbors are in the order of their distances, or
/// rather of their squares as computed, and those that tie in the order of their indices. Queries
/// at one point do not allocate; at points that are not finite, or beyond 2^60 (2^500 in double
/// precision), they find nothing. Copies share the points.
template <std::floating_point T>
class PointCloud {
 public:
  /// @throws Error if a coordinate is not finite or beyond 2^60 (2^500 in double precision);
  /// Error(Limit) beyond 2^32 - 2 points.
  explicit PointCloud(std::span<const Vec3<T>> points);

  [[nodiscard]] std::size_t size() const;

  /// The nearest one, if it is no farther than `limit`; otherwise kNone, and the limit.
  [[nodiscard]] Neighbor<T> nearest(const Vec3<T>& point,
                                    T limit = std::numeric_limits<T>::max()) const;
  /// As many as `results` has room for, and no farther than `limit`. Returns how many there are.
  std::size_t nearest(const Vec3<T>& point, std::span<Neighbor<T>> results,
                      T limit = std::numeric_limits<T>::max()) const;
  /// Calls visit(neighbor) for all that are no farther than `radius`, in no order, until it answers
  /// false.
  void within(const Vec3<T>& point, T radius,
              FunctionRef<bool(const Neighbor<T>& neighbor)> visit) const;

  /// The nearest of many points, in parallel. Faster where points that follow each other are near.
  /// @throws Error if the spans differ in size.
  void nearest(std::span<const Vec3<T>> points, std::span<Neighbor<T>> results,
               const ParallelOptions& options = {}) const;
  /// The `count` nearest of each of many points, one row of as many after the other; kNone where
  /// there are fewer. @throws Error unless results has room for just these.
  void nearest(std::span<const Vec3<T>> points, std::size_t count, std::span<Neighbor<T>> results,
               const ParallelOptions& options = {}) const;
  /// All no farther than `radius`, of many points.
  [[nodiscard]] NeighborRows<T> within(std::span<const Vec3<T>> points, T radius,
                                       const ParallelOptions& options = {}) const;

 private:
  class Tree;

  std::shared_ptr<const Tree> tree_;
};

extern template class PointCloud<float>;
extern template class PointCloud<double>;

}  // namespace cutwater
