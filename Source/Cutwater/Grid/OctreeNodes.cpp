#include <Cutwater/Grid/OctreeNodes.hpp>

#include <algorithm>
#include <mutex>

namespace cutwater {

namespace {

/// Cells that are looked at in one go.
constexpr std::size_t kGrain = std::size_t{1} << 14U;

/// A node has one index more along each axis than there are cells, too many for a Morton code:
/// blocks of 2^18 nodes row by row, at most nine along each axis, and codes within a block.
constexpr int kBlockBits = 18;
constexpr std::int32_t kInBlock = (1 << kBlockBits) - 1;
constexpr std::uint64_t kBlocks = (std::uint64_t{1} << (kMortonBits - kBlockBits)) + 1;

std::uint64_t keyOf(const Index3& node) {
  const auto block = [](std::int32_t i) { return static_cast<std::uint64_t>(i >> kBlockBits); };
  const auto number = block(node.i) + kBlocks * (block(node.j) + kBlocks * block(node.k));
  return number << 3 * kBlockBits |
         mortonCode({node.i & kInBlock, node.j & kInBlock, node.k & kInBlock});
}

Index3 nodeOf(std::uint64_t key) {
  const auto number = key >> 3 * kBlockBits;
  const auto first = [](std::uint64_t block) {
    return static_cast<std::int32_t>(block << kBlockBits);
  };
  const auto inBlock = indexOf(key & ((std::uint64_t{1} << 3 * kBlockBits) - 1));
  return {first(number % kBlocks) + inBlock.i, first(number / kBlocks % kBlocks) + inBlock.j,
          first(number / (kBlocks * kBlocks)) + inBlock.k};
}

/// Place of the first value that is not less, as std::lower_bound(), which is likely near `near`:
/// that is approached by ever longer steps. (Bentley and Yao 1976, "An almost optimal algorithm for
/// unbounded searching".)
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

void sortUnique(std::vector<std::uint64_t>& values) {
  std::ranges::sort(values);
  values.erase(std::ranges::unique(values).begin(), values.end());
}

Index3 lowerCorner(const OctreeCell& cell, int deepest) {
  const int shift = deepest - cell.level;
  return {cell.index.i << shift, cell.index.j << shift, cell.index.k << shift};
}

}  // namespace

template <std::floating_point T>
OctreeNodes<T>::OctreeNodes(const Octree<T>& mesh, const ParallelOptions& options)
    : mesh_(mesh),
      level_(mesh.domain().origin(), mesh.domain().level(mesh.deepest()).spacing(),
             Centering::Node),
      places_(mesh.cells().size()) {
  const auto& last = mesh.domain().indices(mesh.deepest()).hi;
  size_ = {last.i + 1, last.j + 1, last.k + 1};
  std::ranges::transform(mesh.cells(), places_.begin(), [&](const OctreeCell& cell) {
    return mortonCode(lowerCorner(cell, mesh.deepest()));
  });
  std::mutex mutex;
  parallelFor(places_.size(),
              {.threads = options.threads, .grain = kGrain, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                std::vector<std::uint64_t> found;
                forCorners(begin, end, [&](auto, auto, const Index3& node, std::size_t cell) {
                  if (cell == kNoCell) found.push_back(keyOf(node));
                });
                sortUnique(found);
                const std::lock_guard lock(mutex);
                others_.insert(others_.end(), found.begin(), found.end());
              });
  sortUnique(others_);
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
  std::array<std::size_t, 8> near{};
  forCorners(firstCell, firstCell + result.size(),
             [&](std::size_t n, std::size_t corner, const Index3& node, std::size_t cell) {
               if (cell == kNoCell) {
                 near[corner] = seek(others_, keyOf(node), near[corner]);
                 cell = places_.size() + near[corner];
               }
               result[n - firstCell][corner] = cell;
             });
}

template <std::floating_point T>
template <typename Visit>
void OctreeNodes<T>::forCorners(std::size_t begin, std::size_t end, const Visit& visit) const {
  // The same corner of the next cell is mostly near.
  std::array<std::size_t, 8> near{};
  near.fill(begin);
  for (auto n = begin; n < end; ++n) {
    const auto& cell = mesh_.cells()[n];
    const auto lower = lowerCorner(cell, mesh_.deepest());
    const std::int32_t width = 1 << (mesh_.deepest() - cell.level);
    visit(n, std::size_t{0}, lower, n);
    for (std::size_t corner = 1; corner < 8; ++corner) {
      const Index3 node{lower.i + ((corner & 1U) != 0 ? width : 0),
                        lower.j + ((corner & 2U) != 0 ? width : 0),
                        lower.k + ((corner & 4U) != 0 ? width : 0)};
      visit(n, corner, node, cellFrom(node, near[corner]));
    }
  }
}

template <std::floating_point T>
std::size_t OctreeNodes<T>::cellFrom(const Index3& node, std::size_t& near) const {
  if (node.i == size_.i || node.j == size_.j || node.k == size_.k) return kNoCell;
  const auto code = mortonCode(node);
  near = seek(places_, code, near);
  return near < places_.size() && places_[near] == code ? near : kNoCell;
}

template class OctreeNodes<float>;
template class OctreeNodes<double>;

}  // namespace cutwater
