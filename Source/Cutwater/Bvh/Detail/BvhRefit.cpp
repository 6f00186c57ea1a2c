#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Bvh/Detail/NodeBoxes.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>

namespace cutwater {

namespace {

using detail::NodeChild;

/// The primitives that each leaf and each node contains.
template <int K, int W>
class Contents {
 public:
  Contents(const BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, int threads)
      : arrays_(arrays), leaves_(arrays.slots.size() / W), nodes_(arrays.nodes.size()) {
    const ParallelOptions inRanges{.threads = threads, .grain = 1024};
    parallelFor(leaves_.size(), inRanges, [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i) fitLeaf(i, boxes);
    });
    // Breadth first: children come after their parents.
    for (auto n = nodes_.size(); n-- > 0;) fitNode(n);
    for (std::size_t n = 0; n < nodes_.size(); ++n) placeChildren(n);
    order_.resize(nodes_.front().end);
    parallelFor(leaves_.size(), inRanges, [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i) copyIds(i);
    });
  }

  [[nodiscard]] const Box<double>& box() const { return nodes_.front().box; }
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  [[nodiscard]] std::vector<NodeChild> children(std::size_t n) const {
    std::vector<NodeChild> result;
    forChildren(*this, n, [&](const NodeChild& child) { result.push_back(child); });
    return result;
  }

 private:
  /// Children occupy the lanes from the first on.
  template <typename Self, typename Visit>
  static void forChildren(Self& self, std::size_t n, Visit&& visit) {
    const auto& node = self.arrays_.nodes[n];
    const int lanes = std::popcount(node.childMask());
    for (int lane = 0; lane < lanes; ++lane) {
      visit(node.isLeaf(lane) ? self.leaves_[node.leafIndex(lane)]
                              : self.nodes_[node.nodeIndex(lane)]);
    }
  }

  // At first, ranges begin at 0 and only give the number of primitives.
  void fitLeaf(std::size_t i, std::span<const Box<double>> boxes) {
    for (const auto id : arrays_.tree().leaf(static_cast<std::uint32_t>(i))) {
      if (id == kNone) break;
      leaves_[i].box.extend(boxes[id]);
      ++leaves_[i].end;
    }
  }
  void fitNode(std::size_t n) {
    forChildren(*this, n, [&](const NodeChild& child) {
      nodes_[n].box.extend(child.box);
      nodes_[n].end += child.end;
    });
  }
  void placeChildren(std::size_t n) {
    auto at = nodes_[n].begin;
    forChildren(*this, n, [&](NodeChild& child) {
      child.begin = at;
      child.end += at;
      at = child.end;
    });
  }
  void copyIds(std::size_t i) {
    const auto ids = arrays_.tree().leaf(static_cast<std::uint32_t>(i));
    const auto& leaf = leaves_[i];
    for (auto place = leaf.begin; place < leaf.end; ++place)
      order_[place] = ids[place - leaf.begin];
  }

  const BvhArrays<K, W>& arrays_;
  std::vector<NodeChild> leaves_;
  std::vector<NodeChild> nodes_;
  std::vector<std::uint32_t> order_;
};

template <int K, int W>
void refit(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, const BvhCorners* corners,
           int threads) {
  const auto unused = static_cast<std::size_t>(std::ranges::count(arrays.slots, kNone));
  require(boxes.size() == arrays.slots.size() - unused, "refitBvh: need a box for each primitive",
          Named{"boxes", boxes.size()}, Named{"primitives", arrays.slots.size() - unused});
  if (arrays.nodes.empty()) return;
  const Contents<K, W> contents(arrays, boxes, threads);
  arrays.frame = detail::frameOf(contents.box());
  const detail::NodeContents all{
      .order = contents.order(), .boxes = boxes, .corners = corners, .frame = arrays.frame};
  const auto fit = [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) {
      auto& node = arrays.nodes[n];
      detail::NodeBoxes(all, contents.children(n), node.axes).write(node);
    }
  };
  parallelFor(arrays.nodes.size(), {.threads = threads, .grain = 16}, fit);
}

}  // namespace

template <int K, int W>
void refitBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, int threads) {
  refit(arrays, boxes, nullptr, threads);
}

template <int K, int W>
void refitTurnedBvh(BvhArrays<K, W>& arrays, std::span<const Box<double>> boxes, BvhCorners corners,
                    int threads) {
  refit(arrays, boxes, &corners, threads);
}

template void refitBvh(BvhArrays<4, 4>&, std::span<const Box<double>>, int);
template void refitBvh(BvhArrays<8, 4>&, std::span<const Box<double>>, int);
template void refitBvh(BvhArrays<16, 4>&, std::span<const Box<double>>, int);
template void refitBvh(BvhArrays<16, 16>&, std::span<const Box<double>>, int);
template void refitTurnedBvh(BvhArrays<16, 16>&, std::span<const Box<double>>, BvhCorners, int);

}  // namespace cutwater
