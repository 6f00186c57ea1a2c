#include <Cutwater/Bvh/Detail/BinaryBvh.hpp>
#include <Cutwater/Bvh/Detail/BinnedSplits.hpp>
#include <Cutwater/Bvh/Detail/SweepSplits.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

constexpr std::size_t kSubtree = 32768;  // a range up to this size is one task

struct Task {
  std::uint32_t node;
  int level;
  ItemRange range;
};

class Builder {
 public:
  Builder(const BinnedSplits& splits, std::uint32_t leafWidth, std::span<std::uint32_t> order)
      : splits_(splits), leafWidth_(leafWidth), order_(order) {}

  /// Splits the ranges of more than `least` items; returns those that remain.
  std::vector<Task> run(const Task& first, std::vector<BinaryNode>& nodes, std::size_t least) {
    std::vector<Task> pending{first};
    std::vector<Task> rest;
    while (!pending.empty()) {
      auto task = pending.back();
      pending.pop_back();
      if (task.range.count() <= least) {
        rest.push_back(task);
      } else if (!isFinished(task, nodes)) {
        const auto [left, right] = split(task);
        const auto node = splitNode(nodes, task.node, static_cast<std::uint32_t>(left.end));
        pending.push_back({node + 1, task.level + 1, right});
        pending.push_back({node, task.level + 1, left});
      }
    }
    return rest;
  }

 private:
  /// Finishes small ranges: as a leaf, or with the whole subtree.
  bool isFinished(Task& task, std::vector<BinaryNode>& nodes) {
    const auto count = task.range.count();
    const auto ids = order_.subspan(task.range.begin, count);
    if (count <= leafWidth_) {
      std::ranges::transform(splits_.items(task.range), ids.begin(), &SplitItem::id);
      return true;
    }
    splits_.refine(task.range);
    if (task.level >= kAreaLevels || count > std::size_t{kSweepLeaves} * leafWidth_) return false;
    SweepSplits(splits_.items(task.range), leafWidth_).run(task.node, nodes, ids);
    return true;
  }

  BinnedSplits::Halves split(const Task& task) const {
    if (task.level < kAreaLevels) {
      if (const auto halves = splits_.split(task.range)) return *halves;
    }
    return splits_.halves(task.range);
  }

  const BinnedSplits& splits_;
  std::uint32_t leafWidth_;
  std::span<std::uint32_t> order_;
};

/// Appends a subtree whose root already exists.
void append(std::vector<BinaryNode>& nodes, std::uint32_t root,
            std::span<const BinaryNode> subtree) {
  const auto shift = static_cast<std::uint32_t>(nodes.size()) - 1;
  const auto shifted = [shift](BinaryNode node) {
    if (!node.isLeaf()) node.left += shift;
    return node;
  };
  nodes[root] = shifted(subtree.front());
  std::ranges::transform(subtree.subspan(1), std::back_inserter(nodes), shifted);
}

void fitBoxes(std::span<const Box<double>> boxes, BinaryBvh& tree, int threads) {
  const auto fitLeaves = [&](std::size_t begin, std::size_t end) {
    for (auto& node : std::span(tree.nodes).subspan(begin, end - begin)) {
      if (!node.isLeaf()) continue;
      for (auto i = node.begin; i < node.end; ++i) node.box.extend(boxes[tree.order[i]]);
    }
  };
  parallelFor(tree.nodes.size(), {.threads = threads, .grain = 1024}, fitLeaves);
  for (auto i = tree.nodes.size(); i-- > 0;) {
    auto& node = tree.nodes[i];
    if (node.isLeaf()) continue;
    node.box = tree.nodes[node.left].box;
    node.box.extend(tree.nodes[node.left + 1].box);
  }
}

}  // namespace

BinaryBvh buildBinaryBvh(std::span<const Box<double>> boxes, std::uint32_t leafWidth, int threads) {
  BinaryBvh tree;
  if (boxes.empty()) return tree;
  tree.order.resize(boxes.size());
  tree.nodes.push_back({.box = {}, .begin = 0, .end = static_cast<std::uint32_t>(boxes.size())});
  const BinnedSplits splits(boxes, leafWidth, threads);
  Builder builder(splits, leafWidth, tree.order);
  const auto tasks = builder.run({0, 0, splits.all()}, tree.nodes, kSubtree);

  // Subtrees are joined in the order of the tasks, whichever threads made them.
  std::vector<std::vector<BinaryNode>> subtrees(tasks.size());
  const auto build = [&](std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i) {
      Task task = tasks[i];
      subtrees[i] = {tree.nodes[task.node]};
      task.node = 0;
      builder.run(task, subtrees[i], 0);
    }
  };
  parallelFor(tasks.size(), {.threads = threads}, build);
  for (std::size_t i = 0; i < tasks.size(); ++i) append(tree.nodes, tasks[i].node, subtrees[i]);
  fitBoxes(boxes, tree, threads);
  return tree;
}

}  // namespace cutwater::detail
