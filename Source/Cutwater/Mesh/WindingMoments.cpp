#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Mesh/WindingMoments.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater {

namespace {

/// Moments of a triangle or of all below a node, about their common centroid.
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

/// Adds moments to those about `sum.center`: the parallel axis theorem.
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

/// Rounded up, and by 2^-16 more: above what all rounding in making and using moments amounts to.
float above(double bound) {
  return std::nextafter(static_cast<float>(bound * (1 + 0x1p-16)),
                        std::numeric_limits<float>::max());
}

template <std::floating_point T>
class MomentsBuilder {
 public:
  MomentsBuilder(std::span<const Vec3<T>> positions,
                 std::span<const std::array<std::uint32_t, 3>> triangles, const WindingTree& tree)
      : positions_(positions), triangles_(triangles), tree_(tree), parts_(tree.nodes().size()) {}

  WindingArrays run() {
    result_.moments.resize(tree_.nodes().size());
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
  /// Calls visit(triangle id) for those in leaves of the node itself.
  template <typename Visit>
  void forTriangles(const Node& node, Visit visit) const {
    forLanes(node.leafMask, [&](int lane) {
      for (const auto id : tree_.leaf(node.leafIndex(lane))) {
        if (id != kNone) visit(id);
      }
    });
  }
  std::array<Vec3<double>, 3> localTriangle(std::uint32_t id) const {
    std::array<Vec3<double>, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<double> corner(positions_[triangles_[id][i]]);
      result[i] = tree_.frame().scale * (corner - tree_.frame().center);
    }
    return result;
  }
  static Box<double> laneBox(const Node& node, int lane) {
    const auto k = static_cast<std::size_t>(lane);
    return {{node.lower[0][k], node.lower[1][k], node.lower[2][k]},
            {node.upper[0][k], node.upper[1][k], node.upper[2][k]}};
  }

  void take(std::size_t n) {
    const Node& node = tree_.nodes()[n];
    children_.clear();
    forTriangles(node, [&](auto id) { children_.push_back(partOf(localTriangle(id))); });
    forLanes(node.nodeMask, [&](int lane) { children_.push_back(parts_[node.nodeIndex(lane)]); });
    Part& part = parts_[n];
    part.center = centroid(node);
    for (const auto& child : children_) accumulate(part, child);
    result_.moments[n] = rounded(node, part);
  }

  Vec3<double> centroid(const Node& node) const {
    Box<double> box;
    forLanes(std::uint32_t{node.nodeMask} | node.leafMask,
             [&](int lane) { box.extend(laneBox(node, lane)); });
    const Vec3<double> middle = box.center();
    Vec3<double> sum;
    double area = 0;
    for (const auto& child : children_) {
      area += child.area;
      sum += child.area * (child.center - middle);
    }
    // Any centre will do. Triangles without area have no centroid.
    return area > 0x1p-900 ? min(max(middle + sum / area, box.lower), box.upper) : middle;
  }

  /// About the centre in single precision.
  WindingMoments rounded(const Node& node, const Part& part) const {
    const auto center = static_cast<Vec3<float>>(part.center);
    Part moved{.area = 0, .center = Vec3<double>(center), .normal = {}, .first = {}, .second = 0};
    accumulate(moved, part);
    const double third = (moved.first[0] + moved.first[1] + moved.first[2]) / 3;
    WindingMoments result{};
    result.center = center;
    // From here down nothing underflows to where WindingNumber's rounding bound would not hold.
    result.radius = above(std::max(radius(node, moved.center), 0x1p-30));
    result.normal = static_cast<Vec3<float>>(moved.normal);
    result.first = {static_cast<float>(moved.first[0] - third),
                    static_cast<float>(moved.first[1] - third), static_cast<float>(moved.first[3]),
                    static_cast<float>(moved.first[4]), static_cast<float>(moved.first[5])};
    result.second = above(moved.second + 0x1p-60 * moved.area);
    result.area = above(moved.area + 0x1p-90);
    return result;
  }

  /// Of a ball about `center` that holds all triangles: through the corners of those in leaves; for
  /// a child node around its own ball or its box.
  double radius(const Node& node, const Vec3<double>& center) const {
    double result = 0;
    forTriangles(node, [&](auto id) {
      for (const auto& corner : localTriangle(id)) {
        result = std::max(result, length(corner - center));
      }
    });
    forLanes(node.nodeMask, [&](int lane) {
      const auto& child = result_.moments[node.nodeIndex(lane)];
      const auto box = laneBox(node, lane);
      const double ball = length(Vec3<double>(child.center) - center) + double{child.radius};
      const double corner = length(max(abs(box.lower - center), abs(box.upper - center)));
      result = std::max(result, std::min(ball, corner));
    });
    return result;
  }

  void takeOpenEdges() {
    auto& edges = result_.openEdges;
    edges = findOpenEdges(triangles_, positions_.size());
    std::vector<std::uint32_t> owner(triangles_.size(), kNone);  // the node whose leaf has it
    for (std::uint32_t n = 0; n < tree_.nodes().size(); ++n) {
      forTriangles(tree_.nodes()[n], [&](auto id) { owner[id] = n; });
    }
    std::ranges::stable_sort(edges, {}, [&](const OpenEdge& e) { return owner[e.triangle]; });

    std::vector<double> lengths(tree_.nodes().size());
    std::size_t end = edges.size();
    for (std::size_t n = tree_.nodes().size(); n-- > 0;) {
      const Node& node = tree_.nodes()[n];
      for (; end > 0 && owner[edges[end - 1].triangle] == n; --end) {
        lengths[n] += localLength(edges[end - 1]);
      }
      forLanes(node.nodeMask, [&](int lane) { lengths[n] += lengths[node.nodeIndex(lane)]; });
      result_.moments[n].firstEdge = static_cast<std::uint32_t>(end);
      result_.moments[n].openLength = lengths[n] > 0 ? above(lengths[n]) : 0.0F;
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
  std::vector<Part> parts_;     // of nodes
  std::vector<Part> children_;  // of the node at hand
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
