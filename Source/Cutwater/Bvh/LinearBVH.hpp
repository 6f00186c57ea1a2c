#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Bvh/Detail/PrimitiveVisitors.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <concepts>
#include <span>
#include <vector>

namespace cutwater {

/// A flat K-ary bounding volume hierarchy over primitives of any type.
///
/// All queries use one traversal (see BvhTree) and evaluate the primitives themselves, so results
/// are bit for bit those of testing every primitive. Queries do not allocate. Values and crossings
/// are assumed accurate to 16 eps of the coordinates that they are computed from. Queries at points
/// or along segments that are not finite find nothing. For user-defined primitives, queries are
/// compiled in the user's translation unit: their margins allow for the effects of its compiler
/// flags.
///
/// Memory: 24 K + 60 bytes per node (rounded up to cache lines), with about one node per 10 leaves
/// of 4 primitives, in addition to the primitives themselves.
template <std::floating_point T, Primitive<T> P, int K = 16>
class LinearBVH {
 public:
  using Tree = BvhTree<K, 4>;           ///< with leaves of four primitives
  using Nearest = NearestPrimitive<T>;  ///< result of nearest()

  /// @throws Error if a bounding box is empty or not finite; Error(Limit) beyond 2^32 - 2.
  explicit LinearBVH(std::vector<P> primitives);

  /// Replaces the primitives by ones that have moved, each under its index, and fits the boxes of
  /// the tree to them: see refitBvh(). Much cheaper than building a tree. No other thread may use
  /// the tree during the call. Returns the previous primitives, whose memory can be reused for the
  /// next step:
  ///
  ///     spare = bvh.primitives();  move(spare);  spare = bvh.refit(std::move(spare));
  ///
  /// @throws Error unless there are as many as before, with boxes that are finite and not empty;
  /// the tree is then unchanged.
  std::vector<P> refit(std::vector<P> moved);

  /// The primitive with the least value at `point`; of equal values, the one with the lowest index.
  /// Values above `limit` are ignored.
  [[nodiscard]] Nearest nearest(const Vec3<T>& point,
                                T limit = std::numeric_limits<T>::max()) const;

  /// Finds the primitives with the least values at `point`: as many as `results` has room for,
  /// sorted by value, and by index where values are equal. Values above `limit` are ignored.
  /// Returns how many were found.
  std::size_t nearest(const Vec3<T>& point, std::span<Nearest> results,
                      T limit = std::numeric_limits<T>::max()) const;

  /// Calls visit(Nearest) for every primitive whose value at `point` is at most `radius`, in no
  /// particular order, until it returns false.
  template <std::predicate<const NearestPrimitive<T>&> Visit>
  void within(const Vec3<T>& point, T radius, Visit&& visit) const;

  /// Calls visit(index) for every primitive whose bounding box meets `box`, in no particular order,
  /// until it returns false.
  template <std::predicate<std::uint32_t> Visit>
  void overlapping(const Box<T>& box, Visit&& visit) const;

  /// Calls visit(index) for every primitive whose bounding box the segment meets, and for some that
  /// it misses, roughly in the order in which it meets their boxes, until it returns false.
  template <std::predicate<std::uint32_t> Visit>
  void along(const Segment<T>& segment, Visit&& visit) const;

  /// Whether the segment crosses any of the primitives; stops at the first one found.
  // A template, so that trees over primitives without crosses() can be instantiated explicitly:
  // clang 14 would instantiate a constrained member as well.
  template <Crossable<T> Q = P>
  [[nodiscard]] bool anyHit(const Segment<T>& segment) const;

  /// Calls visit(index) for every primitive that the segment crosses, roughly in the order in which
  /// it meets their boxes, until it returns false.
  template <std::predicate<std::uint32_t> Visit>
  void allHits(const Segment<T>& segment, Visit&& visit) const requires Crossable<P, T>;

  [[nodiscard]] const std::vector<P>& primitives() const { return primitives_; }
  [[nodiscard]] Tree tree() const { return arrays_.tree(); }

 private:
  /// The validated boxes of the primitives, and the distance of their farthest corner from the
  /// origin.
  struct Bounds {
    explicit Bounds(std::span<const P> primitives);
    std::vector<Box<double>> boxes;
    double reach = 0;
  };

  /// Error bound of bounding boxes, and of values at points of this magnitude.
  [[nodiscard]] CUTWATER_INLINE double error(double size) const {
    return 16 * double{std::numeric_limits<T>::epsilon()} * (size + reach_);
  }

  std::vector<P> primitives_;
  BvhArrays<K, 4> arrays_;
  double reach_ = 0;  // of the farthest coordinate
};

template <std::floating_point T, Primitive<T> P, int K>
LinearBVH<T, P, K>::LinearBVH(std::vector<P> primitives) : primitives_(std::move(primitives)) {
  const Bounds bounds(primitives_);
  reach_ = bounds.reach;
  arrays_ = buildBvh<K, 4>(bounds.boxes);
}

template <std::floating_point T, Primitive<T> P, int K>
std::vector<P> LinearBVH<T, P, K>::refit(std::vector<P> moved) {
  require(moved.size() == primitives_.size(), "LinearBVH::refit: need as many primitives as before",
          Named{"before", primitives_.size()}, Named{"now", moved.size()});
  const Bounds bounds(moved);
  refitBvh(arrays_, bounds.boxes);
  reach_ = bounds.reach;
  primitives_.swap(moved);
  return moved;
}

template <std::floating_point T, Primitive<T> P, int K>
LinearBVH<T, P, K>::Bounds::Bounds(std::span<const P> primitives) {
  boxes.reserve(primitives.size());
  for (const auto& primitive : primitives) {
    const Box<T> box = primitive.boundingBox();
    require(!box.empty() && isFinite(box), "LinearBVH: need a finite bounding box",
            Named{"primitive", boxes.size()});
    boxes.push_back({Vec3<double>(box.lower), Vec3<double>(box.upper)});
    reach = std::max({reach, length(boxes.back().lower), length(boxes.back().upper)});
  }
}

template <std::floating_point T, Primitive<T> P, int K>
auto LinearBVH<T, P, K>::nearest(const Vec3<T>& point, T limit) const -> Nearest {
  Nearest best{.primitive = kNone, .distance = limit};
  if (!isFinite(point)) return best;
  const Vec3<double> p(point);
  tree().nearest(p, static_cast<double>(limit), error(length(p)),
                 detail::LeastVisitor<T, P>(primitives_, point, best));
  return best;
}

template <std::floating_point T, Primitive<T> P, int K>
std::size_t LinearBVH<T, P, K>::nearest(const Vec3<T>& point, std::span<Nearest> results,
                                        T limit) const {
  if (results.empty() || !isFinite(point)) return 0;
  detail::SeveralLeastVisitor<T, P> least(primitives_, point, results, limit);
  const Vec3<double> p(point);
  tree().nearest(p, static_cast<double>(limit), error(length(p)), least);
  return least.sorted();
}

template <std::floating_point T, Primitive<T> P, int K>
template <std::predicate<const NearestPrimitive<T>&> Visit>
void LinearBVH<T, P, K>::within(const Vec3<T>& point, T radius, Visit&& visit) const {
  if (!isFinite(point) || std::isnan(radius)) return;
  const Vec3<double> p(point);
  tree().nearest(p, static_cast<double>(radius), error(length(p)),
                 detail::WithinVisitor<T, P, Visit>(primitives_, point, radius, visit));
}

template <std::floating_point T, Primitive<T> P, int K>
template <std::predicate<std::uint32_t> Visit>
void LinearBVH<T, P, K>::overlapping(const Box<T>& box, Visit&& visit) const {
  const Box<double> query{Vec3<double>(box.lower), Vec3<double>(box.upper)};
  if (query.empty()) return;
  tree().overlapping(OrientedBox<double>::of(query), [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const Box<T> own = primitives_[id].boundingBox();
      if (own.overlaps(box) && !visit(id)) return false;
    }
    return true;
  });
}

template <std::floating_point T, Primitive<T> P, int K>
template <std::predicate<std::uint32_t> Visit>
void LinearBVH<T, P, K>::along(const Segment<T>& segment, Visit&& visit) const {
  if (!isFinite(segment.start) || !isFinite(segment.end)) return;
  const Segment<double> whole{Vec3<double>(segment.start), Vec3<double>(segment.end)};
  const double size = std::max(length(whole.start), length(whole.end));
  tree().along(whole, detail::EachVisitor<Visit>(visit), error(size));
}

template <std::floating_point T, Primitive<T> P, int K>
template <Crossable<T> Q>
bool LinearBVH<T, P, K>::anyHit(const Segment<T>& segment) const {
  bool found = false;
  along(segment, [&](std::uint32_t id) {
    found = primitives_[id].crosses(segment);
    return !found;
  });
  return found;
}

template <std::floating_point T, Primitive<T> P, int K>
template <std::predicate<std::uint32_t> Visit>
void LinearBVH<T, P, K>::allHits(const Segment<T>& segment,
                                 Visit&& visit) const requires Crossable<P, T> {
  along(segment, [&](std::uint32_t id) { return !primitives_[id].crosses(segment) || visit(id); });
}

}  // namespace cutwater
