#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Bvh/Detail/NodeBoxes.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using detail::BinaryBvh;
using detail::BinaryNode;

/// Chooses which binary nodes become children of which K-ary node.
///
/// cost(n, i) is the least summed area of K-ary nodes when the subtree of n hangs below its parent
/// in at most i lanes. Either n takes one lane as a node of its own, which costs area(n) and
/// distributes K lanes among its two children; or it dissolves, and its children share the i lanes.
template <int K>
class Collapse {
 public:
  explicit Collapse(const BinaryBvh& tree) : tree_(tree), rows_(tree.nodes.size()) {
    for (std::size_t n = tree.nodes.size(); n-- > 0;) fill(n);  // children before their parents
  }

  /// The binary nodes that become the children of the K-ary node made from `n`.
  std::vector<std::uint32_t> children(std::uint32_t n) const {
    if (tree_.nodes[n].isLeaf()) return {n};  // a tree of one leaf
    std::vector<std::uint32_t> result;
    std::vector<std::pair<std::uint32_t, Share>> pending;
    const auto split = [&](std::uint32_t node, Share share) {
      const auto left = tree_.nodes[node].left;
      pending.emplace_back(left + 1, rows_[left + 1].share[share.right - 1U]);
      pending.emplace_back(left, rows_[left].share[share.left - 1U]);
    };
    split(n, rows_[n].own);
    while (!pending.empty()) {
      const auto [node, share] = pending.back();
      pending.pop_back();
      share.left == 0 ? result.push_back(node) : split(node, share);
    }
    return result;
  }

 private:
  /// Lanes for the left and the right child; 0, 0: the subtree takes one lane undivided.
  struct Share {
    std::uint8_t left = 0;
    std::uint8_t right = 0;
  };
  struct Row {
    std::array<float, K> cost{};   // [i - 1]: in at most i lanes. 0 for leaves: their cost is fixed
    std::array<Share, K> share{};  // how this is achieved
    Share own;                     // division of the K lanes of a node made of this one
  };

  void fill(std::size_t n) {
    const auto& node = tree_.nodes[n];
    if (node.isLeaf()) return;
    auto& row = rows_[n];
    const auto& left = rows_[node.left].cost;
    const auto& right = rows_[node.left + 1].cost;
    const auto bestShare = [&](std::size_t lanes) {
      std::pair<float, Share> best{std::numeric_limits<float>::infinity(), {}};
      for (std::size_t l = 1; l < lanes; ++l) {
        const float cost = left[l - 1] + right[lanes - l - 1];
        if (best.second.left == 0 || cost < best.first) {
          best = {cost, {static_cast<std::uint8_t>(l), static_cast<std::uint8_t>(lanes - l)}};
        }
      }
      return best;
    };
    const auto [inside, own] = bestShare(K);
    row.own = own;
    row.cost[0] = static_cast<float>(detail::halfArea(node.box)) + inside;
    for (std::size_t i = 1; i < K; ++i) {
      const auto [cost, share] = bestShare(i + 1);
      row.cost[i] = std::min(cost, row.cost[i - 1]);
      row.share[i] = cost < row.cost[i - 1] ? share : row.share[i - 1];
    }
  }

  const BinaryBvh& tree_;
  std::vector<Row> rows_;
};

template <int K>
BvhNode<K> emptyNode() {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  BvhNode<K> node;
  for (auto& lanes : node.lower) lanes.fill(kInf);
  for (auto& lanes : node.upper) lanes.fill(-kInf);
  return node;
}

/// A K-ary node, given by the binary nodes that it and its children come from.
struct Source {
  std::uint32_t node;
  int level;  // 1: the root
  std::vector<std::uint32_t> children;
};

/// Lays out the tree, without boxes.
template <int K, int W>
std::vector<Source> layOut(const BinaryBvh& binary, BvhArrays<K, W>& result) {
  const Collapse<K> collapse(binary);
  // Breadth first: the child nodes of a node are appended together, and so are its child leaves.
  std::vector<Source> sources{{.node = 0, .level = 1, .children = {}}};
  result.nodes.push_back(emptyNode<K>());
  for (std::size_t n = 0; n < result.nodes.size(); ++n) {
    auto node = emptyNode<K>();
    node.firstNode = static_cast<std::uint32_t>(result.nodes.size());
    node.firstLeaf = static_cast<std::uint32_t>(result.slots.size() / W);
    std::size_t lane = 0;
    auto children = collapse.children(sources[n].node);
    for (const auto child : children) {
      const auto& from = binary.nodes[child];
      auto& mask = from.isLeaf() ? node.leafMask : node.nodeMask;
      mask = static_cast<std::uint16_t>(mask | 1U << lane++);
      if (from.isLeaf()) {
        const auto first = result.slots.size();
        result.slots.resize(first + W, kNone);
        std::copy(binary.order.begin() + from.begin, binary.order.begin() + from.end,
                  result.slots.begin() + static_cast<std::ptrdiff_t>(first));
      } else {
        sources.push_back({.node = child, .level = sources[n].level + 1, .children = {}});
        result.nodes.push_back(emptyNode<K>());
      }
    }
    sources[n].children = std::move(children);
    result.nodes[n] = node;
  }
  result.depth = sources.back().level;  // breadth first: no node is deeper than the last
  return sources;
}

template <int K, int W>
BvhArrays<K, W> build(std::span<const Box<double>> boxes, const BvhCorners* corners, int threads) {
  static_assert(detail::mostLevels(W) <= BvhTree<K, W>::kMaxDepth);
  if (boxes.size() >= kNone) {
    throw Error(ErrorKind::Limit, "LinearBVH: more than 2^32 - 2 primitives");
  }
  BvhArrays<K, W> result;
  const auto binary = detail::buildBinaryBvh(boxes, W, threads);
  if (binary.nodes.empty()) return result;
  result.frame = detail::frameOf(binary.nodes.front().box);
  const auto sources = layOut(binary, result);
  const detail::NodeContents contents{
      .order = binary.order, .boxes = boxes, .corners = corners, .frame = result.frame};
  const auto fit = [&](std::size_t begin, std::size_t end) {
    std::vector<detail::NodeChild> children;
    for (std::size_t n = begin; n < end; ++n) {
      children.clear();
      for (const auto child : sources[n].children) {
        const auto& from = binary.nodes[child];
        children.push_back({.box = from.box, .begin = from.begin, .end = from.end});
      }
      detail::NodeBoxes(contents, children).write(result.nodes[n]);
    }
  };
  parallelFor(result.nodes.size(), {.threads = threads, .grain = 16}, fit);
  return result;
}

}  // namespace

template <int K, int W>
BvhArrays<K, W> buildBvh(std::span<const Box<double>> boxes, int threads) {
  return build<K, W>(boxes, nullptr, threads);
}

template <int K, int W>
BvhArrays<K, W> buildTurnedBvh(std::span<const Box<double>> boxes, BvhCorners corners,
                               int threads) {
  return build<K, W>(boxes, &corners, threads);
}

template BvhArrays<4, 4> buildBvh(std::span<const Box<double>>, int);
template BvhArrays<8, 4> buildBvh(std::span<const Box<double>>, int);
template BvhArrays<16, 4> buildBvh(std::span<const Box<double>>, int);
template BvhArrays<16, 8> buildBvh(std::span<const Box<double>>, int);
template BvhArrays<16, 16> buildBvh(std::span<const Box<double>>, int);
template BvhArrays<16, 16> buildTurnedBvh(std::span<const Box<double>>, BvhCorners, int);

}  // namespace cutwater
