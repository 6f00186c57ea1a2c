#include <Cutwater/Bvh/Detail/NodeBoxes.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/Detail/GeometryCheck.hpp>
#include <Cutwater/Mesh/Detail/SignCells.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

namespace cutwater::detail {

namespace {

using CornerIds = std::array<std::uint32_t, 3>;

/// Bound on coordinates in scaled units, which are below 4 initially (see normalizingScale()). Sums
/// and products of numbers this small do not overflow in the exact predicates.
constexpr double kFarthest = 8;

/// Whether check(element) holds for all elements; runs in parallel.
template <typename Record, typename Check>
bool all(std::span<const Record> records, int threads, Check check) {
  std::atomic<bool> result{true};
  parallelFor(records.size(), {.threads = threads, .grain = std::size_t{1} << 16U},
              [&](std::size_t begin, std::size_t end) {
                bool holds = true;  // no early exit: loops without one are vectorised
                for (std::size_t i = begin; i < end; ++i) holds &= check(records[i]);
                if (!holds) result = false;
              });
  return result;
}

bool haveCorners(std::span<const CornerIds> triangles, std::size_t vertices, int threads) {
  return all(triangles, threads, [&](const CornerIds& t) {
    return std::max({t[0], t[1], t[2]}) < vertices;
  });
}

bool isFrame(const BvhFrame& frame) {
  return isFinite(frame.center) && std::isfinite(frame.scale) && frame.scale > 0;
}

template <int K, int W>
bool canHave(const BvhTree<K, W>& /*tree*/, int depth) {
  return 0 <= depth && depth <= BvhTree<K, W>::kMaxDepth;
}

/// Checks the builder's breadth-first layout: every node but the root is the child of an earlier
/// node, and every leaf the child of exactly one.
template <int K, int W>
void checkTree(const BvhTree<K, W>& tree) {
  const auto nodes = tree.nodes();
  std::uint64_t nodesSeen = nodes.empty() ? 0 : 1;
  std::uint64_t leavesSeen = 0;
  std::uint64_t levelEnd = 0;
  int depth = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto& node = nodes[n];
    if (n == levelEnd) {
      ++depth;
      levelEnd = nodesSeen;
    }
    requireIntact(n < nodesSeen && (node.nodeMask & node.leafMask) == 0 &&
                      node.firstNode == nodesSeen && node.firstLeaf == leavesSeen,
                  "a tree's node does not follow the ones before it");
    nodesSeen += static_cast<unsigned>(std::popcount(node.nodeMask));
    leavesSeen += static_cast<unsigned>(std::popcount(node.leafMask));
  }
  requireIntact(nodesSeen == nodes.size() && leavesSeen * W == tree.slots().size(),
                "a tree has more or fewer nodes or leaves than its nodes tell");
  requireIntact(depth == tree.depth(), "a tree is not as deep as the header tells");
}

/// Checks that each leaf holds ids of triangles, at least one, followed only by kNone.
template <int W>
void checkLeaves(std::span<const std::uint32_t> slots, std::size_t triangles, int threads) {
  std::atomic<bool> isSound{true};
  std::atomic<std::size_t> ids{0};
  parallelFor(slots.size() / W, {.threads = threads, .grain = 4096},
              [&](std::size_t begin, std::size_t end) {
                std::size_t found = 0;
                bool holds = true;
                for (std::size_t leaf = begin; leaf < end; ++leaf) {
                  bool isId = true;
                  for (const auto id : slots.subspan(leaf * W, W)) {
                    holds &= id == kNone || (isId && id < triangles);
                    isId = id != kNone;
                    found += isId ? 1 : 0;
                  }
                  holds &= slots[leaf * W] != kNone;
                }
                if (!holds) isSound = false;
                ids += found;
              });
  requireIntact(isSound, "a leaf holds what is no triangle");
  requireIntact(ids == triangles, "not every triangle is in one leaf");
}

template <std::floating_point T>
void checkSurface(const TriangleSurface<T>& surface, std::uint64_t patches, int threads) {
  const auto vertices = surface.positions.size();
  const auto triangles = static_cast<std::uint32_t>(surface.triangles.size());
  requireIntact(haveCorners(surface.triangles, vertices, threads),
                "a triangle's corner is no vertex");
  const auto isNear = [&](const Vec3<T>& p) { return length(p) <= surface.size; };
  // Points of no triangle may be anywhere, but seldom are.
  requireIntact(all(surface.positions, threads, isNear) ||
                    all(surface.triangles, threads,
                        [&](const CornerIds& t) {
                          const auto& at = surface.positions;
                          return isNear(at[t[0]]) && isNear(at[t[1]]) && isNear(at[t[2]]);
                        }),
                "a position is farther from the origin than the header tells");
  requireIntact(all(surface.neighbours, threads,
                    [&](const CornerIds& t) {  // kNone + 1 is 0
                      return std::max({t[0] + 1, t[1] + 1, t[2] + 1}) <= triangles;
                    }),
                "a triangle's neighbour is no triangle");
  requireIntact(
      all(surface.polygons, threads, [&](std::uint32_t id) { return id < surface.patches.size(); }),
      "a triangle is part of no polygon");
  requireIntact(all(surface.patches, threads, [&](std::uint32_t id) { return id < patches; }),
                "a polygon's patch is none");
}

void checkWinding(const CappedWindingArrays::Sections& sections, const Block& block, int threads) {
  const auto vertices = sections.positions.count;
  requireIntact(all(block.array<Vec3<double>>(sections.positions), threads,
                    [](const Vec3<double>& p) { return length(p) <= kFarthest; }),
                "a cap's position is farther from the origin than can be");
  requireIntact(haveCorners(block.array<CornerIds>(sections.triangles), vertices, threads),
                "a cap's corner is no vertex");
  const auto tree = sections.tree(block);
  checkTree(tree);
  checkLeaves<WindingTree::kLeafWidth>(tree.slots(), sections.triangles.count, threads);
  const auto openEdges = block.array<OpenEdge>(sections.openEdges);
  requireIntact(all(openEdges, threads,
                    [&](const OpenEdge& e) { return std::max(e.lower, e.upper) < vertices; }),
                "an open edge's end is no vertex");
  const auto edges = block.array<WindingEdges>(sections.edges);
  const bool isSorted = std::ranges::is_sorted(edges, {}, &WindingEdges::first);
  requireIntact(isSorted && (edges.empty() || edges.back().first <= openEdges.size()),
                "a node's open edges are none");
}

}  // namespace

void failDamaged(const char* what) {
  throw Error(ErrorKind::File, std::string("the geometry file is damaged: ") + what);
}

template <std::floating_point T>
void checkLayout(const MeshLayout<T>& layout) {
  const auto& surface = layout.surface;
  const auto& winding = layout.winding;
  const auto triangles = surface.triangles.count;
  int exponent = 0;
  requireIntact(std::isfinite(surface.scale) && std::frexp(surface.scale, &exponent) == T(0.5),
                "its scale is no power of two");
  const auto& box = surface.box;
  requireIntact(surface.size <= kFarthest && !box.empty() && length(box.lower) <= kFarthest &&
                    length(box.upper) <= kFarthest && std::isfinite(layout.reach) &&
                    layout.reach >= 0,
                "its extent is larger than can be");
  const auto frame = frameOf(surface.box);
  requireIntact(layout.frame.center == frame.center && layout.frame.scale == frame.scale &&
                    isFrame(winding.frame),
                "the frame of a tree is none");
  requireIntact(canHave(TriangleTree(), layout.depth) && canHave(WindingTree(), winding.depth),
                "a tree is deeper than can be");
  requireIntact(0 < triangles && triangles < kNone && surface.positions.count < kNone &&
                    surface.patches.count < kNone && winding.triangles.count < kNone,
                "it has no triangles, or too many");
  requireIntact(
      surface.neighbours.count == triangles && surface.polygons.count == triangles &&
          surface.slivers.count == (triangles + 31) / 32 &&
          surface.pseudonormals.count == surface.positions.count &&
          layout.slots.count == TriangleTree::kLeafWidth * layout.packets.count &&
          (layout.hullsOfNode.count == 0 || layout.hullsOfNode.count == layout.nodes.count) &&
          winding.slots.count % WindingTree::kLeafWidth == 0 &&
          winding.moments.count == winding.nodes.count &&
          winding.edges.count == winding.nodes.count &&
          (layout.fronts.count == 0 || layout.fronts.count == triangles) &&
          (layout.signCells.count == 0 ||
           layout.signCells.count == SignCells(surface.box, triangles, {}).size()),
      "arrays that belong together are not of one length");
}

template <std::floating_point T>
void checkArrays(const MeshLayout<T>& layout, const Block& block, std::uint64_t patches,
                 int threads) {
  const auto names = block.array<char>(layout.patchNames);
  requireIntact(names.empty() || names.back() == '\0', "the last patch name has no end");
  checkSurface(layout.surface.view(block), patches, threads);
  const auto tree = layout.tree(block);
  checkTree(tree);
  checkLeaves<TriangleTree::kLeafWidth>(tree.slots(), layout.surface.triangles.count, threads);
  requireIntact(all(block.array<std::uint32_t>(layout.hullsOfNode), threads,
                    [&](std::uint32_t i) { return i == kNone || i < layout.hulls.count; }),
                "a node's hulls are none");
  checkWinding(layout.winding, block, threads);
}

template void checkLayout(const MeshLayout<float>&);
template void checkLayout(const MeshLayout<double>&);
template void checkArrays(const MeshLayout<float>&, const Block&, std::uint64_t, int);
template void checkArrays(const MeshLayout<double>&, const Block&, std::uint64_t, int);

}  // namespace cutwater::detail
