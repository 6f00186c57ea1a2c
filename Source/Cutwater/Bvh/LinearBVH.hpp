#pragma once

#include <Cutwater/Bvh/BvhBuilder.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <concepts>
#include <vector>

namespace cutwater {

/// What a type must offer to be put into a LinearBVH: a finite bounding box, and a value at a point
/// that is at least the distance to that box wherever the point is outside of it. (Any distance or
/// signed distance is.)
template <typename P, typename T>
concept Primitive = std::copyable<P> && requires(const P& primitive, const Vec3<T>& point) {
  { primitive.boundingBox() } -> std::convertible_to<Box<T>>;
  { primitive.distance(point) } -> std::convertible_to<T>;
};

/// A flat K-ary bounding volume hierarchy over primitives of any type.
///
/// Memory: 24 K + 16 bytes a node (rounded to a cache line), about one node for every 10 leaves of
/// 4 primitives, beside the primitives themselves.
template <std::floating_point T, Primitive<T> P, int K = 16>
class LinearBVH {
 public:
  struct Nearest {
    std::uint32_t primitive = kNone;  ///< index into primitives(); kNone: none within the limit
    T distance = std::numeric_limits<T>::max();
  };

  /// @throws Error if a bounding box is empty or not finite; Error(Limit) beyond 2^32 - 2.
  explicit LinearBVH(std::vector<P> primitives);

  /// The primitive with the least value at `point`, the first of them where values tie. Only values
  /// not above `limit` count.
  [[nodiscard]] Nearest nearest(const Vec3<T>& point,
                                T limit = std::numeric_limits<T>::max()) const;

  /// Calls visit(index) for every primitive whose bounding box meets `box`, in no order, until it
  /// answers false.
  template <std::predicate<std::uint32_t> Visit>
  void overlapping(const Box<T>& box, Visit&& visit) const;

  [[nodiscard]] const std::vector<P>& primitives() const { return primitives_; }
  [[nodiscard]] BvhTree<K, 4> tree() const { return arrays_.tree(); }

 private:
  std::vector<P> primitives_;
  BvhArrays<K, 4> arrays_;
  double reach_ = 0;  // of the farthest coordinate
};

template <std::floating_point T, Primitive<T> P, int K>
LinearBVH<T, P, K>::LinearBVH(std::vector<P> primitives) : primitives_(std::move(primitives)) {
  std::vector<Box<double>> boxes;
  boxes.reserve(primitives_.size());
  for (const auto& primitive : primitives_) {
    const Box<T> box = primitive.boundingBox();
    require(!box.empty() && isFinite(box), "LinearBVH: need a finite bounding box",
            Named{"primitive", boxes.size()});
    boxes.push_back({Vec3<double>(box.lower), Vec3<double>(box.upper)});
    reach_ = std::max({reach_, length(boxes.back().lower), length(boxes.back().upper)});
  }
  arrays_ = buildBvh<K, 4>(boxes);
}

template <std::floating_point T, Primitive<T> P, int K>
auto LinearBVH<T, P, K>::nearest(const Vec3<T>& point, T limit) const -> Nearest {
  Nearest best{.primitive = kNone, .distance = limit};
  if (!isFinite(point)) return best;
  // Values are trusted to a few roundings of the coordinates they come from.
  const double error =
      16 * double{std::numeric_limits<T>::epsilon()} * (length(Vec3<double>(point)) + reach_);
  tree().nearest(Vec3<double>(point), limit, error, [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const T value = primitives_[id].distance(point);
      if (value < best.distance || (value == best.distance && id < best.primitive)) {
        best = {id, value};
      }
    }
    return static_cast<double>(best.distance);
  });
  return best;
}

template <std::floating_point T, Primitive<T> P, int K>
template <std::predicate<std::uint32_t> Visit>
void LinearBVH<T, P, K>::overlapping(const Box<T>& box, Visit&& visit) const {
  const Box<double> query{Vec3<double>(box.lower), Vec3<double>(box.upper)};
  if (query.empty()) return;
  tree().overlapping(query, [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const Box<T> own = primitives_[id].boundingBox();
      if (own.overlaps(box) && !visit(id)) return false;
    }
    return true;
  });
}

}  // namespace cutwater
