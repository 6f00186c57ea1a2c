#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Fill.hpp>

#include <algorithm>
#include <array>
#include <cassert>

namespace cutwater {

namespace {

/// Indices are evaluated in runs of this many, x fastest; a run's scratch fits the L1 cache.
constexpr std::size_t kRun = 256;

struct Offset {
  std::size_t i, j, k;
};

/// Walks the offsets of a patch in memory order, from any linear position.
class Walk {
 public:
  Walk(const IndexBox& box, std::size_t linear) : nx_(box.length(0)), ny_(box.length(1)) {
    assert(nx_ > 0 && ny_ > 0);
    at_ = {linear % nx_, linear / nx_ % ny_, linear / nx_ / ny_};
  }

  const Offset& operator*() const { return at_; }
  void operator++() {
    if (++at_.i < nx_) return;
    at_.i = 0;
    if (++at_.j < ny_) return;
    at_.j = 0;
    ++at_.k;
  }

 private:
  std::size_t nx_;
  std::size_t ny_;
  Offset at_{};
};

template <std::floating_point T>
class Filler {
 public:
  Filler(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
         const FillTargets<T>& targets, T limit)
      : solid_(solid), patch_(patch), targets_(targets), limit_(limit) {}

  void run(std::size_t begin, std::size_t end) const {
    std::array<Vec3<T>, kRun> points;
    std::array<T, kRun> distances;
    std::array<std::uint32_t, kRun> patches;
    const auto count = end - begin;
    Walk walk(patch_.indices, begin);
    for (std::size_t n = 0; n < count; ++n, ++walk) points[n] = position(*walk);
    if (targets_.patch.data != nullptr && std::isinf(limit_)) {
      // The closest point tells the distance as well.
      for (std::size_t n = 0; n < count; ++n) {
        const auto hit = solid_.closestPoint(points[n]);
        distances[n] = hit.distance;
        patches[n] = hit.owner.patch;
      }
    } else {
      solid_.signedDistances(std::span<const Vec3<T>>(points).first(count),
                             std::span(distances).first(count), {.threads = 1});
      if (targets_.patch.data != nullptr) {
        for (std::size_t n = 0; n < count; ++n) {
          patches[n] = isBeyond(distances[n]) ? kNone : solid_.closestPoint(points[n]).owner.patch;
        }
      }
    }
    write(begin, std::span(distances).first(count), patches);
  }

 private:
  [[nodiscard]] Vec3<T> position(const Offset& offset) const {
    const auto& lo = patch_.indices.lo;
    return patch_.level.position({lo.i + static_cast<std::int32_t>(offset.i),
                                  lo.j + static_cast<std::int32_t>(offset.j),
                                  lo.k + static_cast<std::int32_t>(offset.k)});
  }

  [[nodiscard]] bool isBeyond(T distance) const { return std::abs(distance) > limit_; }

  void write(std::size_t begin, std::span<const T> distances,
             std::span<const std::uint32_t> patches) const {
    Walk walk(patch_.indices, begin);
    for (std::size_t n = 0; n < distances.size(); ++n, ++walk) {
      const auto [i, j, k] = *walk;
      const T d = distances[n];
      if (targets_.distance.data != nullptr) {
        targets_.distance.at(i, j, k) = isBeyond(d) ? std::copysign(limit_, d) : d;
      }
      if (targets_.patch.data != nullptr) targets_.patch.at(i, j, k) = patches[n];
    }
  }

  const SignedDistanceFunction<T>& solid_;
  const Patch<T>& patch_;
  const FillTargets<T>& targets_;
  T limit_;
};

}  // namespace

template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
          const FillTargets<T>& targets, const FillOptions& options) {
  require(options.band >= 0 && std::isfinite(options.band), "fill: need a finite band >= 0",
          Named{"band", options.band});
  require(options.threads >= 0, "fill: need threads >= 0", Named{"threads", options.threads});
  const T limit = options.band > 0 ? static_cast<T>(options.band) * patch.level.smallestSpacing()
                                   : std::numeric_limits<T>::infinity();
  const Filler<T> filler(solid, patch, targets, limit);
  parallelFor(patch.indices.count(),
              {.threads = options.threads, .grain = kRun, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) { filler.run(begin, end); });
}

template void fill(const SignedDistanceFunction<float>&, const Patch<float>&,
                   const FillTargets<float>&, const FillOptions&);
template void fill(const SignedDistanceFunction<double>&, const Patch<double>&,
                   const FillTargets<double>&, const FillOptions&);

}  // namespace cutwater
