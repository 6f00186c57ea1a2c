#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/UnresolvedCell.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr std::size_t kTogether = 32;  // cells

/// Asks about cells of a mesh by their places.
template <std::floating_point T>
class Inspection {
 public:
  using Features = std::vector<UnresolvedFeature<T>>;

  Inspection(const SignedDistanceFunction<T>& solid, const Octree<T>& mesh)
      : solid_(solid), mesh_(mesh) {}

  void inspect(std::span<const std::size_t> places, Features& features) const {
    std::array<Vec3<T>, 8 * kTogether> points;
    std::array<T, 8 * kTogether> values;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto box = mesh_.box(mesh_.cells()[places[n]]);
      for (int i = 0; i < 8; ++i) points[8 * n + static_cast<std::size_t>(i)] = box.corner(i);
    }
    const auto count = 8 * places.size();
    solid_.signedDistances(std::span<const Vec3<T>>(points).first(count),
                           std::span(values).first(count), {.threads = 1});
    for (std::size_t n = 0; n < places.size(); ++n) {
      std::array<T, 8> corners;
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(8 * n), 8, corners.begin());
      inspect(places[n], corners, features);
    }
  }

 private:
  void inspect(std::size_t place, const std::array<T, 8>& corners, Features& features) const {
    const auto& cell = mesh_.cells()[place];
    detail::UnresolvedCell<T> surface(solid_, mesh_.box(cell), corners);
    const auto found = surface.find(cell.kind == BoxClass::Cut);
    if (!found) return;
    const T size = mesh_.domain().level(cell.level).spacing().x;
    const T depth = found->depth / size;
    const int deepest = mesh_.domain().deepest();
    const int level =
        depth > 0 ? cell.level + static_cast<int>(std::ceil(std::log2(std::max(1 / depth, T(1)))))
                  : deepest;
    features.push_back({place, found->kind, found->isSolid, depth, found->point,
                        std::clamp(level, int{cell.level}, deepest)});
  }

  const SignedDistanceFunction<T>& solid_;
  const Octree<T>& mesh_;
};

}  // namespace

template <std::floating_point T>
std::vector<UnresolvedFeature<T>> unresolvedFeatures(const SignedDistanceFunction<T>& solid,
                                                     const Octree<T>& mesh,
                                                     const UnresolvedOptions& options) {
  require(options.threads >= 0, "unresolvedFeatures: need threads >= 0",
          Named{"threads", options.threads});
  std::vector<std::size_t> places;
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto kind = mesh.cells()[n].kind;
    if (kind == BoxClass::Cut || kind == BoxClass::Unknown) places.push_back(n);
  }
  const Inspection<T> inspection(solid, mesh);
  const auto groups = (places.size() + kTogether - 1) / kTogether;
  std::vector<std::vector<UnresolvedFeature<T>>> found(groups);
  parallelFor(groups, {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (; begin < end; ++begin) {
                  const auto first = begin * kTogether;
                  const auto count = std::min(kTogether, places.size() - first);
                  inspection.inspect(std::span(places).subspan(first, count), found[begin]);
                }
              });
  std::vector<UnresolvedFeature<T>> all;
  for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.depth > b.depth;
  });
  return all;
}

template std::vector<UnresolvedFeature<float>> unresolvedFeatures(
    const SignedDistanceFunction<float>&, const Octree<float>&, const UnresolvedOptions&);
template std::vector<UnresolvedFeature<double>> unresolvedFeatures(
    const SignedDistanceFunction<double>&, const Octree<double>&, const UnresolvedOptions&);

}  // namespace cutwater
