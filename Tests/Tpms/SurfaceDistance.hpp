#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <unordered_map>
#include <vector>

#include "Support/Random.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {

/// The distance to a level F = c of a plain formula, from above: to points of it, sampled densely
/// over a cell, and the nearest of them moved along the surface as near as it gets. In radians, by
/// the standard library's functions alone.
class SurfaceDistance {
 public:
  using Formula = std::function<double(double, double, double)>;

  SurfaceDistance(Formula formula, double level) : formula_(std::move(formula)), level_(level) {
    std::vector<double> values;
    for (int i = 0; i < kSide * kSide * kSide; ++i) values.push_back(value(node(i)));
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const std::array<int, 3> next{
          i % kSide + 1 < kSide ? i + 1 : i + 1 - kSide,
          i / kSide % kSide + 1 < kSide ? i + kSide : i + kSide - kSide * kSide,
          (i + kSide * kSide) % (kSide * kSide * kSide)};
      // Along each edge of the grid with a change of sign.
      for (int axis = 0; axis < 3; ++axis) {
        const double a = values[static_cast<std::size_t>(i)];
        const double b = values[static_cast<std::size_t>(next[static_cast<std::size_t>(axis)])];
        if ((a < 0) == (b < 0)) continue;
        auto q = node(i);
        q[axis] += a / (a - b) * kStep;
        add(onto(q));
      }
    }
  }

  [[nodiscard]] const std::vector<Vec3<double>>& samples() const { return samples_; }
  [[nodiscard]] double value(const Vec3<double>& p) const {
    return formula_(p.x, p.y, p.z) - level_;
  }
  [[nodiscard]] Vec3<double> gradient(const Vec3<double>& p) const {
    constexpr double kDelta = 1e-6;
    Vec3<double> g;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3<double> step;
      step[axis] = kDelta;
      g[axis] = (value(p + step) - value(p - step)) / (2 * kDelta);
    }
    return g;
  }

  /// A distance at which there certainly is surface.
  [[nodiscard]] double upperBound(const Vec3<double>& p) const {
    return length(slide(nearestSample(p), p) - p);
  }
  /// As near as any sample that is not much farther than that leads, and as nearer and nearer
  /// guesses about it do: slow.
  [[nodiscard]] double leastUpperBound(const Vec3<double>& p) const {
    const double first = upperBound(p);
    auto best = slide(nearestSample(p), p);
    for (const auto& sample : samples_) {
      const auto q = nextTo(p, sample);
      if (length(q - p) > first + 0.05) continue;
      const auto found = slide(q, p);
      if (length(found - p) < length(best - p)) best = found;
    }
    RandomPoints<double> random(1, 5);
    double size = 0.1;
    for (int round = 0; round < 32; ++round, size *= 0.8) {
      for (int k = 0; k < 200; ++k) {
        const auto q = onto(best + size * random.next());
        if (length(q - p) < length(best - p) && std::abs(value(q)) < 1e-12) best = q;
      }
    }
    return length(best - p);
  }

 private:
  static constexpr int kSide = 40;
  static constexpr double kStep = kTurn / kSide;
  static constexpr int kBuckets = 16;

  /// Along the surface, from q, to where it is nearest.
  [[nodiscard]] Vec3<double> slide(Vec3<double> q, const Vec3<double>& p) const {
    auto best = q;
    double share = 1;
    for (int step = 0; step < 60 && share > 0.1; ++step) {
      const auto n = normalized(gradient(q));
      const auto tangential = (p - q) - dot(p - q, n) * n;
      const auto next = onto(q + share * tangential);
      const double gain = length(best - p) - length(next - p);
      if (gain > 0) {
        best = q = next;
        if (gain < 1e-14) break;
      } else {
        share *= 0.6;
      }
    }
    return best;
  }

  static Vec3<double> node(int i) {
    return {kStep * (i % kSide), kStep * (i / kSide % kSide),
            kStep * (i / kSide / kSide)};  // NOLINT(bugprone-integer-division)
  }
  [[nodiscard]] Vec3<double> onto(Vec3<double> p) const {
    for (int i = 0; i < 8; ++i) {
      const double f = value(p);
      if (std::abs(f) < 1e-14) break;
      const auto g = gradient(p);
      if (lengthSquared(g) < 1e-9) break;
      p -= f / lengthSquared(g) * g;
    }
    return p;
  }
  static int bucketOf(double x) {
    const int i = static_cast<int>(std::floor(x / kTurn * kBuckets));
    return (i % kBuckets + kBuckets) % kBuckets;
  }
  static std::size_t indexOf(int i, int j, int k) {
    const int index = (k * kBuckets + j) * kBuckets + i;
    return static_cast<std::size_t>(index);
  }
  void add(const Vec3<double>& p) {
    if (!(std::abs(value(p)) < 1e-12)) return;
    samples_.push_back(p);
    buckets_[indexOf(bucketOf(p.x), bucketOf(p.y), bucketOf(p.z))].push_back(p);
  }
  /// The period of it that is nearest to p.
  static Vec3<double> nextTo(const Vec3<double>& p, Vec3<double> sample) {
    for (int axis = 0; axis < 3; ++axis) {
      sample[axis] += kTurn * std::round((p[axis] - sample[axis]) / kTurn);
    }
    return sample;
  }
  [[nodiscard]] Vec3<double> nearestSample(const Vec3<double>& p) const {
    Vec3<double> best{1e9, 0, 0};
    for (int reach = 0; reach <= kBuckets / 2; ++reach) {
      if (reach > 1 && length(best - p) < (reach - 1) * kTurn / kBuckets) break;
      for (int i = 0; i < (2 * reach + 1) * (2 * reach + 1) * (2 * reach + 1); ++i) {
        const int side = 2 * reach + 1;
        const std::array<int, 3> d{i % side - reach, i / side % side - reach,
                                   i / side / side - reach};
        if (std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])}) != reach) continue;
        const auto wrap = [](int b) { return (b % kBuckets + kBuckets) % kBuckets; };
        for (const auto& sample :
             buckets_[indexOf(wrap(bucketOf(p.x) + d[0]), wrap(bucketOf(p.y) + d[1]),
                              wrap(bucketOf(p.z) + d[2]))]) {
          const auto q = nextTo(p, sample);
          if (lengthSquared(q - p) < lengthSquared(best - p)) best = q;
        }
      }
    }
    return best;
  }

  Formula formula_;
  double level_;
  std::vector<Vec3<double>> samples_;
  std::vector<std::vector<Vec3<double>>> buckets_ =
      std::vector<std::vector<Vec3<double>>>(kBuckets * kBuckets * kBuckets);
};

}  // namespace cutwater::test
