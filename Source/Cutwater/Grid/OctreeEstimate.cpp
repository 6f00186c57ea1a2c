#include <Cutwater/Grid/Detail/OctreeBuilder.hpp>
#include <Cutwater/Grid/OctreeEstimate.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

namespace cutwater {

namespace {

using detail::CellTag;
using detail::MortonCode;
using detail::OctreeCodes;

/// Cells of the first level that is not divided in full, and those that represent each level below.
constexpr std::size_t kMostCounted = 40'000;
constexpr std::size_t kMostSampled = 3000;
/// The fewest where cells take long, and the time that may be spent on each level, in seconds.
constexpr std::size_t kLeastCounted = 2000;
constexpr std::size_t kLeastSampled = 600;
constexpr double kSeconds = 0.3;
/// Parts of the mesh that are built to see what balancing adds, of so many levels.
constexpr std::size_t kWindows = 16;
constexpr int kWindowLevels = 4;

/// How many cells of a level the rules divide, and how many a balanced mesh does.
struct Divided {
  double byRules = 0;
  double inAll = 0;
};

/// The rules for cells of a level, as if they were roots.
template <std::floating_point T>
Refinement<T> rulesFrom(int level, Refinement<T> rules) {
  const auto isAbove = [=](const auto& rule) { return rule.level <= level; };
  rules.cut = std::max(rules.cut - level, 0);
  std::erase_if(rules.bands, isAbove);
  std::erase_if(rules.patches, isAbove);
  for (auto& band : rules.bands) band.level -= level;
  for (auto& patch : rules.patches) patch.level -= level;
  const auto lower = [&](auto& rule) {
    if (rule && isAbove(*rule)) rule.reset();
    if (rule) rule->level -= level;
  };
  lower(rules.curvature);
  lower(rules.edges);
  lower(rules.gaps);
  lower(rules.walls);
  return rules;
}

/// Descends from the roots, and counts the cells of each level.
template <std::floating_point T>
class LevelCounter {
 public:
  /// All must outlive it.
  LevelCounter(const detail::CellTagger<T>& tagger, const OctreeDomain<T>& domain,
               const OctreeOptions& options)
      : tagger_(tagger), domain_(domain), options_(options) {}

  void run(int deepest) {
    deepest_ = deepest;
    for (codes_ = detail::rootCodes(domain_); level_ < deepest; ++level_) {
      nodes_.push_back(weight_ * static_cast<double>(codes_.size()));
      divide();
    }
    nodes_.push_back(weight_ * static_cast<double>(codes_.size()));
  }

  /// Cells of each level, divided or not, as the rules alone ask for.
  [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
  /// Whether no level is represented by a sample.
  [[nodiscard]] bool hasCountedAll() const {
    return divided_.size() == static_cast<std::size_t>(deepest_);
  }
  /// Of the levels that were divided in full.
  [[nodiscard]] std::vector<Divided> divided() const {
    auto balanced = divided_;
    detail::balanceOctree(domain_, options_.balance, balanced);
    std::vector<Divided> result;
    for (std::size_t level = 0; level < divided_.size(); ++level) {
      result.push_back({static_cast<double>(divided_[level].size()),
                        static_cast<double>(balanced[level].size())});
    }
    return result;
  }
  /// Of the meshes that end at level 0, 1 and so on, as far as the levels were divided in full.
  [[nodiscard]] std::vector<double> cellsOfMeshes() const {
    std::vector<double> cells{nodes_.front()};
    for (std::size_t levels = 1; levels <= divided_.size(); ++levels) {
      std::vector<OctreeCodes> balanced(divided_.begin(),
                                        divided_.begin() + static_cast<std::ptrdiff_t>(levels));
      detail::balanceOctree(domain_, options_.balance, balanced);
      double count = nodes_.front();
      for (const auto& level : balanced) count += 7 * static_cast<double>(level.size());
      cells.push_back(count);
    }
    return cells;
  }
  /// Some of the cells, all over the surface, that are kWindowLevels above the finest.
  [[nodiscard]] const OctreeCodes& windows() const { return windows_; }
  /// The cells of all levels are tagged, those of a sample as fast as those of the last level.
  [[nodiscard]] double seconds() const {
    double cells = 0;
    for (const auto count : nodes_) cells += count;
    return tags_ > 0 ? cells * secondsOfTags_ / static_cast<double>(tags_) : 0;
  }

 private:
  /// Replaces the cells by the children of those that the rules divide, or of a sample of these.
  void divide() {
    const auto start = std::chrono::steady_clock::now();
    auto tags = tagged();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    secondsOfTags_ = spent.count();
    tags_ = codes_.size();
    OctreeCodes divided;
    std::vector<BoxHint> hints;
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      if (!tags[i].isRefined) continue;
      divided.push_back(codes_[i]);
      hints.push_back(hints_[i]);
    }
    const bool isCounted = 8 * divided.size() <= within(kLeastCounted, kMostCounted);
    if (level_ == std::max(deepest_ - kWindowLevels, 0)) {
      const auto count = std::min(kWindows, divided.size());
      for (std::size_t n = 0; n < count; ++n)
        windows_.push_back(divided[n * divided.size() / count]);
    }
    if (weight_ == 1 && isCounted) {
      divided_.push_back(divided);
    } else {
      thin(divided, hints);
    }
    codes_.clear();
    for (const auto code : divided) {
      for (MortonCode child = 0; child < 8; ++child) codes_.push_back(8 * code + child);
    }
    parents_ = std::move(hints);
  }

  /// As many cells as can be tagged in the time for a level.
  [[nodiscard]] std::size_t within(std::size_t least, std::size_t most) const {
    const double cells = kSeconds * static_cast<double>(tags_) / std::max(secondsOfTags_, 1e-9);
    return std::clamp(static_cast<std::size_t>(std::min(cells, 1e9)), least, most);
  }

  /// Keeps some of the cells, evenly, if there are many. They are in the order of their codes, so
  /// that all places are represented.
  void thin(OctreeCodes& divided, std::vector<BoxHint>& hints) {
    constexpr std::size_t kPrime = 7919;  // for places that follow no pattern
    const auto all = divided.size();
    const auto sampled = within(8 * kLeastSampled, 8 * kMostSampled) / 8;
    if (all <= sampled) return;
    for (std::size_t i = 0; i < sampled; ++i) {
      const auto from = i * all / sampled + i * kPrime % (all / sampled);
      divided[i] = divided[from];
      hints[i] = hints[from];
    }
    divided.resize(sampled);
    hints.resize(sampled);
    weight_ *= static_cast<double>(all) / static_cast<double>(sampled);
  }

  std::vector<CellTag> tagged() {
    std::vector<CellTag> tags(codes_.size());
    hints_.assign(codes_.size(), {});
    const auto before = [&](std::size_t first, std::span<BoxHint> some) {
      for (std::size_t i = 0; i < some.size(); ++i) {
        some[i] = parents_.empty() ? BoxHint{} : parents_[(first + i) / 8];
      }
    };
    const auto after = [&](std::size_t first, std::span<const BoxHint> some) {
      std::ranges::copy(some, std::span(hints_).subspan(first).begin());
    };
    tagger_.tag({.level = level_,
                 .grid = domain_.level(level_),
                 .codes = codes_,
                 .hintsBefore = before,
                 .hintsAfter = after},
                tags, {.threads = options_.threads});
    return tags;
  }

  const detail::CellTagger<T>& tagger_;
  const OctreeDomain<T>& domain_;
  const OctreeOptions& options_;
  int deepest_ = 0;
  int level_ = 0;
  OctreeCodes codes_;  // of the level's cells, or of a sample of them
  double weight_ = 1;  // how many cells each of them stands for
  std::vector<BoxHint> hints_;
  std::vector<BoxHint> parents_;
  std::vector<OctreeCodes> divided_;  // on levels that were divided in full
  OctreeCodes windows_;
  std::vector<double> nodes_;
  double secondsOfTags_ = 0;
  std::size_t tags_ = 0;
};

/// What balancing adds on the finest levels: of a few parts of the mesh, each a cell and those
/// around it.
template <std::floating_point T>
std::vector<Divided> dividedInWindows(const SignedDistanceFunction<T>& solid,
                                      const OctreeDomain<T>& domain,
                                      const Refinement<T>& refinement, const OctreeOptions& options,
                                      const OctreeCodes& windows) {
  const int levels = std::min(kWindowLevels, refinement.deepest());
  const int level = refinement.deepest() - levels;
  const auto rules = rulesFrom(level, refinement);
  const detail::CellTagger<T> tagger(solid, rules);
  const auto grid = domain.level(level);
  const auto start = std::chrono::steady_clock::now();
  std::vector<Divided> sum(static_cast<std::size_t>(levels));
  for (const auto code : windows) {
    const auto lower = grid.cell(detail::indexOf(code)).lower - grid.spacing();
    const OctreeDomain<T> window(lower, grid.spacing().x, {3, 3, 3});
    LevelCounter<T> counter(tagger, window, options);
    counter.run(levels);
    const auto found = counter.divided();
    for (std::size_t n = 0; n < found.size(); ++n) {
      sum[n].byRules += found[n].byRules;
      sum[n].inAll += found[n].inAll;
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    if (spent.count() > 4 * kSeconds) break;
  }
  return sum;
}

/// The factors of an OctreeEstimate: the finest cells are all asked for by the rules.
std::vector<double> factorsOf(const std::vector<Divided>& divided) {
  std::vector<double> factors;
  for (auto level = divided.rbegin(); level != divided.rend(); ++level) {
    factors.push_back(level->byRules > 0 ? level->inAll / level->byRules : 1);
  }
  if (factors.empty()) factors.push_back(1);
  return factors;
}

}  // namespace

OctreeEstimate::OctreeEstimate(std::vector<double> nodes, std::vector<double> balance,
                               double seconds, std::vector<double> counted)
    : nodes_(std::move(nodes)),
      balance_(std::move(balance)),
      seconds_(seconds),
      counted_(std::move(counted)) {}

double OctreeEstimate::cells(int finest) const {
  const int counted = static_cast<int>(counted_.size()) - 1;
  if (finest <= counted) return counted_[static_cast<std::size_t>(finest)];
  if (counted < 0) return cellsByFactors(finest);
  // Coarse meshes differ from what the factors of fine ones make of them, less on each level.
  const double ratio = counted_.back() / cellsByFactors(counted);
  return cellsByFactors(finest) * (1 + std::ldexp(ratio - 1, counted - finest));
}

double OctreeEstimate::cellsByFactors(int finest) const {
  // A divided cell is replaced by eight of the next level.
  double count = nodes_.front();
  double full = nodes_.front();  // cells that there would be if all were divided
  for (int level = 1; level <= finest; ++level) {
    full *= 8;
    const auto above =
        std::min<std::size_t>(static_cast<std::size_t>(finest - level), balance_.size() - 1);
    const double nodes = std::min(nodes_[static_cast<std::size_t>(level)] * balance_[above], full);
    count += nodes * 7 / 8;
  }
  return count;
}

double OctreeEstimate::divided(int level) const {
  return level < deepest() ? nodes_[static_cast<std::size_t>(level) + 1] / 8 : 0;
}

int OctreeEstimate::finestWithin(double most) const {
  int level = deepest();
  while (level >= 0 && cells(level) > most) --level;
  return level;
}

template <std::floating_point T>
OctreeEstimate estimate(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                        const Refinement<T>& refinement, const OctreeOptions& options) {
  const detail::CellTagger<T> tagger(solid, refinement);
  const int deepest = refinement.deepest();
  detail::requireLevel(domain, deepest);
  LevelCounter<T> counter(tagger, domain, options);
  counter.run(deepest);
  const auto divided = counter.hasCountedAll() ? counter.divided()
                                               : dividedInWindows(solid, domain, refinement,
                                                                  options, counter.windows());
  return {counter.nodes(), factorsOf(divided), counter.seconds(), counter.cellsOfMeshes()};
}

template OctreeEstimate estimate(const SignedDistanceFunction<float>&, const OctreeDomain<float>&,
                                 const Refinement<float>&, const OctreeOptions&);
template OctreeEstimate estimate(const SignedDistanceFunction<double>&, const OctreeDomain<double>&,
                                 const Refinement<double>&, const OctreeOptions&);

}  // namespace cutwater
