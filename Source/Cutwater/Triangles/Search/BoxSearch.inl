// The search of BoxSearch.hpp, compiled once per instruction set.

#include <Cutwater/Triangles/Search/BoxSearch.hpp>
#include <Cutwater/Triangles/Search/PointSearch.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

/// Separation of an interval from [-reach, reach]; negative where they overlap.
CUTWATER_INLINE inline Floats separation(Floats lower, Floats upper, Floats reach) {
  return most(lower, broadcast(0.0F) - upper) - reach;
}

// Separating axes (Gottschalk, Lin and Manocha 1996, "OBBTree"): a triangle and a box that are
// disjoint are separated along an axis of the box, the triangle's normal, or a direction across an
// edge of each. The errors of these separations, relative to the direction's length, are bounded
// below to first order, in units of u R: u = 2^-24, and R is the sum of the packet's radius, the
// distance to its centre and the box's half lengths.
//
// Coordinates of a corner, from the box's centre along its axes: rounding of A, of the centre and
// of their difference, 2; of an axis of the box, 1; of a dot product, 3: 6 for A. An edge's 1 + 4
// for lengths up to 2 R makes 10, and the sum 1: 17 for B and C.
//
// Along the box's axes: 17, plus 3 for the half length, its product and the difference: 20.
//
// Along the normal, of length 1: it is off by 5 on each axis, by 5 sqrt(3) in all; A by 6 sqrt(3);
// the dot product by 3, and the box's reach by 9: 31. (B and C have the same height as A.)
//
// Across an edge, relative to S, the sum of the absolute components of AB and AC: AB and AC are off
// by 5 S in each component, BC by 6 S, and directions, which have two components, by 12 S, hence 12
// R S. In units of R S, corners are off by 17, dot products by 2, reaches by 3, the difference by
// 1: 35. (The edge's own two ends count as one: with an exact direction they would coincide.)
//
// So a triangle separated by more than kAxisError is truly apart. One that no direction separates
// by more than -kAxisError meets a box that is smaller by that much, if there is one: no other
// direction can separate them. QueryBox, in double precision, finds the same wherever `rounding`
// and `depth` are left as margins: where rounding hides a direction from it, the triangle is within
// 2^-26 R of a segment or a point, and the directions of these decide.
constexpr float kAxisError = 40;

/// More than the loss where products underflow.
constexpr float kTiny = 0x1p-100F;

/// Tests whether a box meets triangles, leaf by leaf.
class BoxVisit {
 public:
  CUTWATER_INLINE BoxVisit(const TriangleSearch& tree, const TreeBox& box,
                           const ExactOverlap& exact)
      : tree_(tree),
        box_(box),
        exact_(exact),
        // Rounding of half axes, 1 of the box's size, of their products and sums with a row, 6, and
        // of sums with a coordinate, 2: see BvhNode::toLocalFloat().
        margin_(box.reach + 10 * 0x1p-24F * box.size + kTiny),
        half_{broadcast(box.half.x), broadcast(box.half.y), broadcast(box.half.z)} {
    for (int i = 0; i < 3 && !box.isAligned; ++i) {
      axes_[i] = {broadcast(box.axes[i].x), broadcast(box.axes[i].y), broadcast(box.axes[i].z)};
    }
  }

  /// Starts from a node, or from the one below it that leads to all candidate leaves.
  CUTWATER_INLINE BoxOverlap run(std::uint32_t& start) {
    const Node* first = &tree_.nodes[start];
    std::uint32_t lanes = enter(*first);
    while (lanes != 0 && (lanes & (lanes - 1)) == 0 && (lanes & first->leafMask) == 0) {
      start = first->nodeIndex(__builtin_ctz(lanes));
      first = &tree_.nodes[start];
      lanes = enter(*first);
    }
    path_[0] = {first, lanes};
    return visit();
  }

 private:
  struct Level {
    const Node* node;
    std::uint32_t pending;  // lanes
  };
  /// For each triangle of a packet, a bit: certainly met, and not certainly apart.
  struct Verdict {
    std::uint32_t met = 0;
    std::uint32_t open = 0;
  };

  /// Visits what is on the path.
  CUTWATER_INLINE BoxOverlap visit() {
    auto result = BoxOverlap::None;
    int depth = 1;
    while (depth > 0) {
      Level& level = path_[depth - 1];
      if (level.pending == 0) {
        --depth;
        continue;
      }
      const int lane = __builtin_ctz(level.pending);
      level.pending &= level.pending - 1;
      if (level.node->isLeaf(lane)) {
        const auto found = look(level.node->leafIndex(lane));
        if (found == BoxOverlap::Certain) return found;
        if (found != BoxOverlap::None) result = found;
      } else {
        const Node& node = tree_.nodes[level.node->nodeIndex(lane)];
        path_[depth++] = {&node, enter(node)};
      }
    }
    return result;
  }

  /// The children whose boxes the box may meet, one bit each.
  CUTWATER_INLINE std::uint32_t enter(const Node& node) const {
    const BvhLocalPoint local = node.toLocalFloat(box_.center);
    Floats lower[3];
    Floats upper[3];
    for (int i = 0; i < 3; ++i) {
      const Vec3<float>& row = node.axes[static_cast<std::size_t>(i)];
      const float reach = local.error + margin_ + this->reach(row);
      lower[i] = broadcast(local.position[i] - reach);
      upper[i] = broadcast(local.position[i] + reach);
    }
    std::uint32_t lanes = 0;
    for (int lane = 0; lane < 16; lane += kFloats) {
      Floats gap = broadcast(-kFar);
      for (int i = 0; i < 3; ++i) {
        const Floats under = load(lowerSide(node, i) + lane) - upper[i];
        const Floats over = lower[i] - load(upperSide(node, i) + lane);
        gap = most(gap, most(under, over));
      }
      lanes |= bits(isAtMost(gap, broadcast(0.0F))) << lane;
    }
    return lanes & node.childMask();
  }
  /// The half extent of the box along a direction.
  CUTWATER_INLINE float reach(const Vec3<float>& row) const {
    if (box_.isAligned) return dot(abs(row), box_.half);
    const Vec3<float> along{dot(row, box_.halfAxes[0]), dot(row, box_.halfAxes[1]),
                            dot(row, box_.halfAxes[2])};
    return oneNorm(along);
  }

  CUTWATER_INLINE BoxOverlap look(std::uint32_t leaf) const {
    const TrianglePacket& packet = tree_.packets[leaf];
    Verdict lanes;
    for (int lane = 0; lane < kWidth; lane += kFloats) {
      const Verdict some = look(packet, lane);
      if (some.met != 0) return BoxOverlap::Certain;
      lanes.open |= some.open << lane;
    }
    return lanes.open != 0 ? lookCloser(leaf, lanes.open) : BoxOverlap::None;
  }
  CUTWATER_INLINE Verdict look(const TrianglePacket& packet, int lane) const {
    const Vec3<float> way(box_.center - Vec3<double>(packet.center));
    const float error = kAxisError * 0x1p-24F * (oneNorm(way) + packet.radius + box_.size);
    const float outside = error + box_.rounding;
    // A flat box has no smaller one inside to be met.
    const float inside = box_.leastHalf > error + box_.depth ? error + box_.depth : kFar;

    const PackedTriangle t = seen(packedTriangle(rowsOf(packet), kWidth, lane), way);
    const Floats3 b = t.a + t.ab;
    const Floats3 c = t.a + t.ac;
    const auto along = [&](Floats p, Floats q, Floats r, Floats half)
        __attribute__((always_inline)) {
      return separation(least(least(p, q), r), most(most(p, q), r), half);
    };
    const Floats sides =
        most(most(along(t.a.x, b.x, c.x, half_.x), along(t.a.y, b.y, c.y, half_.y)),
             along(t.a.z, b.z, c.z, half_.z));
    const Floats height = magnitude(fusedDot(t.normal, t.a)) - reachAlong(t.normal);
    const Floats faces = most(sides, height);
    const std::uint32_t near = bits(isAtMost(faces, broadcast(outside)));
    if (near == 0) return {};

    const Floats scale = CUTWATER_SIMD::sizeOf(t.ab) + CUTWATER_SIMD::sizeOf(t.ac);
    Floats edges = acrossEdge(t.ab, t.a, c);
    edges = most(edges, acrossEdge(t.ac, t.a, b));
    edges = most(edges, acrossEdge(t.ac - t.ab, t.a, b));
    const Floats tiny = broadcast(kTiny);
    const std::uint32_t open =
        near & bits(isAtMost(edges, multiplyAdd(broadcast(outside), scale, tiny)));
    const std::uint32_t met = bits(
        both(isAtMost(faces, broadcast(-2 * inside)),
             isPositive(broadcast(0.0F) - multiplyAdd(broadcast(inside), scale, edges + tiny))));
    return {met, open};
  }
  /// The triangle relative to the box's centre, along the box's axes.
  CUTWATER_INLINE PackedTriangle seen(const PackedTriangle& t, const Vec3<float>& way) const {
    const Floats3 a = t.a - Floats3{broadcast(way.x), broadcast(way.y), broadcast(way.z)};
    if (box_.isAligned) return {a, t.ab, t.ac, t.normal};
    return {turned(a), turned(t.ab), turned(t.ac), turned(t.normal)};
  }
  CUTWATER_INLINE Floats3 turned(const Floats3& v) const {
    return {fusedDot(axes_[0], v), fusedDot(axes_[1], v), fusedDot(axes_[2], v)};
  }
  CUTWATER_INLINE Floats reachAlong(const Floats3& direction) const {
    return fusedDot(Floats3{magnitude(direction.x), magnitude(direction.y), magnitude(direction.z)},
                    half_);
  }
  /// The largest separation across the edge and an axis of the box; `p` is one of the edge's ends,
  /// `q` the third corner.
  CUTWATER_INLINE Floats acrossEdge(const Floats3& e, const Floats3& p, const Floats3& q) const {
    const Floats3 size{magnitude(e.x), magnitude(e.y), magnitude(e.z)};
    const auto across =
        [](Floats ex, Floats ey, const Floats3& r, int axis) __attribute__((always_inline)) {
      // (0, -e.z, e.y) . r and its cyclic permutations
      return axis == 0   ? subtractProduct(ex * r.z, ey, r.y)
             : axis == 1 ? subtractProduct(ex * r.x, ey, r.z)
                         : subtractProduct(ex * r.y, ey, r.x);
    };
    const auto along = [&](Floats ex, Floats ey, int axis, Floats reach)
        __attribute__((always_inline)) {
      const Floats atP = across(ex, ey, p, axis);
      const Floats atQ = across(ex, ey, q, axis);
      return separation(least(atP, atQ), most(atP, atQ), reach);
    };
    const Floats x = along(e.y, e.z, 0, multiplyAdd(half_.y, size.z, half_.z * size.y));
    const Floats y = along(e.z, e.x, 1, multiplyAdd(half_.z, size.x, half_.x * size.z));
    const Floats z = along(e.x, e.y, 2, multiplyAdd(half_.x, size.y, half_.y * size.x));
    return most(most(x, y), z);
  }
  /// Tests the triangles that single precision leaves open, in double precision.
  [[gnu::noinline]] BoxOverlap lookCloser(std::uint32_t leaf, std::uint32_t lanes) const {
    auto result = BoxOverlap::None;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(lanes));
      const std::uint32_t id = tree_.slots[leaf * kWidth + lane];
      if (id == kNone) break;
      const auto found = exact_.function(exact_.context, id);
      if (found == BoxOverlap::Certain) return found;
      if (found != BoxOverlap::None) result = found;
    }
    return result;
  }

  const TriangleSearch& tree_;
  const TreeBox& box_;
  const ExactOverlap& exact_;
  float margin_;
  Floats3 half_;
  Floats3 axes_[3];
  Level path_[TriangleTree::kMaxDepth];
};

}  // namespace

BoxOverlap overlapWithTree(const TriangleSearch& tree, const TreeBox& box, std::uint32_t& node,
                           const ExactOverlap& exact) {
  return BoxVisit(tree, box, exact).run(node);
}

}  // namespace cutwater::CUTWATER_SIMD
