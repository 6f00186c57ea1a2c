#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>

namespace cutwater::detail {

/// A tree over small primitives, stored in memory in the order of its leaves. A search reads the
/// primitives of a leaf from one place, whereas LinearBVH looks each up by its index.
template <typename P>
class LeafOrder {
 public:
  static constexpr int kWidth = 8;

  LeafOrder(std::span<const P> primitives, std::span<const Box<double>> boxes)
      : arrays_(buildBvh<16, kWidth>(boxes)), inLeaves_(arrays_.slots.size()) {
    for (std::size_t i = 0; i < inLeaves_.size(); ++i) {
      if (arrays_.slots[i] != kNone) inLeaves_[i] = primitives[arrays_.slots[i]];
    }
  }

  /// BvhTree::nearest(), but leaf(primitives, ids) receives the primitives of a leaf, without
  /// unused slots.
  template <typename Leaf>
  void nearest(const Vec3<double>& p, double best, double error, Leaf&& leaf) const {
    arrays_.tree().nearest(p, best, error, [&](std::span<const std::uint32_t> slots) {
      const auto first = static_cast<std::size_t>(slots.data() - arrays_.slots.data());
      std::size_t count = kWidth;
      while (slots[count - 1] == kNone) --count;
      return leaf(std::span(inLeaves_).subspan(first, count), slots.first(count));
    });
  }

  /// Calls visit(primitive) for those in leaves whose boxes meet `box`.
  template <typename Visit>
  void overlapping(const OrientedBox<double>& box, const Visit& visit) const {
    arrays_.tree().overlapping(box, [&](std::span<const std::uint32_t> slots) {
      const auto first = static_cast<std::size_t>(slots.data() - arrays_.slots.data());
      for (std::size_t i = 0; i < kWidth && slots[i] != kNone; ++i) visit(inLeaves_[first + i]);
      return true;
    });
  }

 private:
  BvhArrays<16, kWidth> arrays_;
  std::vector<P> inLeaves_;
};

}  // namespace cutwater::detail
