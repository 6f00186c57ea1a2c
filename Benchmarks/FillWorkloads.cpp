#include <Cutwater/Grid/Fill.hpp>

#include <algorithm>

#include "BruteForce.hpp"
#include "Points.hpp"
#include "Tiles.hpp"
#include "Workload.hpp"

namespace cutwater::benchmarks {

namespace {

constexpr double kBand = 3;  // cells

struct Grid {
  Level<double> level;
  Index3 cells;
};

/// 128^3 cubic cells of a cube as long as the enlarged box.
Grid grid128(const PolygonSoup& soup) {
  const auto box = enlargedBox(soup);
  const double width = maxComponent(box.size());
  const double h = width / 128;
  const auto half = 0.5 * Vec3<double>{width, width, width};
  return {Level<double>(box.center() - half, {h, h, h}), {128, 128, 128}};
}

/// Cubic cells in the enlarged box, about as many as 256^3.
Grid cubicCells(const PolygonSoup& soup) {
  const auto box = enlargedBox(soup);
  const auto size = box.size();
  const double h = std::cbrt(size.x * size.y * size.z) / 256;
  const auto along = [&](double length) {
    return static_cast<std::int32_t>(std::ceil(length / h));
  };
  return {Level<double>(box.lower, {h, h, h}), {along(size.x), along(size.y), along(size.z)}};
}

/// We fill a grid, all of it or as many of its tiles as time allows; peers are asked cell by cell.
class FillWorkload : public Workload {
 public:
  FillWorkload(Arena& arena, std::string name, const Grid& grid, double band)
      : Workload(arena),
        name_(std::move(name)),
        level_(grid.level),
        tiles_(grid.cells),
        band_(band),
        values_(tiles_.whole().count()) {}

  Round run(const std::string& contestant, int threads) override {
    prepare();
    if (contestant == kOurs) {
      return {.seconds = secondsOf([&] { fillTiles(threads); }),
              .queries = static_cast<double>(cells_.size()),
              .share = static_cast<double>(filled_) / static_cast<double>(tiles_.count())};
    }
    for (const auto& kind : peerBands()) {
      if (kind.name == contestant) return runBand(kind, threads);
    }
    return runPeer(contestant, threads);
  }

  void check(const std::string& contestant) override {
    prepare();
    if (truth_.empty()) {
      sample_ = sampled(arena_.settings().checked);
      truth_ = bruteForce(arena_.soup(), positions(sample_));
    }
    const auto points = positions(sample_);
    const auto answers = answersOf(contestant, points);
    auto sampleComparison = comparison(points, answers, truth_);
    if (peerBands_.contains(contestant)) {  // in single precision
      sampleComparison.tolerance = [this](const Vec3<double>&) {
        return 0.01 * level_.smallestSpacing();
      };
    }
    arena_.check(name_, contestant, "brute force", sampleComparison);
    if (contestant == kOurs && band_ > 0) {
      std::vector<double> written(values_.size());
      arena_.noteWriting(bestSecondsOf([&] { std::ranges::fill(written, limit()); }));
    }
    if (contestant == kOurs || contestant != peers().front().name) return;
    const auto many = sampled(arena_.settings().points);
    const auto manyPoints = positions(many);
    arena_.checkAgainst(contestant, name_, comparison(manyPoints, valuesAt(many), {}));
  }

 private:
  using Cells = std::vector<std::size_t>;  // their places in the array of all

  [[nodiscard]] double limit() const {
    return band_ > 0 ? band_ * level_.smallestSpacing() : std::numeric_limits<double>::infinity();
  }

  /// The first time: how much of the grid can be had in time, and which cells count.
  void prepare() {
    if (filled_ > 0) return;
    arena_.ours();
    // A few tiles tell how long all take; in one go they take less.
    const auto seconds = arena_.settings().fillSeconds;
    double spent = 0;
    for (; filled_ < tiles_.count() && spent < 0.1 * seconds; ++filled_) {
      spent += secondsOf([&] { fillBox(tiles_[filled_], 1); });
    }
    const double fits = 1.5 * seconds / spent * static_cast<double>(filled_);
    filled_ = static_cast<std::size_t>(std::min(fits, static_cast<double>(tiles_.count())));
    fillTiles(0);
    for (std::size_t t = 0; t < filled_; ++t) addCounted(tiles_[t]);
    std::sort(cells_.begin(), cells_.end());
    if (cells_.empty()) cells_.push_back(tiles_.linear(tiles_[0].lo));
    addPeerPoints();
  }

  /// Peers go through runs of neighbouring cells.
  void addPeerPoints() {
    constexpr std::size_t kRun = 64;
    for (const auto run : scattered((cells_.size() + kRun - 1) / kRun)) {
      const auto end = std::min(cells_.size(), (run + 1) * kRun);
      for (auto i = run * kRun; i < end; ++i) peerPoints_.push_back(positionOf(cells_[i]));
      if (peerPoints_.size() >= arena_.settings().points) break;
    }
    peerDistances_.resize(peerPoints_.size());
  }

  void addCounted(const IndexBox& box) {
    for (auto k = box.lo.k; k <= box.hi.k; ++k) {
      for (auto j = box.lo.j; j <= box.hi.j; ++j) {
        for (auto i = box.lo.i; i <= box.hi.i; ++i) {
          const auto place = tiles_.linear({i, j, k});
          if (std::abs(values_[place]) < limit()) cells_.push_back(place);
        }
      }
    }
  }

  void fillBox(const IndexBox& box, int threads) {
    auto view = GridView<double>::contiguous(values_.data(), tiles_.whole());
    view.data += tiles_.linear(box.lo);
    fill(arena_.ours(), {level_, box}, view, {.band = band_, .threads = threads});
  }
  void fillTiles(int threads) {
    if (filled_ == tiles_.count()) {
      fillBox(tiles_.whole(), threads);
    } else {
      for (std::size_t t = 0; t < filled_; ++t) fillBox(tiles_[t], threads);
    }
  }

  Round runPeer(const std::string& contestant, int threads) {
    const auto ask = [&](std::size_t n, int threadsForIt) {
      arena_.ask(contestant, std::span(peerPoints_).first(n), std::span(peerDistances_).first(n),
                 threadsForIt);
    };
    auto& count = counts_[contestant];
    if (count == 0) {
      count = affordable([&](std::size_t n) { ask(n, 1); }, peerPoints_.size(),
                         arena_.settings().seconds);
    }
    const auto queries = static_cast<double>(count);
    return {.seconds = secondsOf([&] { ask(count, threads); }),
            .queries = queries,
            .share = queries / static_cast<double>(cells_.size())};
  }

  Round runBand(const PeerBandKind& kind, int threads) {
    auto& built = peerBands_[kind.name];
    built.reset();
    const double seconds =
        secondsOf([&] { built = kind.build(arena_.soup(), level_, band_, threads); });
    const double all = static_cast<double>(tiles_.count()) / static_cast<double>(filled_);
    return {.seconds = seconds, .queries = all * static_cast<double>(cells_.size())};
  }

  /// Half anywhere, half among the cells that count.
  [[nodiscard]] Cells sampled(std::size_t count) const {
    Random random(5);
    Cells sample(count);
    for (std::size_t i = 0; i < count; ++i) {
      const auto& box = tiles_[random.below(filled_)];
      const auto along = [&](int axis) {
        return static_cast<std::int32_t>(random.below(box.length(axis)));
      };
      const Index3 cell{box.lo.i + along(0), box.lo.j + along(1), box.lo.k + along(2)};
      sample[i] = i % 2 == 0 ? tiles_.linear(cell) : cells_[random.below(cells_.size())];
    }
    return sample;
  }

  /// In the sample's cells, which are at these points.
  std::vector<double> answersOf(const std::string& contestant,
                                const std::vector<Vec3<double>>& points) {
    if (contestant == kOurs) return valuesAt(sample_);
    std::vector<double> answers(points.size());
    if (const auto band = peerBands_.find(contestant); band != peerBands_.end()) {
      for (std::size_t i = 0; i < answers.size(); ++i) {
        answers[i] = band->second->at(tiles_.cell(sample_[i]));
      }
      return answers;
    }
    arena_.ask(contestant, points, answers, 0);
    for (auto& d : answers) d = std::clamp(d, -limit(), limit());
    return answers;
  }

  [[nodiscard]] Comparison comparison(const std::vector<Vec3<double>>& points,
                                      std::span<const double> answers,
                                      std::span<const double> truth) const {
    return {.points = points, .answers = answers, .truth = truth, .limit = limit()};
  }
  [[nodiscard]] Vec3<double> positionOf(std::size_t place) const {
    return level_.position(tiles_.cell(place));
  }
  [[nodiscard]] std::vector<Vec3<double>> positions(const Cells& cells) const {
    std::vector<Vec3<double>> points;
    for (const auto place : cells) points.push_back(positionOf(place));
    return points;
  }
  [[nodiscard]] std::vector<double> valuesAt(const Cells& cells) const {
    std::vector<double> values;
    for (const auto place : cells) values.push_back(values_[place]);
    return values;
  }

  std::string name_;
  Level<double> level_;
  Tiles tiles_;
  double band_;
  std::vector<double> values_;
  std::size_t filled_ = 0;  // tiles
  Cells cells_;             // those that count as queries: all that were filled, or the band's
  Cells sample_;            // those that brute force checks
  std::vector<double> truth_;
  std::vector<Vec3<double>> peerPoints_;
  std::vector<double> peerDistances_;
  std::map<std::string, std::size_t> counts_;
  std::map<std::string, std::unique_ptr<PeerBand>> peerBands_;  // as last built
};

}  // namespace

std::unique_ptr<Workload> makeGrid(Arena& arena) {
  return std::make_unique<FillWorkload>(arena, "grid", grid128(arena.soup()), 0);
}
std::unique_ptr<Workload> makeBand(Arena& arena) {
  return std::make_unique<FillWorkload>(arena, "band", cubicCells(arena.soup()), kBand);
}

}  // namespace cutwater::benchmarks
