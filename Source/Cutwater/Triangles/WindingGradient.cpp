#include <Cutwater/Triangles/WindingNumber.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

// Bounds on the gradient of the winding number.

namespace cutwater {

namespace {

Vec3<double> gapBetween(const Box<double>& a, const Box<double>& b) {
  return max(max(a.lower - b.upper, b.lower - a.upper), Vec3<double>{});
}

/// The box in the tree's frame, grown by more than the rounding.
Box<double> toFrame(const Box<double>& box, const BvhFrame& frame) {
  const Vec3<double> lower = frame.toFrame(box.lower);
  const Vec3<double> upper = frame.toFrame(box.upper);
  return Box<double>{lower, upper}.grown(0x1p-50 * maxComponent(max(abs(lower), abs(upper))));
}

}  // namespace

template <std::floating_point T>
std::span<const OpenEdge> WindingNumber<T>::edgesOf(std::size_t node) const {
  const auto begin = edges_[node].first;
  const auto end = node + 1 < moments_.size() ? edges_[node + 1].first : openEdges_.size();
  return openEdges_.subspan(begin, end - begin);
}

/// Bounds the integral of 1 / |x - p|^2 along the edge, for all p in the box. An edge that is long
/// relative to its distance is divided into pieces.
template <std::floating_point T>
double WindingNumber<T>::inverseSquare(const OpenEdge& edge, const Box<double>& box) const {
  constexpr int kPieces = 16;
  const Vec3<double> start(positions_[edge.lower]);
  const Vec3<double> end(positions_[edge.upper]);
  const double edgeLength = length(end - start);
  if (!(edgeLength > 0)) return 0;
  const auto boundFor = [&](int pieces) {
    double result = 0;
    Vec3<double> from = start;
    for (int i = 1; i <= pieces; ++i) {
      const Vec3<double> to = start + (static_cast<double>(i) / pieces) * (end - start);
      const Box<double> piece = Box<double>{min(from, to), max(from, to)}.grown(
          0x1p-50 * maxComponent(max(abs(start), abs(end))));
      result += edgeLength / pieces / lengthSquared(gapBetween(piece, box));
      from = to;
    }
    return result;
  };
  const double whole = boundFor(1);
  return whole * edgeLength < 1 ? whole : boundFor(kPieces);
}

template <std::floating_point T>
double WindingNumber<T>::gradientBound(const Box<double>& box) const {
  if (openEdges_.empty()) return 0;
  const Box<double> local = toFrame(box, tree_.frame());
  // A node that changes the number by less than kMinor between the box's centre and a corner.
  constexpr double kMinor = 0x1p-13;
  const double minor = kMinor / (0.5 * detail::kInverse4Pi * local.diagonal());
  double nearEdges = 0;
  double farEdges = 0;  // in the tree's frame
  const auto keys = [&](const BvhNode<16>& node, BvhNode<16>::Lanes& out) {
    out.fill(kMostKey);
    for (const auto& edge : edgesOf(indexOf(node))) {
      nearEdges += std::abs(edge.multiplicity) * inverseSquare(edge, box);
    }
    for (std::uint32_t rest = node.nodeMask; rest != 0; rest &= rest - 1) {
      const int lane = std::countr_zero(rest);
      const auto k = static_cast<std::size_t>(lane);
      const double openLength{edges_[node.nodeIndex(lane)].length};
      if (!(openLength > 0)) continue;
      const Box<double> child = node.alignedBox(static_cast<int>(k));
      const double gapSquared = lengthSquared(gapBetween(child, local));
      // Opening it would reduce the bound by a factor of at most 4, or by little.
      if (gapSquared > lengthSquared(child.size()) ||
          (gapSquared > 0 && openLength < minor * gapSquared)) {
        farEdges += openLength / gapSquared;
      } else {
        out[k] = 0;
      }
    }
  };
  tree_.traverse(
      keys, [](std::span<const std::uint32_t>) { return 0.0F; }, 0.0F);
  const double bound =
      detail::kInverse4Pi * (1 + 0x1p-30) * (nearEdges + tree_.frame().scale * farEdges);
  return bound < kLargest ? bound : kLargest;
}

template <std::floating_point T>
double WindingNumber<T>::gradientBoundByArea(const Box<double>& box) const {
  const Box<double> local = toFrame(box, tree_.frame());
  double near = 0;
  double far = 0;  // in the tree's frame
  const auto keys = [&](const BvhNode<16>& node, BvhNode<16>::Lanes& out) {
    const auto& areas = moments_[indexOf(node)].area;
    for (std::uint32_t rest = node.nodeMask | node.leafMask; rest != 0; rest &= rest - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(rest));
      const Box<double> child = node.alignedBox(static_cast<int>(k));
      const double gapSquared = lengthSquared(gapBetween(child, local));
      const bool isFar = gapSquared > lengthSquared(child.size());
      out[k] = isFar ? kMostKey : 0.0F;
      if (isFar) far += double{areas[k]} / (gapSquared * std::sqrt(gapSquared));
    }
  };
  const auto leaf = [&](std::span<const std::uint32_t> slots) {
    for (const auto id : slots) {
      if (id == kNone) break;
      const auto [a, b, c] = triangle(id);
      const auto gap = length(gapBetween(Box<double>{}.extend(a).extend(b).extend(c), box));
      near += 0.5 * length(cross(b - a, c - a)) / (gap * gap * gap);
    }
    return near < kLargest ? 0.0F : -1.0F;  // else the box touches a triangle: stop
  };
  tree_.traverse(keys, leaf, 0.0F);
  const double bound = 2 * detail::kInverse4Pi * (1 + 0x1p-30) * (near + tree_.frame().scale * far);
  return bound < kLargest ? bound : kLargest;
}

#define CUTWATER_INSTANTIATE(T)                                                               \
  template std::span<const OpenEdge> WindingNumber<T>::edgesOf(std::size_t) const;            \
  template double WindingNumber<T>::inverseSquare(const OpenEdge&, const Box<double>&) const; \
  template double WindingNumber<T>::gradientBound(const Box<double>&) const;                  \
  template double WindingNumber<T>::gradientBoundByArea(const Box<double>&) const;
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
