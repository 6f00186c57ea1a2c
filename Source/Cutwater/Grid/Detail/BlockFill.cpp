#include <Cutwater/Grid/Detail/BlockFill.hpp>
#include <Cutwater/Grid/Detail/TileFill.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

/// Points of a tile, as powers of two: a large tile can be skipped at the cost of one value, small
/// tiles keep more threads busy.
constexpr int kBandTileBits = 12;
constexpr int kFullTileBits = 9;

}  // namespace

template <std::floating_point T>
BlockFill<T>::BlockFill(const SignedDistanceFunction<T>& solid, const GridPatch<T>& patch,
                        const FillTargets<T>& targets, T limit)
    : task_{.solid = solid,
            .patch = patch,
            .targets = targets,
            .limit = limit,
            .order = {{double{patch.level.spacing().x}, double{patch.level.spacing().y},
                       double{patch.level.spacing().z}},
                      {patch.indices.length(0), patch.indices.length(1), patch.indices.length(2)},
                      limit < std::numeric_limits<T>::infinity() ? kBandTileBits : kFullTileBits}},
      tiles_(patch.indices, task_.order.shape(task_.order.bits())) {}

template <std::floating_point T>
std::size_t BlockFill<T>::grain() const {
  return std::max<std::size_t>(1, (2 * PointBatch<T>::kMost) >> task_.order.bits());
}

template <std::floating_point T>
void BlockFill<T>::fillTiles(std::size_t begin, std::size_t end) const {
  TileFill<T> tileFill(task_);
  for (auto number = begin; number < end; ++number) tileFill.fill(tiles_.block(number));
  tileFill.finish();
}

template class BlockFill<float>;
template class BlockFill<double>;

}  // namespace cutwater::detail
