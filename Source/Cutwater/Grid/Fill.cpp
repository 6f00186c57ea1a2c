#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/BlockFill.hpp>
#include <Cutwater/Grid/Fill.hpp>

namespace cutwater {

template <std::floating_point T>
void fill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& patch,
          const FillTargets<T>& targets, const FillOptions& options) {
  require(options.band >= 0 && std::isfinite(options.band), "fill: need a finite band >= 0",
          Named{"band", options.band});
  require(options.threads >= 0, "fill: need threads >= 0", Named{"threads", options.threads});
  const T limit = options.band > 0 ? static_cast<T>(options.band) * patch.level.smallestSpacing()
                                   : std::numeric_limits<T>::infinity();
  const detail::BlockFill<T> blocks(solid, patch, targets, limit);
  parallelFor(blocks.tileCount(),
              {.threads = options.threads, .grain = blocks.grain(), .progress = options.progress},
              [&](std::size_t begin, std::size_t end) { blocks.fillTiles(begin, end); });
}

template void fill(const SignedDistanceFunction<float>&, const GridPatch<float>&,
                   const FillTargets<float>&, const FillOptions&);
template void fill(const SignedDistanceFunction<double>&, const GridPatch<double>&,
                   const FillTargets<double>&, const FillOptions&);

}  // namespace cutwater
