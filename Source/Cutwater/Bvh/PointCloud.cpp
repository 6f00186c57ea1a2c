#include <Cutwater/Bvh/Detail/LeafOrder.hpp>
#include <Cutwater/Bvh/PointCloud.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

/// Until the end of a search, the distances in the neighbours hold squares.
template <std::floating_point T>
class PointCloud<T>::Tree {
 public:
  explicit Tree(std::span<const Vec3<T>> points)
      : size_(points.size()), points_(points, boxesOf(points)) {
    for (const auto& p : points) reach_ = std::max(reach_, double{length(p)});
  }

  [[nodiscard]] std::size_t size() const { return size_; }

  [[nodiscard]] Neighbor<T> nearest(const Vec3<T>& p, T limit) const {
    Neighbor<T> best{.distance = squared(limit)};
    visit(p, limit, [&](std::span<const Vec3<T>> points, std::span<const std::uint32_t> ids) {
      // Whether a point beats the previous ones is hard to predict, so only the least square of a
      // leaf is compared with the best.
      std::array<T, kLeafWidth> squares;
      T least = std::numeric_limits<T>::max();
      for (std::size_t i = 0; i < points.size(); ++i) {
        squares[i] = lengthSquared(p - points[i]);
        least = std::min(least, squares[i]);
      }
      for (std::size_t i = 0; least <= best.distance && i < points.size(); ++i) {
        const Neighbor<T> candidate{ids[i], squares[i]};
        if (squares[i] == least && detail::IsBefore<T, Tree>()(candidate, best)) best = candidate;
      }
      return std::sqrt(double{best.distance});
    });
    if (best.primitive != kNone) best.distance = std::sqrt(best.distance);
    return best.primitive == kNone || best.distance > limit ? Neighbor<T>{.distance = limit} : best;
  }

  std::size_t nearest(const Vec3<T>& p, std::span<Neighbor<T>> results, T limit) const {
    if (results.empty()) return 0;
    detail::LeastHeap<T, Tree> least(results, squared(limit));
    visit(p, limit, [&](std::span<const Vec3<T>> points, std::span<const std::uint32_t> ids) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        least.offer({ids[i], lengthSquared(p - points[i])});
      }
      return std::sqrt(double{least.limit()});
    });
    const auto found = results.first(least.sorted());
    for (auto& neighbor : found) neighbor.distance = std::sqrt(neighbor.distance);
    const auto last = std::ranges::find_if(
        found, [=](const auto& neighbor) { return neighbor.distance > limit; });
    return static_cast<std::size_t>(last - found.begin());
  }

  /// Reports squared distances.
  void within(const Vec3<T>& p, T radius, FunctionRef<bool(const Neighbor<T>&)> tell) const {
    const T most = squared(radius);
    visit(p, radius, [&](std::span<const Vec3<T>> points, std::span<const std::uint32_t> ids) {
      for (std::size_t i = 0; i < points.size(); ++i) {
        const T square = lengthSquared(p - points[i]);
        const bool isWithin = square <= most && std::sqrt(square) <= radius;
        if (isWithin && !tell({ids[i], square})) return kStopTraversal;
      }
      return double{radius};
    });
  }
  /// Appends the neighbours in order.
  void appendWithin(const Vec3<T>& p, T radius, std::vector<Neighbor<T>>& all) const {
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    within(p, radius, [&](const Neighbor<T>& neighbor) {
      all.push_back(neighbor);
      return true;
    });
    std::sort(all.begin() + first, all.end(), detail::IsBefore<T, Tree>());
    for (auto& neighbor : std::span(all).subspan(static_cast<std::size_t>(first))) {
      neighbor.distance = std::sqrt(neighbor.distance);
    }
  }

  /// Fills the row with the nearest points, then with kNone.
  std::size_t fillRow(const Vec3<T>& p, std::span<Neighbor<T>> row, T limit) const {
    if (row.size() > 1) {
      const auto found = nearest(p, row, limit);
      std::ranges::fill(row.subspan(found), Neighbor<T>{});
      return found;
    }
    const auto found = nearest(p, limit);
    row[0] = found.primitive == kNone ? Neighbor<T>{} : found;
    return found.primitive == kNone ? 0 : 1;
  }

  /// Upper bound on the distance from `to` to its neighbour, given that of `from`.
  [[nodiscard]] T limitAfter(T distance, const Vec3<T>& from, const Vec3<T>& to) const {
    const T way = length(to - from);
    const T rounding = 16 * std::numeric_limits<T>::epsilon() *
                       (distance + way + length(from) + length(to) + static_cast<T>(reach_));
    return distance + way + rounding;
  }

 private:
  static constexpr std::size_t kLeafWidth = detail::LeafOrder<Vec3<T>>::kWidth;
  /// The squares of such coordinates, and the sums of these, are far from overflow.
  static constexpr T kFarthest = sizeof(T) == sizeof(float) ? T(0x1p60) : T(0x1p500);

  static bool isNear(const Vec3<T>& p) { return maxComponent(abs(p)) <= kFarthest && isFinite(p); }

  static std::vector<Box<double>> boxesOf(std::span<const Vec3<T>> points) {
    std::vector<Box<double>> boxes;
    boxes.reserve(points.size());
    for (const auto& p : points) {
      require(isNear(p), "PointCloud: need coordinates that are finite and not too large",
              Named{"point", boxes.size()}, Named{"coordinates", p});
      boxes.push_back({Vec3<double>(p), Vec3<double>(p)});
    }
    return boxes;
  }

  /// At least the square of any distance up to the limit.
  static T squared(T limit) {
    const T reach = std::min(limit, 4 * kFarthest);
    return reach < 0 ? T(-1)
                     : reach * reach * (1 + 8 * std::numeric_limits<T>::epsilon()) +
                           std::numeric_limits<T>::min();
  }

  template <typename Leaf>
  void visit(const Vec3<T>& p, T limit, Leaf&& leaf) const {
    if (!isNear(p) || !(limit >= 0)) return;
    const Vec3<double> q(p);
    // The second term covers the underflow of squares.
    const double error = 8 * double{std::numeric_limits<T>::epsilon()} * (length(q) + reach_) +
                         4 * std::sqrt(double{std::numeric_limits<T>::min()});
    points_.nearest(q, double{limit}, error, leaf);
  }

  std::size_t size_;
  detail::LeafOrder<Vec3<T>> points_;
  double reach_ = 0;  // of the farthest point
};

namespace {

/// Number of points that one thread processes consecutively.
constexpr std::size_t kBatch = 256;

ParallelOptions inBatches(ParallelOptions options) {
  options.grain = std::max(options.grain, kBatch);
  return options;
}

}  // namespace

template <std::floating_point T>
PointCloud<T>::PointCloud(std::span<const Vec3<T>> points)
    : tree_(std::make_shared<const Tree>(points)) {}

template <std::floating_point T>
std::size_t PointCloud<T>::size() const {
  return tree_->size();
}

template <std::floating_point T>
Neighbor<T> PointCloud<T>::nearest(const Vec3<T>& point, T limit) const {
  return tree_->nearest(point, limit);
}

template <std::floating_point T>
std::size_t PointCloud<T>::nearest(const Vec3<T>& point, std::span<Neighbor<T>> results,
                                   T limit) const {
  return tree_->nearest(point, results, limit);
}

template <std::floating_point T>
void PointCloud<T>::within(const Vec3<T>& point, T radius,
                           FunctionRef<bool(const Neighbor<T>&)> visit) const {
  tree_->within(point, radius, [&](const Neighbor<T>& neighbor) {
    return visit({neighbor.primitive, std::sqrt(neighbor.distance)});
  });
}

template <std::floating_point T>
void PointCloud<T>::nearest(std::span<const Vec3<T>> points, std::span<Neighbor<T>> results,
                            const ParallelOptions& options) const {
  nearest(points, 1, results, options);
}

template <std::floating_point T>
void PointCloud<T>::nearest(std::span<const Vec3<T>> points, std::size_t count,
                            std::span<Neighbor<T>> results, const ParallelOptions& options) const {
  require(count > 0 && results.size() / count == points.size() && results.size() % count == 0,
          "PointCloud::nearest: need room for as many neighbors of each point",
          Named{"points", points.size()}, Named{"count", count}, Named{"results", results.size()});
  parallelFor(points.size(), inBatches(options), [&](std::size_t begin, std::size_t end) {
    constexpr T kAnywhere = std::numeric_limits<T>::max();
    T limit = kAnywhere;
    for (auto n = begin; n < end; ++n) {
      const auto row = results.subspan(n * count, count);
      const auto found = tree_->fillRow(points[n], row, limit);
      if (n + 1 == end) break;
      // From one point to the next, which is often near, no distance changes by more than the
      // distance between the two.
      limit = found < count ? kAnywhere
                            : tree_->limitAfter(row.back().distance, points[n], points[n + 1]);
      if (!std::isfinite(limit)) limit = kAnywhere;
    }
  });
}

template <std::floating_point T>
NeighborRows<T> PointCloud<T>::within(std::span<const Vec3<T>> points, T radius,
                                      const ParallelOptions& options) const {
  const auto batches = (points.size() + kBatch - 1) / kBatch;
  std::vector<std::vector<Neighbor<T>>> found(batches);
  NeighborRows<T> rows;
  rows.offsets.resize(points.size() + 1);
  auto perBatch = options;
  perBatch.grain = 1;
  parallelFor(batches, perBatch, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) {
      auto& all = found[begin];
      for (auto n = begin * kBatch; n < std::min((begin + 1) * kBatch, points.size()); ++n) {
        const auto before = all.size();
        tree_->appendWithin(points[n], radius, all);
        rows.offsets[n + 1] = all.size() - before;
      }
    }
  });
  for (std::size_t n = 0; n < points.size(); ++n) rows.offsets[n + 1] += rows.offsets[n];
  rows.neighbors.reserve(rows.offsets.back());
  for (const auto& all : found) rows.neighbors.insert(rows.neighbors.end(), all.begin(), all.end());
  return rows;
}

template class PointCloud<float>;
template class PointCloud<double>;

}  // namespace cutwater
