#pragma once

// Tests whether anything below a node's children may be within reach of a point. Compiled once per
// instruction set.

#include <Cutwater/Triangles/Search/ChildHulls.hpp>
#include <Cutwater/Triangles/Search/PacketDistance.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

using Node = BvhNode<16>;

// Accessed as plain arrays, to keep out functions of the standard library.
static_assert(sizeof(Node) == 448);
CUTWATER_INLINE inline const float* lowerSide(const Node& node, int axis) {
  return reinterpret_cast<const float*>(&node) + std::ptrdiff_t{16} * axis;
}
CUTWATER_INLINE inline const float* upperSide(const Node& node, int axis) {
  return reinterpret_cast<const float*>(&node) + std::ptrdiff_t{16} * (3 + axis);
}

CUTWATER_INLINE inline const float* axisOf(const Node& node, int i) {
  return &node.center.x + std::ptrdiff_t{3} * (1 + i);
}

// Accessed as plain arrays, like everything compiled per instruction set.
static_assert(sizeof(ChildHulls) == 896);
CUTWATER_INLINE inline const float* thicknessOf(const ChildHulls& hulls) {
  return reinterpret_cast<const float*>(&hulls + 1) - 16;
}

/// Raises keys, squared lower bounds of the distances to a node's children, to those of the
/// children's hulls. `p` is in the node's frame. Returns the lanes up to the limit.
[[gnu::noinline]] inline std::uint32_t raiseToHulls(const ChildHulls& hulls, const Vec3<double>& p,
                                                    float limit, float* keys) {
  const PacketPoint local = relativeTo(hulls.triangles, p);
  // Two differences are off by 1 each, the point's position in the node's frame by much less.
  const Floats errorNearby = broadcast((kErrorNearby + 3) * local.unit);
  const Floats errorElsewhere = broadcast((kError + 3) * local.unit);
  std::uint32_t lanes = 0;
  for (int lane = 0; lane < 16; lane += kFloats) {
    const Floats distance = squareRoot(packedDistances(hulls.triangles, lane, local));
    const auto isNear = isPositive(broadcast(kNearby * local.unit) - distance);
    const Floats error = where(isNear, errorNearby, errorElsewhere);
    const Floats thickness = load(thicknessOf(hulls) + lane);
    const Floats lower = most(distance - thickness - error, broadcast(0.0F));
    const Floats key = most(load(keys + lane), lower * lower);
    store(keys + lane, key);
    lanes |= bits(isAtMost(key, broadcast(limit))) << lane;
  }
  return lanes;
}

/// A point relative to a node in double precision, for cases that single precision cannot resolve.
class NodePoint {
 public:
  /// `p` and `reach` are in the tree's frame, where the tree is about 1 across.
  CUTWATER_INLINE NodePoint(const Node& node, const Vec3<double>& p, double reach)
      : node_(node), reach_(reach), position_(node.toLocal(p)) {
    const Vec3<double> size = abs(p - Vec3<double>(node.center));
    // Error of positions in the node's frame, and of products with unit vectors: less than ten
    // roundings to 2^-53 of coordinates of this size.
    error_ = 0x1p-48 * (1 + size.x + size.y + size.z);
  }

  CUTWATER_INLINE bool reachesBox(int lane) const {
    Vec3<double> gap;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = position_[axis];
      const double under = double{lowerSide(node_, axis)[lane]} - (x + error_);
      const double over = (x - error_) - double{upperSide(node_, axis)[lane]};
      gap[axis] = over > 0 ? over : under > 0 ? -under : 0;
    }
    return !isBeyond(gap, dot(gap, gap));
  }

  /// Tests the offsets from the triangle's plane and edges, one of which leads to its nearest
  /// point; any direction gives a bound.
  CUTWATER_INLINE bool reachesHull(const ChildHulls& hulls, int lane) const {
    const float* const rows = rowsOf(hulls.triangles) + lane;
    const auto three = [rows](int row) __attribute__((always_inline)) {
      const float* const first = rows + std::ptrdiff_t{kWidth} * row;
      return Vec3<double>{double{first[0]}, double{first[kWidth]}, double{first[2 * kWidth]}};
    };
    const Seen seen{position_ - Vec3<double>(hulls.triangles.center) - three(0), three(3), three(6),
                    double{thicknessOf(hulls)[lane]}};
    const Vec3<double> normal = cross(seen.ab, seen.ac);
    return !isBeyondAlong(dot(normal, seen.v) < 0 ? -normal : normal, seen) &&
           !isBeyondAlong(offEdge(seen.v, seen.ab), seen) &&
           !isBeyondAlong(offEdge(seen.v, seen.ac), seen) &&
           !isBeyondAlong(offEdge(seen.v - seen.ab, seen.ac - seen.ab), seen);
  }

 private:
  /// A hull's triangle, and the point relative to its first corner.
  struct Seen {
    Vec3<double> v, ab, ac;
    double thickness;
  };

  CUTWATER_INLINE static Vec3<double> offEdge(const Vec3<double>& v, const Vec3<double>& edge) {
    const double along = dot(v, edge);
    const double whole = dot(edge, edge);
    return v - (along <= 0 ? 0 : along >= whole ? 1 : along / whole) * edge;
  }
  CUTWATER_INLINE bool isBeyondAlong(const Vec3<double>& w, const Seen& seen) const {
    const double toB = dot(w, seen.ab);
    const double toC = dot(w, seen.ac);
    const double farther = toB > toC ? toB : toC;
    const double nearest = dot(w, seen.v) - (farther > 0 ? farther : 0);
    return isBeyond(w, nearest - (seen.thickness + 8 * error_) * squareRoot(dot(w, w)));
  }
  /// Requires w . (y - x) >= s in the node's frame, where y is the point and x any point of the
  /// object. With A the rows of the node's axes, w . (y - x) = (A^T w) . (p - A^-1 x) in the tree's
  /// frame, however the axes are rounded: the object is no nearer than s / |A^T w|.
  CUTWATER_INLINE bool isBeyond(const Vec3<double>& w, double s) const {
    const Vec3<double> inTree = w.x * Vec3<double>(node_.axes[0]) +
                                w.y * Vec3<double>(node_.axes[1]) +
                                w.z * Vec3<double>(node_.axes[2]);
    return s > 0 && s * s > reach_ * reach_ * dot(inTree, inTree) * (1 + 0x1p-40);
  }

  const Node& node_;
  double reach_;
  Vec3<double> position_;
  double error_;
};

}  // namespace

}  // namespace cutwater::CUTWATER_SIMD
