#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Detail/InterleavedBits.hpp>
#include <Cutwater/Core/Detail/SpatialOrder.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <algorithm>
#include <limits>
#include <new>

namespace cutwater::detail {

namespace {

/// Cubic cells along the Z-order, 2^bits of them along the longest side of a box.
template <std::floating_point T>
class Cells {
 public:
  /// At most this many bits: more cells would take longer to count than their points to sort.
  static constexpr int kMostBits = 7;

  Cells(const Box<T>& box, std::size_t wanted) : lower_(box.lower), size_(box.size()) {
    const T longest = maxComponent(size_);
    if (!(longest > 0)) return;
    for (bits_ = 0; bits_ < kMostBits && inBlock(longest) < static_cast<double>(wanted);) {
      perLength_ = static_cast<T>(1 << ++bits_) / longest;
    }
  }

  /// How many cells of the box are in a block of it with this side.
  [[nodiscard]] double inBlock(T side) const {
    double count = 1;
    for (int axis = 0; axis < 3; ++axis) {
      count *= std::max(1.0, static_cast<double>(std::min(side, size_[axis]) * perLength_));
    }
    return count;
  }
  [[nodiscard]] std::size_t count() const { return std::size_t{1} << unsigned(3 * bits_); }
  /// The side of a block of the box with so many cells.
  [[nodiscard]] T sideOf(double cells) const {
    T side = perLength_ > 0 ? 1 / perLength_ : T(0);
    while (side < maxComponent(size_) && inBlock(side) < cells) side *= T(1.25);
    return side;
  }
  [[nodiscard]] std::uint32_t at(const Vec3<T>& p) const {
    const auto along = [&](int axis) {
      const T place = (p[axis] - lower_[axis]) * perLength_;
      const T last = static_cast<T>((1 << bits_) - 1);
      return spread(place > 0 ? static_cast<std::uint64_t>(std::min(place, last)) : 0);
    };
    return static_cast<std::uint32_t>(along(0) | along(1) << 1U | along(2) << 2U);
  }

 private:
  Vec3<T> lower_;
  Vec3<T> size_;
  int bits_ = 0;
  T perLength_ = 0;
};

template <std::floating_point T>
Box<T> boxAround(std::span<const Vec3<T>> points) {
  Box<T> box;
  for (const auto& p : points) {
    if (isFinite(p)) box.extend(p);
  }
  return box;
}

/// Whether most runs of points are in blocks not much larger than those of runs in order.
template <std::floating_point T>
bool areNeighboursClose(std::span<const Vec3<T>> points, const Cells<T>& cells) {
  constexpr std::size_t kRuns = 64;
  constexpr std::size_t kLength = 256;
  if (points.size() < kLength) return true;
  const double share = double{kLength} / static_cast<double>(points.size());
  const T most = 3 * cells.sideOf(share * cells.inBlock(std::numeric_limits<T>::max()));
  std::size_t close = 0;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const auto first = (points.size() - kLength) / kRuns * run;
    const auto box = boxAround(points.subspan(first, kLength));
    if (box.empty() || maxComponent(box.size()) <= most) ++close;
  }
  return close > kRuns / 2;
}

template <std::floating_point T>
std::vector<std::uint32_t> sortedByCells(std::span<const Vec3<T>> points, const Cells<T>& cells,
                                         int threads) {
  constexpr std::size_t kGrain = 1 << 14;
  std::vector<std::uint32_t> cellOf(points.size());
  parallelFor(points.size(), {.threads = threads, .grain = kGrain},
              [&](std::size_t begin, std::size_t end) {
                for (auto i = begin; i < end; ++i) cellOf[i] = cells.at(points[i]);
              });
  std::vector<std::uint32_t> next(cells.count() + 1);
  for (const auto cell : cellOf) ++next[cell + 1];
  for (std::size_t cell = 1; cell < next.size(); ++cell) next[cell] += next[cell - 1];
  std::vector<std::uint32_t> order(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[next[cellOf[i]]++] = i;
  return order;
}

}  // namespace

template <std::floating_point T>
std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<T>> points, int threads) {
  const auto box = boxAround(points);
  if (points.size() > std::numeric_limits<std::uint32_t>::max() || box.empty() ||
      !isFinite(box.size())) {
    return {};
  }
  const Cells<T> cells(box, points.size() / 2);
  if (areNeighboursClose(points, cells)) return {};
  try {
    return sortedByCells(points, cells, threads);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

template std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<float>>, int);
template std::vector<std::uint32_t> spatialOrder(std::span<const Vec3<double>>, int);

}  // namespace cutwater::detail
