#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/TileClasses.hpp>
#include <Cutwater/Grid/Detail/TileFill.hpp>
#include <Cutwater/Grid/Fill.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Points of a tile, as powers of two: a large tile can be skipped at the cost of one value, small
/// tiles keep more threads busy.
constexpr int kSkippedTileBits = 12;
constexpr int kFullTileBits = 9;

/// Tiles that are about as long in space on each axis.
template <std::floating_point T>
detail::TileOrder tileOrder(const GridPatch<T>& gridPatch, int bits) {
  const Vec3<double> spacing(gridPatch.level.spacing());
  const auto& indices = gridPatch.indices;
  return {{spacing.x, spacing.y, spacing.z},
          {indices.length(0), indices.length(1), indices.length(2)},
          bits};
}

// How many tiles a thread takes at a time:

/// So many that most batches are full.
template <std::floating_point T>
std::size_t fullBatches(int bits) {
  return std::max<std::size_t>(1, (2 * detail::PointBatch<T>::kMost) >> bits);
}
/// So many that rows beyond the band are long, if there are enough for many threads.
std::size_t longRows(const detail::GridTiles& tiles) {
  constexpr std::size_t kEnough = 256;
  constexpr std::size_t kLong = 16;
  return tiles.count() < kEnough ? 1 : std::min(tiles.alongX(), kLong);
}

template <std::floating_point T>
void fillTiles(const detail::FillTask<T>& task, const detail::GridTiles& tiles, std::size_t begin,
               std::size_t end) {
  if (detail::takesPoints(task.targets)) {
    detail::TileFill<T> points(task);
    for (auto number = begin; number < end; ++number) points.fill(tiles.tile(number));
    points.finish();
  }
  if (task.targets.boxClass.data != nullptr) {
    detail::TileClasses<T> classes(task);
    for (auto number = begin; number < end; ++number) classes.fill(tiles.tile(number));
    classes.finish();
  }
}

}  // namespace

template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& gridPatch,
          const FillTargets<T>& targets, const FillOptions& options) {
  require(options.band >= 0 && std::isfinite(options.band), "fill: need a finite band >= 0",
          Named{"band", options.band});
  require(options.threads >= 0, "fill: need threads >= 0", Named{"threads", options.threads});
  const T limit = options.band > 0
                      ? static_cast<T>(options.band) * gridPatch.level.smallestSpacing()
                      : std::numeric_limits<T>::infinity();
  const bool isFull = detail::takesPoints(targets) && !(limit < std::numeric_limits<T>::infinity());
  const detail::FillTask<T> task{
      .solid = solid,
      .gridPatch = gridPatch,
      .targets = targets,
      .limit = limit,
      .order = tileOrder(gridPatch, isFull ? kFullTileBits : kSkippedTileBits)};
  const int bits = task.order.bits();
  const detail::GridTiles tiles(gridPatch.indices, task.order.shape(bits));
  const auto grain = isFull ? fullBatches<T>(bits) : longRows(tiles);
  parallelFor(tiles.count(),
              {.threads = options.threads, .grain = grain, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) { fillTiles(task, tiles, begin, end); });
}

template void fill(const SignedDistanceFunction<float>&, const GridPatch<float>&,
                   const FillTargets<float>&, const FillOptions&);
template void fill(const SignedDistanceFunction<double>&, const GridPatch<double>&,
                   const FillTargets<double>&, const FillOptions&);

}  // namespace cutwater
