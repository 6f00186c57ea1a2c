#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Triangles/WindingMoments.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater {

namespace {

/// Moments of a triangle, or of all triangles below a node, about their common centroid.
struct Part {
  double area = 0;
  Vec3<double> center;
  Vec3<double> normal;
  std::array<double, 6> first{};  // xx, yy, zz, xy + yx, yz + zy, zx + xz
  double second = 0;
};

Part partOf(const std::array<Vec3<double>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  Part part;
  part.center = (a + b + c) / 3.0;
  part.normal = 0.5 * cross(b - a, c - a);
  part.area = length(part.normal);
  double squares = 0;
  for (const auto& corner : triangle) squares += lengthSquared(corner - part.center);
  part.second = part.area / 12 * squares;
  return part;
}

/// Adds moments to those about `sum.center`, by the parallel axis theorem.
void accumulate(Part& sum, const Part& part) {
  const Vec3<double> d = part.center - sum.center;
  const Vec3<double>& n = part.normal;
  const std::array<double, 6> shift{n.x * d.x,
                                    n.y * d.y,
                                    n.z * d.z,
                                    n.x * d.y + n.y * d.x,
                                    n.y * d.z + n.z * d.y,
                                    n.z * d.x + n.x * d.z};
  for (std::size_t i = 0; i < shift.size(); ++i) sum.first[i] += part.first[i] + shift[i];
  sum.area += part.area;
  sum.normal += n;
  sum.second += part.second + part.area * lengthSquared(d);
}

/// The moments of all parts about their common centroid.
Part combined(std::span<const Part> parts) {
  Part sum;
  Vec3<double> moment;
  for (const auto& part : parts) {
    sum.area += part.area;
    moment += part.area * (part.center - parts.front().center);
  }
  // Any centre will do. Triangles without area have no centroid.
  sum.center = parts.front().center;
  if (sum.area > 0x1p-900) sum.center += moment / sum.area;
  sum.area = 0;
  for (const auto& part : parts) accumulate(sum, part);
  return sum;
}

/// Rounds up, and by 2^-16 more: above all rounding in computing and using moments.
float above(double bound) {
  return std::nextafter(static_cast<float>(bound * (1 + 0x1p-16)),
                        std::numeric_limits<float>::max());
}

/// A lane without triangles, far from everything.
WindingMoments emptyMoments() {
  WindingMoments moments{};
  for (auto& lanes : moments.center) lanes.fill(0x1p30F);
  return moments;
}

void setLane(WindingMoments& moments, std::size_t lane, const Vec3<double>& center, double radius,
             const Part& part) {
  // About the centre as rounded to single precision.
  Part moved;
  moved.center = center;
  accumulate(moved, part);
  const double third = (moved.first[0] + moved.first[1] + moved.first[2]) / 3;
  for (int axis = 0; axis < 3; ++axis) {
    moments.center[static_cast<std::size_t>(axis)][lane] = static_cast<float>(center[axis]);
    moments.normal[static_cast<std::size_t>(axis)][lane] = static_cast<float>(moved.normal[axis]);
  }
  moments.first[0][lane] = static_cast<float>(moved.first[0] - third);
  moments.first[1][lane] = static_cast<float>(moved.first[1] - third);
  for (std::size_t i = 2; i < 5; ++i) {
    moments.first[i][lane] = static_cast<float>(moved.first[i + 1]);
  }
  // Lower limits, so that nothing underflows to where FarField's rounding bound would not hold.
  moments.radius[lane] = above(std::max(radius, 0x1p-30));
  moments.second[lane] = above(moved.second + 0x1p-60 * moved.area);
  moments.area[lane] = above(moved.area + 0x1p-90);
}

template <std::floating_point T>
class MomentsBuilder {
 public:
  MomentsBuilder(std::span<const Vec3<T>> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles, const WindingTree& tree)
      : positions_(positions), triangles_(triangles), tree_(tree), parts_(tree.nodes().size()) {}

  WindingArrays run() {
    result_.moments.resize(tree_.nodes().size(), emptyMoments());
    // The builder appends children after their parents.
    for (std::size_t n = tree_.nodes().size(); n-- > 0;) take(n);
    takeOpenEdges();
    return std::move(result_);
  }

 private:
  using Node = BvhNode<WindingTree::kArity>;

  /// Calls visit(lane) for the set bits.
  template <typename Visit>
  static void forLanes(std::uint32_t mask, Visit visit) {
    for (; mask != 0; mask &= mask - 1) visit(std::countr_zero(mask));
  }
  /// Calls visit(triangle id) for the triangles of a leaf.
  template <typename Visit>
  void forTriangles(const Node& node, int lane, Visit visit) const {
    for (const auto id : tree_.leaf(node.leafIndex(lane))) {
      if (id != kNone) visit(id);
    }
  }
  /// Calls visit(triangle id) for the triangles in leaves of the node itself.
  template <typename Visit>
  void forTriangles(const Node& node, Visit visit) const {
    forLanes(node.leafMask, [&](int lane) { forTriangles(node, lane, visit); });
  }
  std::array<Vec3<double>, 3> localTriangle(std::uint32_t id) const {
    std::array<Vec3<double>, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = tree_.frame().toFrame(Vec3<double>(positions_[triangles_[id][i]]));
    }
    return result;
  }

  void take(std::size_t n) {
    const Node& node = tree_.nodes()[n];
    std::vector<Part> lanes;
    const auto add = [&](int lane, const Part& part, auto radius) {
      // Rounded, as it will be stored.
      const Vec3<double> center(static_cast<Vec3<float>>(part.center));
      setLane(result_.moments[n], static_cast<std::size_t>(lane), center, radius(center), part);
      lanes.push_back(part);
    };
    forLanes(node.leafMask, [&](int lane) {
      std::vector<Part> triangles;
      forTriangles(node, lane, [&](auto id) { triangles.push_back(partOf(localTriangle(id))); });
      add(lane, combined(triangles), [&](const auto& center) {
        double result = 0;
        forTriangles(node, lane, [&](auto id) { result = std::max(result, reach(id, center)); });
        return result;
      });
    });
    forLanes(node.nodeMask, [&](int lane) {
      const auto child = node.nodeIndex(lane);
      add(lane, parts_[child], [&](const auto& center) { return radius(child, center); });
    });
    parts_[n] = combined(lanes);
  }

  /// The distance to the farthest corner of a triangle.
  double reach(std::uint32_t id, const Vec3<double>& center) const {
    double result = 0;
    for (const auto& corner : localTriangle(id)) {
      result = std::max(result, length(corner - center));
    }
    return result;
  }

  /// The radius of a ball about `center` that holds all triangles below a node. It encloses the
  /// corners of triangles in the node's leaves and, for each child node, its ball or its box.
  double radius(std::uint32_t n, const Vec3<double>& center) const {
    const Node& node = tree_.nodes()[n];
    const auto& moments = result_.moments[n];
    double result = 0;
    forTriangles(node, [&](auto id) { result = std::max(result, reach(id, center)); });
    forLanes(node.nodeMask, [&](int lane) {
      const auto k = static_cast<std::size_t>(lane);
      const Vec3<double> own{moments.center[0][k], moments.center[1][k], moments.center[2][k]};
      const auto box = node.alignedBox(lane);
      const double ball = length(own - center) + double{moments.radius[k]};
      const double corner = length(max(abs(box.lower - center), abs(box.upper - center)));
      result = std::max(result, std::min(ball, corner));
    });
    return result;
  }

  void takeOpenEdges() {
    auto& edges = result_.openEdges;
    edges = findOpenEdges(triangles_, positions_.size());
    std::vector<std::uint32_t> owner(triangles_.size(), kNone);  // the node whose leaf contains it
    for (std::uint32_t n = 0; n < tree_.nodes().size(); ++n) {
      forTriangles(tree_.nodes()[n], [&](auto id) { owner[id] = n; });
    }
    std::ranges::stable_sort(edges, {}, [&](const OpenEdge& e) { return owner[e.triangle]; });

    result_.edges.resize(tree_.nodes().size());
    std::vector<double> lengths(tree_.nodes().size());
    std::size_t end = edges.size();
    for (std::size_t n = tree_.nodes().size(); n-- > 0;) {
      const Node& node = tree_.nodes()[n];
      for (; end > 0 && owner[edges[end - 1].triangle] == n; --end) {
        lengths[n] += localLength(edges[end - 1]);
      }
      forLanes(node.nodeMask, [&](int lane) { lengths[n] += lengths[node.nodeIndex(lane)]; });
      result_.edges[n] = {.length = lengths[n] > 0 ? above(lengths[n]) : 0.0F,
                          .first = static_cast<std::uint32_t>(end)};
    }
  }
  double localLength(const OpenEdge& edge) const {
    const Vec3<double> lower(positions_[edge.lower]);
    const Vec3<double> upper(positions_[edge.upper]);
    return std::abs(edge.multiplicity) * tree_.frame().scale * length(upper - lower);
  }

  std::span<const Vec3<T>> positions_;
  std::span<const std::array<std::uint32_t, 3>> triangles_;
  const WindingTree& tree_;
  std::vector<Part> parts_;  // of nodes
  WindingArrays result_;
};

}  // namespace

template <std::floating_point T>
WindingArrays buildWindingMoments(std::span<const Vec3<T>> positions,
                                  std::span<const std::array<std::uint32_t, 3>> triangles,
                                  const WindingTree& tree) {
  return MomentsBuilder<T>(positions, triangles, tree).run();
}

template WindingArrays buildWindingMoments(std::span<const Vec3<float>>,
                                           std::span<const std::array<std::uint32_t, 3>>,
                                           const WindingTree&);
template WindingArrays buildWindingMoments(std::span<const Vec3<double>>,
                                           std::span<const std::array<std::uint32_t, 3>>,
                                           const WindingTree&);

}  // namespace cutwater
