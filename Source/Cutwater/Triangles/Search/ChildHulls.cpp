#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Triangles/Search/ChildHulls.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace cutwater {

namespace {

using detail::halfArea;
using Node = BvhNode<TriangleTree::kArity>;
using Corners = std::array<Vec3<double>, 3>;

/// A ball that a hull has to enclose.
struct Ball {
  Vec3<double> center;
  double radius = 0;
};

double distanceTo(const Triangle<double>& t, const Vec3<double>& p) {
  if (p == t.a || p == t.b || p == t.c) return 0;
  // The distance to some point of the triangle, however large the rounding of the weights, as for
  // slivers: the triangle is no farther.
  const auto w = max(closestBarycentric(p, t, triangleDistance(p, t).part), {});
  const double sum = w.x + w.y + w.z;
  if (!(sum > 0)) return length(p - t.a);
  return length(w.x * (p - t.a) + w.y * (p - t.b) + w.z * (p - t.c)) / sum;
}

/// The thickness that the triangle needs.
double thicknessAround(const Corners& corners, std::span<const Ball> balls) {
  const Triangle<double> t{corners[0], corners[1], corners[2], false};
  double thickness = 0;
  for (const auto& ball : balls) {
    thickness = std::max(thickness, distanceTo(t, ball.center) + ball.radius);
  }
  // Positions in frames and distances are off by a few 2^-53 of their magnitudes.
  return thickness + 0x1p-46 * (1 + length(t.a));
}

/// The centre of the ball whose centre is farthest by some measure.
template <typename Measure>
Vec3<double> farthest(std::span<const Ball> balls, Measure&& measure) {
  return std::ranges::max_element(balls, {}, [&](const Ball& b) { return measure(b.center); })
      ->center;
}

/// Rotates the corners so that the one opposite the shortest side comes first.
Corners tipFirst(const Corners& t) {
  const double ab = lengthSquared(t[1] - t[0]);
  const double bc = lengthSquared(t[2] - t[1]);
  const double ca = lengthSquared(t[0] - t[2]);
  if (bc <= ab && bc <= ca) return t;
  if (ca <= ab) return {t[1], t[2], t[0]};
  return {t[2], t[0], t[1]};
}

/// Moves the side opposite the tip outward to the last centre, and the plane to the middle of the
/// centres: so an arc's segment is inside, and a curved patch needs half the thickness.
Corners fitted(const Corners& t, std::span<const Ball> balls) {
  const auto& [b, c, a] = t;
  const Vec3<double> normal = normalized(cross(a - b, c - b));
  const Vec3<double> outward = normalized(cross(c - a, normal));
  const double side = dot(outward, a - b);
  double farthest = side;
  double lowest = 0;
  double highest = 0;
  for (const auto& ball : balls) {
    const Vec3<double> v = ball.center - b;
    farthest = std::max(farthest, dot(outward, v));
    lowest = std::min(lowest, dot(normal, v));
    highest = std::max(highest, dot(normal, v));
  }
  const double stretch = side > 0 ? std::min(farthest / side, 2.0) : 1;
  const Vec3<double> tip = b + (0.5 * (lowest + highest)) * normal;
  return {tip + stretch * (a - b), tip, tip + stretch * (c - b)};
}

/// A large triangle around most of the centres.
Corners around(std::span<const Ball> balls) {
  const auto from = [](const Vec3<double>& origin) {
    return [origin](const Vec3<double>& p) { return lengthSquared(p - origin); };
  };
  const auto offLine = [](const Vec3<double>& first, const Vec3<double>& second) {
    return [first, along = second - first](const Vec3<double>& p) {
      return lengthSquared(cross(p - first, along));
    };
  };
  const auto a = farthest(balls, from(balls.front().center));
  auto b = farthest(balls, from(a));
  const auto c = farthest(balls, offLine(a, b));
  // In a fan, all corners but one are equally far from that one: takes the other end of these.
  const auto d = farthest(balls, offLine(b, c));
  b = farthest(balls, offLine(c, d));
  return fitted(tipFirst({b, c, d}), balls);
}

float roundedUp(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

/// Half the surface area of the set of points within `thickness` of the triangle.
double hullArea(const Corners& t, double thickness) {
  const double perimeter = length(t[1] - t[0]) + length(t[2] - t[1]) + length(t[0] - t[2]);
  return 0.5 * length(cross(t[1] - t[0], t[2] - t[0])) +
         std::numbers::pi * thickness * (perimeter / 2 + 2 * thickness);
}

template <std::floating_point T>
class Builder {
 public:
  Builder(std::span<const Vec3<T>> positions,
          std::span<const std::array<std::uint32_t, 3>> triangles, const TriangleTree& tree)
      : positions_(positions),
        triangles_(triangles),
        tree_(tree),
        candidates_(tree.nodes().size()) {}

  HullArrays run() {
    const auto ends = levels();
    for (auto i = ends.size() - 1; i > 0; --i) {  // hulls of a node are made of its children's
      const auto first = ends[i - 1];
      parallelFor(ends[i] - first, {.grain = 64}, [&](std::size_t begin, std::size_t end) {
        for (auto n = first + begin; n < first + end; ++n)
          candidates_[n] = candidateFor(tree_.nodes()[n]);
      });
    }
    HullArrays result;
    for (std::size_t n = 0; n < candidates_.size(); ++n) {
      if (!candidates_[n] || !candidates_[n]->pays) continue;
      if (result.ofNode.empty()) result.ofNode.assign(candidates_.size(), kNone);
      result.ofNode[n] = static_cast<std::uint32_t>(result.hulls.size());
      result.hulls.push_back(candidates_[n]->hulls);
    }
    return result;
  }

 private:
  struct Candidate {
    ChildHulls hulls;
    bool pays = false;
  };

  /// The end of each level in the array of nodes, after a leading 0. Nodes are stored breadth
  /// first.
  std::vector<std::size_t> levels() const {
    std::vector<std::size_t> ends{0};
    for (std::size_t end = tree_.nodes().empty() ? 0 : 1; end > ends.back();) {
      const auto begin = ends.back();
      ends.push_back(end);
      for (auto n = begin; n < ends.back(); ++n) {
        end += static_cast<std::size_t>(std::popcount(tree_.nodes()[n].nodeMask));
      }
    }
    return ends;
  }

  /// Returns nothing if some child does not consist of long triangles.
  std::optional<Candidate> candidateFor(const Node& node) const {
    std::array<std::vector<Ball>, TrianglePacket::kWidth> balls;
    std::array<Corners, TrianglePacket::kWidth> corners;
    const auto count = static_cast<std::size_t>(std::popcount(node.childMask()));
    double boxes = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const int lane = static_cast<int>(k);
      if (!collect(node, lane, balls[k])) return std::nullopt;
      corners[k] = around(balls[k]);
      boxes += halfArea(node.localBox(lane));
    }
    Candidate result{
        {.triangles = packTriangles(std::span(corners).first(count)), .thickness = {}}};
    double areas = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto stored = result.hulls.triangles.corners(k);
      const double thickness = thicknessAround(stored, balls[k]);
      areas += hullArea(stored, thickness);
      result.hulls.thickness[k] = roundedUp(thickness);
    }
    // Testing a hull costs as much as testing a leaf, and the box has to be tested anyway.
    result.pays = areas < 0.5 * boxes;
    return result;
  }

  /// Collects what is below a child, in the node's frame. Returns false where hulls are of no use.
  bool collect(const Node& node, int lane, std::vector<Ball>& balls) const {
    if (node.isLeaf(lane)) return collectLeaf(node, lane, balls);
    const auto n = node.nodeIndex(lane);
    if (!candidates_[n]) return false;
    const auto& below = tree_.nodes()[n];
    const auto& [triangles, thickness] = candidates_[n]->hulls;
    const auto count = static_cast<std::size_t>(std::popcount(below.childMask()));
    for (std::size_t k = 0; k < count; ++k) {
      for (const auto& corner : triangles.corners(k)) {
        const auto place = node.toLocal(toTree(below, corner));
        // The axes are orthonormal up to rounding.
        const double rounding = 0x1p-20 * (length(corner) + length(place));
        balls.push_back({place, thickness[k] * (1 + 0x1p-20) + rounding});
      }
    }
    return true;
  }
  static Vec3<double> toTree(const Node& node, const Vec3<double>& p) {
    return Vec3<double>(node.center) + p.x * Vec3<double>(node.axes[0]) +
           p.y * Vec3<double>(node.axes[1]) + p.z * Vec3<double>(node.axes[2]);
  }
  /// Returns false unless the triangles are about as long as the leaf.
  bool collectLeaf(const Node& node, int lane, std::vector<Ball>& balls) const {
    double longest = 0;
    double count = 0;
    for (const auto id : tree_.leaf(node.leafIndex(lane))) {
      if (id == kNone) break;
      const auto first = balls.size();
      for (const auto v : triangles_[id]) {
        balls.push_back({node.toLocal(tree_.frame().toFrame(Vec3<double>(positions_[v])))});
      }
      const auto t = std::span(balls).subspan(first);
      longest += std::sqrt(std::max({lengthSquared(t[0].center - t[1].center),
                                     lengthSquared(t[1].center - t[2].center),
                                     lengthSquared(t[2].center - t[0].center)}));
      ++count;
    }
    return longest >= 0.5 * count * node.localBox(lane).diagonal();
  }

  std::span<const Vec3<T>> positions_;
  std::span<const std::array<std::uint32_t, 3>> triangles_;
  const TriangleTree& tree_;
  std::vector<std::optional<Candidate>> candidates_;
};

}  // namespace

template <std::floating_point T>
HullArrays buildHulls(std::span<const Vec3<T>> positions,
                      std::span<const std::array<std::uint32_t, 3>> triangles,
                      const TriangleTree& tree) {
  return Builder<T>(positions, triangles, tree).run();
}

template HullArrays buildHulls(std::span<const Vec3<float>>,
                               std::span<const std::array<std::uint32_t, 3>>, const TriangleTree&);
template HullArrays buildHulls(std::span<const Vec3<double>>,
                               std::span<const std::array<std::uint32_t, 3>>, const TriangleTree&);

}  // namespace cutwater
