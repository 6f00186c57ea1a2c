#include <Cutwater/Bvh/Detail/BinnedSplits.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutwater::detail {

namespace {

constexpr std::size_t kBins = 16;
constexpr std::size_t kChunk = 16384;

std::size_t chunksOf(const ItemRange& range) {
  return (range.count() + kChunk - 1) / kChunk;
}

float largestExtent(const Bounds4& box) {
  const Floats4 size = box.upper - box.lower;
  return std::max({size[0], size[1], size[2]});
}

/// Scales a box's longest extent to about 1, without intermediate overflow.
struct Frame {
  Vec3<double> scaledCenter;
  double scale;

  explicit Frame(const Box<double>& box) {
    const double extent = maxComponent(0.5 * box.upper - 0.5 * box.lower);
    scale = extent > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(extent), -900, 1022)) : 1;
    scaledCenter = scale * box.center();
  }
  [[nodiscard]] std::array<float, 3> operator()(const Vec3<double>& p) const {
    const Vec3<float> local(scale * p - scaledCenter);
    return {local.x, local.y, local.z};
  }
};

}  // namespace

struct BinnedSplits::Bins {
  struct Bin {
    Bounds4 box;
    std::size_t count = 0;
  };
  std::array<std::array<Bin, kBins>, 3> axes;
};

struct BinnedSplits::Choice {
  float cost = std::numeric_limits<float>::infinity();
  std::size_t smallerHalf = 0;  // items on the side with fewer
  std::size_t axis = 3;
  std::size_t position = 0;  // the first bin on the right

  /// Of equal costs, prefers the more even split: on a line, where boxes have no area, all are
  /// equal.
  [[nodiscard]] bool isBetterThan(const Choice& other) const {
    return cost < other.cost ||
           (cost == other.cost && other.axis != 3 && smallerHalf > other.smallerHalf);
  }
};

/// Assigns items to bins.
class BinnedSplits::Binning {
 public:
  explicit Binning(const Bounds4& middles) : lower_(middles.lower) {
    const Floats4 extent = middles.upper - middles.lower;
    for (int axis = 0; axis < 3; ++axis) {
      scale_[axis] = extent[axis] > 0x1p-100F ? kBins / extent[axis] : 0;  // 0: all in one bin
    }
  }
  [[nodiscard]] Ints4 of(const Bounds4& box) const {
    const Floats4 position = (middle(box) - lower_) * scale_;
    constexpr float kLast = kBins - 1;
    return __builtin_convertvector(least(position, Floats4{kLast, kLast, kLast, 0}), Ints4);
  }

 private:
  Floats4 lower_;
  Floats4 scale_{};
};

BinnedSplits::BinnedSplits(std::span<const Box<double>> boxes, std::uint32_t leafWidth, int threads)
    : boxes_(boxes), leafWidth_(leafWidth), threads_(threads) {
  for (auto& items : items_) items = std::make_unique_for_overwrite<SplitItem[]>(boxes.size());
  forChunks(all(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i) items_[0][i].id = static_cast<std::uint32_t>(i);
  });
}

std::span<SplitItem> BinnedSplits::items(const ItemRange& range) const {
  return {items_[range.inSecond ? 1 : 0].get() + range.begin, range.count()};
}

/// Calls body(chunk, begin, end), in parallel if there are several.
template <typename Body>
void BinnedSplits::forChunks(const ItemRange& range, Body&& body) const {
  const auto call = [&](std::size_t first, std::size_t last) {
    for (auto chunk = first; chunk < last; ++chunk) {
      const auto begin = range.begin + chunk * kChunk;
      body(chunk, begin, std::min(begin + kChunk, range.end));
    }
  };
  const auto chunks = chunksOf(range);
  chunks == 1 ? call(0, 1) : parallelFor(chunks, {.threads = threads_}, call);
}

void BinnedSplits::refine(ItemRange& range) const {
  constexpr float kShrunk = 0x1p-10F;
  if (range.frameExtent > 0 && largestExtent(range.middles) >= kShrunk * range.frameExtent) return;
  auto* const items = items_[range.inSecond ? 1 : 0].get();
  const auto chunks = chunksOf(range);
  std::vector<Box<double>> wholes(chunks);
  forChunks(range, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (auto i = begin; i < end; ++i) wholes[chunk].extend(boxes_[items[i].id]);
  });
  for (const auto& whole : wholes) wholes[0].extend(whole);
  const Frame frame(wholes[0]);
  std::vector<Bounds4> middles(chunks);
  forChunks(range, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Bounds4 sum;
    for (auto i = begin; i < end; ++i) {
      const auto& box = boxes_[items[i].id];
      items[i] = {
          .lower = frame(box.lower), .id = items[i].id, .upper = frame(box.upper), .unused = 0};
      sum.extend(middle(boundsOf(items[i])));
    }
    middles[chunk] = sum;
  });
  range.middles = {};
  for (const auto& part : middles) range.middles.extend(part);
  range.frameExtent = largestExtent(range.middles);
}

auto BinnedSplits::split(const ItemRange& range) const -> std::optional<Halves> {
  const auto* const items = items_[range.inSecond ? 1 : 0].get();
  const Binning binning(range.middles);
  std::vector<Bins> chunks(chunksOf(range));
  forChunks(range, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    auto& axes = chunks[chunk].axes;
    for (auto i = begin; i < end; ++i) {
      const Bounds4 box = boundsOf(items[i]);
      const Ints4 bins = binning.of(box);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        auto& bin = axes[axis][static_cast<std::size_t>(bins[axis])];
        bin.box.extend(box);
        ++bin.count;
      }
    }
  });
  Bins sum;
  for (const auto& chunk : chunks) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t bin = 0; bin < kBins; ++bin) {
        sum.axes[axis][bin].box.extend(chunk.axes[axis][bin].box);
        sum.axes[axis][bin].count += chunk.axes[axis][bin].count;
      }
    }
  }
  const Choice choice = choose(sum);
  if (choice.axis == 3) return std::nullopt;
  return scatter(range, binning, choice, chunks);
}

auto BinnedSplits::choose(const Bins& bins) const -> Choice {
  Choice best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& own = bins.axes[axis];
    std::size_t total = 0;
    for (const auto& bin : own) total += bin.count;
    std::array<float, kBins> rightCost{};
    Bounds4 box;
    std::size_t count = 0;
    for (std::size_t i = kBins - 1; i > 0; --i) {
      box.extend(own[i].box);
      count += own[i].count;
      rightCost[i] =
          count == 0 ? std::numeric_limits<float>::infinity() : splitCost(box, count, leafWidth_);
    }
    box = {};
    count = 0;
    for (std::size_t i = 1; i < kBins; ++i) {
      box.extend(own[i - 1].box);
      count += own[i - 1].count;
      if (count == 0) continue;
      const Choice choice{.cost = splitCost(box, count, leafWidth_) + rightCost[i],
                          .smallerHalf = std::min(count, total - count),
                          .axis = axis,
                          .position = i};
      if (choice.isBetterThan(best)) best = choice;
    }
  }
  return best;
}

/// Stable: items keep their order on each side.
auto BinnedSplits::scatter(const ItemRange& range, const Binning& binning, const Choice& choice,
                           std::span<const Bins> chunks) const -> Halves {
  struct Sides {
    std::array<std::size_t, 2> next{};  // where the next item of each side goes
    std::array<Bounds4, 2> middles;
  };
  std::vector<Sides> sides(chunks.size());
  std::size_t lefts = 0;
  std::size_t rights = 0;
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
    sides[chunk].next = {range.begin + lefts, range.begin + rights};
    const auto& bins = chunks[chunk].axes[choice.axis];
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      (bin < choice.position ? lefts : rights) += bins[bin].count;
    }
  }
  for (auto& side : sides) side.next[1] += lefts;
  const auto* const from = items_[range.inSecond ? 1 : 0].get();
  auto* const to = items_[range.inSecond ? 0 : 1].get();
  forChunks(range, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Sides own = sides[chunk];
    for (auto i = begin; i < end; ++i) {
      const Bounds4 box = boundsOf(from[i]);
      const auto bin = static_cast<std::size_t>(binning.of(box)[choice.axis]);
      const std::size_t side = bin < choice.position ? 0 : 1;
      to[own.next[side]++] = from[i];
      own.middles[side].extend(middle(box));
    }
    sides[chunk] = own;
  });
  const auto middle = range.begin + lefts;
  Halves result{range, range};
  result.left.inSecond = result.right.inSecond = !range.inSecond;
  result.left.end = result.right.begin = middle;
  result.left.middles = result.right.middles = {};
  for (const auto& part : sides) {
    result.left.middles.extend(part.middles[0]);
    result.right.middles.extend(part.middles[1]);
  }
  return result;
}

auto BinnedSplits::halves(const ItemRange& range) const -> Halves {
  const Floats4 size = range.middles.upper - range.middles.lower;
  const std::size_t axis = size[0] >= size[1] && size[0] >= size[2] ? 0
                           : size[1] >= size[2]                     ? 1
                                                                    : 2;
  const auto leaves = (range.count() + leafWidth_ - 1) / leafWidth_;
  const auto left = leaves / 2 * leafWidth_;
  const auto part = items(range);
  const auto before = [axis](const SplitItem& a, const SplitItem& b) {
    const float ca = a.lower[axis] + a.upper[axis];
    const float cb = b.lower[axis] + b.upper[axis];
    return ca != cb ? ca < cb : a.id < b.id;
  };
  std::ranges::nth_element(part, part.begin() + static_cast<std::ptrdiff_t>(left), before);
  Halves result{range, range};
  result.left.end = result.right.begin = range.begin + left;
  for (auto* half : {&result.left, &result.right}) {
    half->middles = {};
    for (const auto& item : items(*half)) half->middles.extend(middle(boundsOf(item)));
  }
  return result;
}

}  // namespace cutwater::detail
