#include <Cutwater/Bvh/BinaryBvh.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace cutwater::detail {

namespace {

constexpr int kBins = 16;
constexpr int kAreaLevels = 32;  // deeper levels halve the range: see BvhTree::kMaxDepth
constexpr std::uint32_t kSweepLeaves = 16;

struct Split {
  double cost = std::numeric_limits<double>::infinity();
  int axis = -1;
  std::uint32_t position = 0;  // bin of the first primitive on the right, or its rank in a sweep
};

class Builder {
 public:
  Builder(std::span<const Box<double>> boxes, std::uint32_t leafWidth)
      : boxes_(boxes), leafWidth_(leafWidth), centers_(boxes.size()) {
    tree_.order.resize(boxes.size());
    std::iota(tree_.order.begin(), tree_.order.end(), 0U);
    std::ranges::transform(boxes, centers_.begin(), [](const auto& b) { return b.center(); });
  }

  BinaryBvh run() {
    struct Task {
      std::uint32_t node;
      int level;
    };
    std::vector<Task> tasks;
    addNode(0, static_cast<std::uint32_t>(boxes_.size()));
    tasks.push_back({0, 0});
    while (!tasks.empty()) {
      const auto [index, level] = tasks.back();
      tasks.pop_back();
      const auto begin = tree_.nodes[index].begin;
      const auto end = tree_.nodes[index].end;
      if (end - begin <= leafWidth_) continue;
      const auto middle = partition(begin, end, level);
      const auto left = static_cast<std::uint32_t>(tree_.nodes.size());
      tree_.nodes[index].left = left;
      addNode(begin, middle);
      addNode(middle, end);
      tasks.push_back({left + 1, level + 1});
      tasks.push_back({left, level + 1});
    }
    return std::move(tree_);
  }

 private:
  auto range(std::uint32_t begin, std::uint32_t end) {
    return std::span(tree_.order).subspan(begin, end - begin);
  }
  void addNode(std::uint32_t begin, std::uint32_t end) {
    BinaryNode node{.box = {}, .begin = begin, .end = end};
    for (const auto id : range(begin, end)) node.box.extend(boxes_[id]);
    tree_.nodes.push_back(node);
  }
  double cost(const Box<double>& box, std::size_t count) const {
    const std::size_t leaves = (count + leafWidth_ - 1) / leafWidth_;
    return halfArea(box) * static_cast<double>(leaves);
  }

  auto byCenter(int axis) const {
    return [this, axis](std::uint32_t a, std::uint32_t b) {
      const double ca = centers_[a][axis];
      const double cb = centers_[b][axis];
      return ca != cb ? ca < cb : a < b;  // by id: the order does not depend on the algorithm
    };
  }

  /// Orders the range into two parts and returns where the second begins.
  std::uint32_t partition(std::uint32_t begin, std::uint32_t end, int level) {
    if (level < kAreaLevels) {
      if (end - begin <= kSweepLeaves * leafWidth_) return sweptPartition(begin, end);
      if (const auto middle = binnedPartition(begin, end); middle != begin) return middle;
    }
    return halves(begin, end);
  }

  std::uint32_t halves(std::uint32_t begin, std::uint32_t end) {
    Box<double> spread;
    for (const auto id : range(begin, end)) spread.extend(centers_[id]);
    const auto size = spread.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    // A multiple of the leaf width keeps leaves full.
    const auto leaves = (end - begin + leafWidth_ - 1) / leafWidth_;
    const auto middle = begin + (leaves / 2) * leafWidth_;
    const auto part = range(begin, end);
    std::nth_element(part.begin(), part.begin() + (middle - begin), part.end(), byCenter(axis));
    return middle;
  }

  /// The best of all splits into full leaves, along each axis.
  std::uint32_t sweptPartition(std::uint32_t begin, std::uint32_t end) {
    const auto part = range(begin, end);
    Split best;
    std::vector<double> rightCost(part.size());
    for (int axis = 0; axis < 3; ++axis) {
      std::ranges::sort(part, byCenter(axis));
      Box<double> box;
      for (auto i = part.size() - 1; i > 0; --i) {
        box.extend(boxes_[part[i]]);
        rightCost[i] = cost(box, part.size() - i);
      }
      box = {};
      for (std::size_t i = 1; i < part.size(); ++i) {
        box.extend(boxes_[part[i - 1]]);
        if (i % leafWidth_ != 0) continue;
        const double total = cost(box, i) + rightCost[i];
        if (total < best.cost) best = {total, axis, static_cast<std::uint32_t>(i)};
      }
    }
    if (best.axis < 0) return halves(begin, end);  // costs are not finite
    if (best.axis != 2) std::ranges::sort(part, byCenter(best.axis));
    return begin + best.position;
  }

  /// Splits at a bin boundary; returns `begin` if all centres fall into one bin.
  std::uint32_t binnedPartition(std::uint32_t begin, std::uint32_t end) {
    const auto part = range(begin, end);
    Box<double> spread;
    for (const auto id : part) spread.extend(centers_[id]);
    const auto binOf = [&](std::uint32_t id, int axis) {
      const double position =
          (centers_[id][axis] - spread.lower[axis]) / (spread.upper[axis] - spread.lower[axis]);
      return std::min(kBins - 1, static_cast<int>(position * kBins));
    };
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = spread.upper[axis] - spread.lower[axis];
      if (!(extent > 0) || !std::isfinite(kBins / extent)) continue;
      std::array<Box<double>, kBins> box;
      std::array<std::size_t, kBins> count{};
      for (const auto id : part) {
        const auto bin = static_cast<std::size_t>(binOf(id, axis));
        box[bin].extend(boxes_[id]);
        ++count[bin];
      }
      if (const auto split = bestBin(box, count); split.cost < best.cost) {
        best = {split.cost, axis, split.position};
      }
    }
    if (best.axis < 0) return begin;
    // Stable: the order within each side stays that of the parent, whatever the library.
    const auto right = std::stable_partition(part.begin(), part.end(), [&](std::uint32_t id) {
      return binOf(id, best.axis) < static_cast<int>(best.position);
    });
    return begin + static_cast<std::uint32_t>(right - part.begin());
  }

  Split bestBin(const std::array<Box<double>, kBins>& box,
                const std::array<std::size_t, kBins>& count) const {
    std::array<double, kBins> rightCost{};
    Box<double> sum;
    std::size_t n = 0;
    for (std::size_t i = kBins - 1; i > 0; --i) {
      sum.extend(box[i]);
      n += count[i];
      rightCost[i] = n == 0 ? std::numeric_limits<double>::infinity() : cost(sum, n);
    }
    Split best;
    sum = {};
    n = 0;
    for (std::size_t i = 1; i < kBins; ++i) {
      sum.extend(box[i - 1]);
      n += count[i - 1];
      if (n == 0) continue;
      const double total = cost(sum, n) + rightCost[i];
      if (total < best.cost) best = {total, 0, static_cast<std::uint32_t>(i)};
    }
    return best;
  }

  std::span<const Box<double>> boxes_;
  std::uint32_t leafWidth_;
  std::vector<Vec3<double>> centers_;
  BinaryBvh tree_;
};

}  // namespace

BinaryBvh buildBinaryBvh(std::span<const Box<double>> boxes, std::uint32_t leafWidth) {
  if (boxes.empty()) return {};
  return Builder(boxes, leafWidth).run();
}

}  // namespace cutwater::detail
