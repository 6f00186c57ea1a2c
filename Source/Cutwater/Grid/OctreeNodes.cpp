#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/OctreeNodes.hpp>

#include <algorithm>
#include <mutex>

namespace cutwater {

namespace {

using detail::kMortonBits;
using detail::MortonCode;

/// Cells that a thread processes in one go.
constexpr std::size_t kGrain = std::size_t{1} << 14U;

/// There is one node index more along each axis than there are cells, too many for a Morton code.
/// So keys number regions of 2^18 nodes along each axis row by row, at most nine along each axis,
/// and use Morton codes within a region.
constexpr int kRegionBits = 18;
constexpr std::int32_t kInRegion = (1 << kRegionBits) - 1;
constexpr std::uint64_t kRegions = (std::uint64_t{1} << (kMortonBits - kRegionBits)) + 1;

std::uint64_t keyOf(const Index3& node) {
  const auto region = [](std::int32_t i) { return static_cast<std::uint64_t>(i >> kRegionBits); };
  const auto number = region(node.i) + kRegions * (region(node.j) + kRegions * region(node.k));
  return number << 3 * kRegionBits |
         detail::mortonCode({node.i & kInRegion, node.j & kInRegion, node.k & kInRegion});
}

Index3 nodeOf(std::uint64_t key) {
  const auto number = key >> 3 * kRegionBits;
  const auto first = [](std::uint64_t region) {
    return static_cast<std::int32_t>(region << kRegionBits);
  };
  const auto inRegion = detail::indexOf(key & ((std::uint64_t{1} << 3 * kRegionBits) - 1));
  return {first(number % kRegions) + inRegion.i, first(number / kRegions % kRegions) + inRegion.j,
          first(number / (kRegions * kRegions)) + inRegion.k};
}

/// Place of the first value that is not less, as by std::lower_bound(). It is probably close to
/// `near`, so the search starts there, with ever longer steps. (Bentley and Yao 1976, "An almost
/// optimal algorithm for unbounded searching".)
std::size_t seek(std::span<const std::uint64_t> sorted, std::uint64_t value, std::size_t near) {
  const auto size = sorted.size();
  std::size_t low = std::min(near, size);
  std::size_t high = low;
  if (high < size && sorted[high] < value) {
    for (std::size_t step = 1; high < size && sorted[high] < value; step *= 2) {
      low = high + 1;
      high += step;
    }
  } else {
    for (std::size_t step = 1; low > 0 && sorted[low - 1] >= value; step *= 2) {
      high = low - 1;
      low -= std::min(low, step);
    }
  }
  const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(low);
  const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(std::min(high, size));
  return static_cast<std::size_t>(std::lower_bound(first, last, value) - sorted.begin());
}

Index3 lowerCorner(const OctreeCell& cell, int deepest) {
  const int shift = deepest - cell.level;
  return {cell.index.i << shift, cell.index.j << shift, cell.index.k << shift};
}

/// Where the search for each corner starts: the same corner of the next cell is mostly near.
std::array<std::size_t, 8> allAt(std::size_t place) {
  std::array<std::size_t, 8> places{};
  places.fill(place);
  return places;
}

}  // namespace

template <std::floating_point T>
OctreeNodes<T>::OctreeNodes(const OctreeCells<T>& mesh, const ParallelOptions& options)
    : mesh_(mesh),
      level_(mesh.domain().origin(), mesh.domain().level(mesh.deepest()).spacing(),
             Centering::Node),
      places_(mesh.cells().size()) {
  const auto& last = mesh.domain().indices(mesh.deepest()).hi;
  size_ = {last.i + 1, last.j + 1, last.k + 1};
  std::ranges::transform(mesh.cells(), places_.begin(), [&](const OctreeCell& cell) {
    return detail::placeOf(cell, mesh.deepest());
  });
  std::mutex mutex;
  parallelFor(places_.size(),
              {.threads = options.threads, .grain = kGrain, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                std::vector<std::uint64_t> found;
                auto near = allAt(begin);
                for (auto n = begin; n < end; ++n) {
                  forCorners(n, [&](std::size_t corner, const Place& place) {
                    if (place.isInParent || cellFrom(place, near[corner]) != kNoCell) return;
                    found.push_back(keyOf(place.node));
                  });
                }
                detail::sortUnique(found);
                const std::lock_guard lock(mutex);
                others_.insert(others_.end(), found.begin(), found.end());
              });
  detail::sortUnique(others_);
  others_.shrink_to_fit();
}

template <std::floating_point T>
Index3 OctreeNodes<T>::index(std::size_t node) const {
  const auto cells = mesh_.cells();
  return node < cells.size() ? lowerCorner(cells[node], mesh_.deepest())
                             : nodeOf(others_[node - cells.size()]);
}

template <std::floating_point T>
void OctreeNodes<T>::corners(std::size_t firstCell, std::span<Corners> result) const {
  corners(
      result.size(), [=](std::size_t n) { return firstCell + n; }, result);
}

template <std::floating_point T>
void OctreeNodes<T>::corners(std::span<const std::size_t> cells, std::span<Corners> result) const {
  corners(
      cells.size(), [=](std::size_t n) { return cells[n]; }, result);
}

template <std::floating_point T>
template <typename CellAt>
void OctreeNodes<T>::corners(std::size_t count, const CellAt& cellAt,
                             std::span<Corners> result) const {
  if (count == 0) return;
  auto near = allAt(cellAt(0));
  auto nearOther = allAt(0);
  for (std::size_t n = 0; n < count; ++n) {
    result[n][0] = cellAt(n);
    forCorners(cellAt(n), [&](std::size_t corner, const Place& place) {
      auto& node = result[n][corner];
      node = cellFrom(place, near[corner]);
      if (node != kNoCell) return;
      nearOther[corner] = seek(others_, keyOf(place.node), nearOther[corner]);
      node = places_.size() + nearOther[corner];
    });
  }
}

template <std::floating_point T>
template <typename Visit>
void OctreeNodes<T>::forCorners(std::size_t n, const Visit& visit) const {
  // Every third bit of a code belongs to the same coordinate.
  constexpr MortonCode kFirst = 0x1249249249249249U;
  const auto& cell = mesh_.cells()[n];
  const int shift = mesh_.deepest() - cell.level;
  const auto child = static_cast<std::size_t>(places_[n] >> 3 * shift & 7U);  // of its parent
  std::array<Index3, 2> sides{lowerCorner(cell, mesh_.deepest()), {}};
  const std::int32_t width = 1 << shift;
  sides[1] = {sides[0].i + width, sides[0].j + width, sides[0].k + width};
  const std::size_t beyond = (sides[1].i == size_.i ? 1U : 0U) | (sides[1].j == size_.j ? 2U : 0U) |
                             (sides[1].k == size_.k ? 4U : 0U);
  for (std::size_t corner = 1; corner < 8; ++corner) {
    const auto x = corner & 1U;
    const auto y = corner >> 1U & 1U;
    const auto z = corner >> 2U;
    // Adds the width to a coordinate's bits; ones between them pass on the carry.
    const auto moved = [&](MortonCode bits, MortonCode step) {
      return ((places_[n] | ~bits) + step) & bits;
    };
    const MortonCode code = moved(kFirst, x << 3 * shift) |
                            moved(kFirst << 1U, y << 3 * shift << 1U) |
                            moved(kFirst << 2U, z << 3 * shift << 2U);
    visit(corner,
          Place{.node = {sides[x].i, sides[y].j, sides[z].k},
                .code = code,
                .isBeyond = (corner & beyond) != 0,
                .isInParent = cell.level > 0 && (corner & child) == 0 && code <= places_.back()});
  }
}

template <std::floating_point T>
std::size_t OctreeNodes<T>::cellFrom(const Place& place, std::size_t& near) const {
  if (place.isBeyond) return kNoCell;
  near = seek(places_, place.code, near);
  return near < places_.size() && places_[near] == place.code ? near : kNoCell;
}

template class OctreeNodes<float>;
template class OctreeNodes<double>;

}  // namespace cutwater
