#include "SearchEffort.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "Points.hpp"
#include "Seconds.hpp"

#define CUTWATER_SIMD counting
#define CUTWATER_SIMD_PORTABLE
#include <Cutwater/Triangles/Search/PointSearch.inl>

namespace cutwater::benchmarks {

namespace {

using Node = BvhNode<TriangleTree::kArity>;

/// An observer of PointSearch.inl.
class Counter {
 public:
  explicit Counter(Effort& effort) : effort_(&effort) {}

  void onNode() const { ++effort_->opened.nodes; }
  void onLeaf() const { ++effort_->opened.leaves; }
  void onEvaluation(int triangles) const {
    effort_->evaluated += static_cast<std::size_t>(triangles);
  }

 private:
  Effort* effort_;
};

/// Keys for BvhTree::traverse(): 0 for boxes that reach within `reach` of the point, 1 for others.
/// Distances in double precision, rather than in single with a margin as the search has them.
struct WithinReach {
  Vec3<double> point;  // in the tree's frame, as all lengths
  double reach;
  std::size_t& nodes;

  void operator()(const Node& node, Node::Lanes& keys) const {
    ++nodes;
    const Vec3<double> p = node.toLocal(point);
    for (int lane = 0; lane < TriangleTree::kArity; ++lane) {
      const auto box = node.localBox(lane);
      const auto gap = max(max(box.lower - p, p - box.upper), Vec3<double>{});
      keys[static_cast<std::size_t>(lane)] = length(gap) <= reach ? 0 : 1;
    }
  }
};

/// What no search through the tree can leave out: nodes and leaves whose boxes, their parents'
/// included, are not farther from the point than the nearest triangle.
Openings necessary(const TriangleTree& tree, const Vec3<double>& p, double distance) {
  Openings count;
  // In a node's frame lengths are up to 1 + 2^-22 times the true ones: see BvhNode.
  const double reach = distance * tree.frame().scale * (1 + 0x1p-22);
  constexpr float kLimit = 0.5F;  // between the two keys
  tree.traverse(
      WithinReach{tree.frame().toFrame(p), reach, count.nodes},
      [&](std::span<const std::uint32_t>) {
        ++count.leaves;
        return kLimit;
      },
      kLimit);
  return count;
}

}  // namespace

double CountedSearch::ask(const Vec3<double>& p, Effort& effort) const {
  const Openings before = effort.opened;
  auto best = mesh_.surface.nothing(p);
  counting::nearestOne(mesh_.search, KernelTriangles<double>(mesh_.surface), p, best,
                       TriangleSearch::kAnywhere, Counter(effort));
  const double distance = std::sqrt(best.distanceSquared);
  const auto least = necessary(mesh_.arrays.tree(), p, distance);
  if (effort.opened.nodes - before.nodes < least.nodes ||
      effort.opened.leaves - before.leaves < least.leaves) {
    throw std::logic_error("the search opened less than it has to");
  }
  ++effort.queries;
  effort.necessary.nodes += least.nodes;
  effort.necessary.leaves += least.leaves;
  return distance;
}

double leafFetchNanoseconds(std::size_t memoryBytes) {
  const std::vector<TrianglePacket> packets(
      std::max<std::size_t>(1, memoryBytes / sizeof(TrianglePacket)));
  Random random(4);
  std::vector<std::uint32_t> order(1'000'000);
  for (auto& i : order) i = static_cast<std::uint32_t>(random.below(packets.size()));
  constexpr std::size_t kLine = 64;
  volatile std::uint32_t sink = 0;
  const double seconds = bestSecondsOf([&] {
    std::uint32_t all = 0;
    for (const auto i : order) {
      const auto* const bytes = reinterpret_cast<const unsigned char*>(&packets[i]);
      for (std::size_t at = 0; at < sizeof(TrianglePacket); at += kLine) all ^= bytes[at];
    }
    sink = all;
  });
  static_cast<void>(sink);
  return 1e9 * seconds / static_cast<double>(order.size());
}

Effort CountedSearch::ask(std::span<const Vec3<double>> points, std::span<double> distances) const {
  Effort effort;
  const double scale = mesh_.surface.scale;
  for (std::size_t i = 0; i < points.size(); ++i) {
    distances[i] = ask(scale * points[i], effort) / scale;
  }
  return effort;
}

}  // namespace cutwater::benchmarks
