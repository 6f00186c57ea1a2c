#include <algorithm>
#include <cmath>

#include "BruteForce.hpp"
#include "Points.hpp"
#include "Workload.hpp"

namespace cutwater::benchmarks {

namespace {

using Points = std::vector<Vec3<double>>;

class PointWorkload : public Workload {
 public:
  PointWorkload(Arena& arena, std::string name, Points points)
      : Workload(arena),
        name_(std::move(name)),
        points_(std::move(points)),
        distances_(points_.size()) {}

  Round run(const std::string& contestant, int threads) override {
    auto& count = counts_[contestant];
    if (count == 0) {
      count = affordable([&](std::size_t n) { ask(contestant, n, 1); }, points_.size(),
                         arena_.settings().seconds);
    }
    return {.seconds = secondsOf([&] { ask(contestant, count, threads); }),
            .queries = static_cast<double>(count),
            .share = static_cast<double>(count) / static_cast<double>(points_.size())};
  }

  void check(const std::string& contestant) override {
    const auto checked = std::min(arena_.settings().checked, points_.size());
    if (truth_.empty()) truth_ = bruteForce(arena_.soup(), first(checked));
    ask(contestant, checked, 0);
    arena_.check(name_, contestant, "brute force", comparison(checked, truth_));
    if (contestant == kOurs) count();
    if (contestant == kOurs || contestant != peers().front().name) return;
    ask(kOurs, points_.size(), 0);
    arena_.checkAgainst(contestant, name_, comparison(points_.size(), {}));
  }

 protected:
  virtual void ask(const std::string& contestant, std::size_t count, int threads) {
    arena_.ask(contestant, first(count), distances(count), threads);
  }
  [[nodiscard]] std::span<const Vec3<double>> first(std::size_t count) const {
    return std::span(points_).first(count);
  }
  [[nodiscard]] std::span<double> distances(std::size_t count) {
    return std::span(distances_).first(count);
  }
  [[nodiscard]] Comparison comparison(std::size_t count, std::span<const double> truth) {
    return {.points = first(count), .answers = distances(count), .truth = truth};
  }
  /// The answers are to be the same bits as the truth.
  void checkBits(const std::string& truthName, std::span<const double> truth) {
    auto toTheBit = comparison(truth.size(), truth);
    toTheBit.tolerance = [](const Vec3<double>&) { return 0.0; };
    arena_.check(name_, kOurs, truthName, toTheBit);
  }

 private:
  /// What the search looks at; with counters it is to find what it finds without.
  void count() {
    std::vector<double> truth(points_.size());
    arena_.count(name_, points_, truth);
    ask(kOurs, points_.size(), 0);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      truth[i] = std::copysign(truth[i], distances_[i]);
    }
    checkBits("counted search", truth);
  }

  std::string name_;
  Points points_;
  std::vector<double> distances_;
  std::vector<double> truth_;  // of the first points
  std::map<std::string, std::size_t> counts_;
};

/// Ours alone: peers have no such function.
class BatchWorkload final : public PointWorkload {
 public:
  using PointWorkload::PointWorkload;

  /// The same bits as one by one, where those have been checked.
  void check(const std::string&) override {
    const auto count = arena_.settings().points;
    std::vector<double> truth(count);
    arena_.ask(kOurs, first(count), truth, 0);
    ask(kOurs, count, 0);
    checkBits("one by one", truth);
  }

 private:
  void ask(const std::string&, std::size_t count, int threads) override {
    arena_.ours().signedDistances(first(count), distances(count), {.threads = threads});
  }
};

/// The points of another workload in groups of 16, each group eight times: all but the first time,
/// the cache holds what they need. Their answers are those of that workload.
class HotWorkload final : public PointWorkload {
 public:
  HotWorkload(Arena& arena, std::string name, const Points& points)
      : PointWorkload(arena, std::move(name), repeated(points)) {}

  void check(const std::string&) override {}

 private:
  static Points repeated(const Points& points) {
    constexpr std::size_t kGroup = 16;
    constexpr std::size_t kTimes = 8;
    Points result;
    for (std::size_t i = 0; i < points.size() / kTimes; i += kGroup) {
      for (std::size_t time = 0; time < kTimes; ++time) {
        const auto end = std::min(points.size(), i + kGroup);
        for (auto n = i; n < end; ++n) result.push_back(points[n]);
      }
    }
    return result;
  }
};

Points uniform(Arena& arena) {
  return uniformPoints(arena.soup(), arena.settings().points);
}
Points narrow(Arena& arena) {
  return narrowPoints(arena.soup(), arena.settings().points);
}

}  // namespace

std::unique_ptr<Workload> makeUniform(Arena& arena) {
  return std::make_unique<PointWorkload>(arena, "uniform", uniform(arena));
}
std::unique_ptr<Workload> makeNarrow(Arena& arena) {
  return std::make_unique<PointWorkload>(arena, "narrow", narrow(arena));
}
std::unique_ptr<Workload> makeUniformHot(Arena& arena) {
  return std::make_unique<HotWorkload>(arena, "uniform-hot", uniform(arena));
}
std::unique_ptr<Workload> makeNarrowHot(Arena& arena) {
  return std::make_unique<HotWorkload>(arena, "narrow-hot", narrow(arena));
}
std::unique_ptr<Workload> makeUniformBatch(Arena& arena) {
  return std::make_unique<BatchWorkload>(arena, "uniform-batch", uniform(arena));
}
std::unique_ptr<Workload> makeNarrowBatch(Arena& arena) {
  return std::make_unique<BatchWorkload>(arena, "narrow-batch", narrow(arena));
}

}  // namespace cutwater::benchmarks
