#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/Detail/UnresolvedCell.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Inspects cells of a mesh, given by their indices.
template <std::floating_point T>
class Inspection {
 public:
  using Features = std::vector<UnresolvedFeature<T>>;

  Inspection(const SignedDistanceFunction<T>& solid, const Octree<T>& mesh,
             const UnresolvedOptions& options)
      : solid_(solid), mesh_(mesh), options_(options), signs_(solid, mesh, part(0, kCorners)) {}

  [[nodiscard]] Features run() {
    std::size_t all = 0;
    for (int level = 0; level <= mesh_.deepest(); ++level) all += signs_.cells(level).size();
    Features features;
    std::size_t done = 0;
    for (int level = 0; level <= mesh_.deepest(); ++level) {
      const auto count = signs_.cells(level).size();
      if (count == 0) continue;
      const auto share = [&](std::size_t n) {
        return (1 - kCorners) * static_cast<double>(n) / static_cast<double>(all);
      };
      signs_.countCrossings(level, part(kCorners + share(done), share(count)));
      inspect(signs_.cells(level), features);
      done += count;
    }
    if (options_.progress) options_.progress(1.0);  // also where there is no cell to inspect
    return features;
  }

 private:
  static constexpr auto kTogether = detail::OctreeSigns<T>::kMost;
  /// Share of the corners in the total time; the edges take most of the rest.
  static constexpr double kCorners = 0.4;

  /// Options that report progress for this part of all work.
  [[nodiscard]] ParallelOptions part(double first, double width) const {
    ParallelOptions options{.threads = options_.threads};
    if (!options_.progress) return options;
    options.progress = [=, this](double fraction) { options_.progress(first + fraction * width); };
    return options;
  }

  void inspect(std::span<const std::size_t> places, Features& features) const {
    std::vector<Features> found((places.size() + kTogether - 1) / kTogether);
    detail::parallelBatches(places.size(), kTogether, {.threads = options_.threads},
                            [&](std::size_t first, std::size_t count) {
                              const auto some = places.subspan(first, count);
                              std::array<detail::CellSigns<T>, kTogether> signs;
                              signs_.signs(some, signs);
                              auto& here = found[first / kTogether];
                              for (std::size_t n = 0; n < count; ++n)
                                inspect(some[n], signs[n], here);
                            });
    for (const auto& some : found) features.insert(features.end(), some.begin(), some.end());
  }

  void inspect(std::size_t place, const detail::CellSigns<T>& signs, Features& features) const {
    const auto& cell = mesh_.cells()[place];
    detail::UnresolvedCell<T> surface(solid_, mesh_.box(cell), signs);
    const auto found = surface.find(cell.kind == BoxClass::Cut);
    if (!found) return;
    const T size = mesh_.domain().level(cell.level).spacing().x;
    const T depth = found->depth / size;
    // Zero depth counts as a depth that no level resolves.
    const T halvings =
        std::ceil(std::log2(std::clamp(1 / depth, T(1), T(1 << detail::kMortonBits))));
    const int level = cell.level + static_cast<int>(halvings);
    features.push_back({place, found->kind, found->isSolid, depth, found->point,
                        std::min(level, mesh_.domain().deepest())});
  }

  const SignedDistanceFunction<T>& solid_;
  const Octree<T>& mesh_;
  const UnresolvedOptions& options_;
  detail::OctreeSigns<T> signs_;
};

}  // namespace

template <std::floating_point T>
std::vector<UnresolvedFeature<T>> unresolvedFeatures(const SignedDistanceFunction<T>& solid,
                                                     const Octree<T>& mesh,
                                                     const UnresolvedOptions& options) {
  require(options.threads >= 0, "unresolvedFeatures: need threads >= 0",
          Named{"threads", options.threads});
  auto features = Inspection<T>(solid, mesh, options).run();
  std::ranges::sort(features, [](const auto& a, const auto& b) {
    return a.kind != b.kind     ? a.kind < b.kind
           : a.depth != b.depth ? a.depth > b.depth
                                : a.cell < b.cell;
  });
  return features;
}

template std::vector<UnresolvedFeature<float>> unresolvedFeatures(
    const SignedDistanceFunction<float>&, const Octree<float>&, const UnresolvedOptions&);
template std::vector<UnresolvedFeature<double>> unresolvedFeatures(
    const SignedDistanceFunction<double>&, const Octree<double>&, const UnresolvedOptions&);

}  // namespace cutwater
