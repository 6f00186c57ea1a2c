#pragma once

#include <Cutwater/Bvh/Detail/BvhTree.hpp>

#include <algorithm>
#include <concepts>
#include <span>

namespace cutwater {

/// Requirements on the primitives of a LinearBVH: a finite bounding box, and a value at a point
/// that is at least the distance to that box wherever the point is outside it. (Any distance or
/// signed distance qualifies.)
template <typename P, typename T>
concept Primitive = std::copyable<P> && requires(const P& primitive, const Vec3<T>& point) {
  { primitive.boundingBox() } -> std::convertible_to<Box<T>>;
  { primitive.distance(point) } -> std::convertible_to<T>;
};

/// A primitive that can test whether a segment crosses it. Where it does, the segment must meet the
/// bounding box, or come within a few roundings of the coordinates of it.
template <typename P, typename T>
concept Crossable = Primitive<P, T> && requires(const P& primitive, const Segment<T>& segment) {
  { primitive.crosses(segment) } -> std::convertible_to<bool>;
};

/// A primitive, and its value at the query point.
template <std::floating_point T>
struct NearestPrimitive {
  std::uint32_t primitive = kNone;  ///< index into primitives(); kNone: none within the limit
  T distance = std::numeric_limits<T>::max();
};

// Visitors that LinearBVH passes to the traversal. Classes, not lambdas: see Inline.hpp.
namespace detail {

/// Orders by value, then by index. Depends on the primitives' type, so that instantiations of
/// algorithms with it are not shared between a user's tree and one of the library's.
template <std::floating_point T, typename P>
struct IsBefore {
  CUTWATER_INLINE bool operator()(const NearestPrimitive<T>& a,
                                  const NearestPrimitive<T>& b) const {
    return a.distance < b.distance || (a.distance == b.distance && a.primitive < b.primitive);
  }
};

/// Keeps the least value; of equal ones, that with the lowest index.
template <std::floating_point T, typename P>
class LeastVisitor {
 public:
  LeastVisitor(std::span<const P> primitives, const Vec3<T>& point, NearestPrimitive<T>& best)
      : primitives_(primitives), point_(point), best_(best) {}

  /// Returns the value that further ones must not exceed.
  CUTWATER_INLINE double operator()(std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const NearestPrimitive<T> candidate{id, static_cast<T>(primitives_[id].distance(point_))};
      if (IsBefore<T, P>()(candidate, best_)) best_ = candidate;
    }
    return static_cast<double>(best_.distance);
  }

 private:
  std::span<const P> primitives_;
  Vec3<T> point_;
  NearestPrimitive<T>& best_;
};

/// The least values so far, in a heap with the greatest on top.
template <std::floating_point T, typename P>
class LeastHeap {
 public:
  LeastHeap(std::span<NearestPrimitive<T>> results, T limit) : results_(results), limit_(limit) {}

  CUTWATER_INLINE void offer(const NearestPrimitive<T>& candidate) {
    if (candidate.distance <= limit_) keep(candidate);
  }
  /// The value that further ones must not exceed.
  [[nodiscard]] CUTWATER_INLINE T limit() const { return limit_; }
  /// Sorts the values, and returns how many there are.
  std::size_t sorted() {
    std::sort_heap(results_.begin(), end(), IsBefore<T, P>());
    return count_;
  }

 private:
  auto end() const { return results_.begin() + static_cast<std::ptrdiff_t>(count_); }

  void keep(const NearestPrimitive<T>& candidate) {
    if (count_ == results_.size()) {
      if (!IsBefore<T, P>()(candidate, results_.front())) return;
      std::pop_heap(results_.begin(), end(), IsBefore<T, P>());
      --count_;
    }
    results_[count_++] = candidate;
    std::push_heap(results_.begin(), end(), IsBefore<T, P>());
    if (count_ == results_.size()) limit_ = results_.front().distance;
  }

  std::span<NearestPrimitive<T>> results_;
  std::size_t count_ = 0;
  T limit_;
};

/// Keeps the least values, as many as there is room for.
template <std::floating_point T, typename P>
class SeveralLeastVisitor {
 public:
  SeveralLeastVisitor(std::span<const P> primitives, const Vec3<T>& point,
                      std::span<NearestPrimitive<T>> results, T limit)
      : primitives_(primitives), point_(point), least_(results, limit) {}

  /// Returns the value that further ones must not exceed.
  CUTWATER_INLINE double operator()(std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      least_.offer({id, static_cast<T>(primitives_[id].distance(point_))});
    }
    return static_cast<double>(least_.limit());
  }
  std::size_t sorted() { return least_.sorted(); }

 private:
  std::span<const P> primitives_;
  Vec3<T> point_;
  LeastHeap<T, P> least_;
};

/// Reports all values up to a radius.
template <std::floating_point T, typename P, typename Visit>
class WithinVisitor {
 public:
  WithinVisitor(std::span<const P> primitives, const Vec3<T>& point, T radius, Visit& visit)
      : primitives_(primitives), point_(point), radius_(radius), visit_(visit) {}

  CUTWATER_INLINE double operator()(std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const NearestPrimitive<T> found{id, static_cast<T>(primitives_[id].distance(point_))};
      if (found.distance <= radius_ && !visit_(found)) return kStopTraversal;
    }
    return static_cast<double>(radius_);
  }

 private:
  std::span<const P> primitives_;
  Vec3<T> point_;
  T radius_;
  Visit& visit_;
};

/// Visits all primitives of a leaf in turn.
template <typename Visit>
class EachVisitor {
 public:
  explicit EachVisitor(Visit& visit) : visit_(visit) {}

  CUTWATER_INLINE double operator()(std::span<const std::uint32_t> slots) const {
    for (const auto id : slots) {
      if (id == kNone) break;
      if (!visit_(id)) return kStopTraversal;
    }
    return 1;
  }

 private:
  Visit& visit_;
};

}  // namespace detail

}  // namespace cutwater
