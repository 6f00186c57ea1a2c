#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/CellPatches.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Cells that a thread processes in one go.
constexpr std::size_t kTogether = 1024;

/// The rows of some neighbouring cells.
struct Rows {
  std::vector<std::size_t> lengths;
  std::vector<std::uint32_t> patches;
  bool isComplete = true;
};

/// Adds the row of a cell.
template <std::floating_point T>
void addRow(const SignedDistanceFunction<T>& solid, const Box<T>& box, Rows& rows) {
  auto& patches = rows.patches;
  const auto begin = static_cast<std::ptrdiff_t>(patches.size());
  const bool isAll = solid.facetsIn(box, [&](const SurfaceFacet<T>& facet) {
    // There is mostly one patch, and never many.
    const auto place = std::lower_bound(patches.begin() + begin, patches.end(), facet.owner.patch);
    if (place == patches.end() || *place != facet.owner.patch) {
      patches.insert(place, facet.owner.patch);
    }
    return true;
  });
  rows.isComplete = rows.isComplete && isAll;
  rows.lengths.push_back(patches.size() - static_cast<std::size_t>(begin));
}

template <std::floating_point T>
Rows rowsOf(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
            std::span<const OctreeCell> cells) {
  Rows rows;
  rows.lengths.reserve(cells.size());
  for (const auto& cell : cells) {
    if (mayBeCut(cell.kind)) {
      addRow(solid, mesh.box(cell), rows);
    } else {
      rows.lengths.push_back(0);
    }
  }
  return rows;
}

}  // namespace

template <std::floating_point T>
CellPatches cellPatches(const SignedDistanceFunction<T>& solid, const OctreeCells<T>& mesh,
                        const CellPatchesOptions& options) {
  require(options.threads >= 0, "cellPatches: need threads >= 0",
          Named{"threads", options.threads});
  const auto cells = mesh.cells();
  std::vector<Rows> parts((cells.size() + kTogether - 1) / kTogether);
  detail::parallelBatches(
      cells.size(), kTogether, {.threads = options.threads, .progress = options.progress},
      [&](std::size_t first, std::size_t count) {
        parts[first / kTogether] = rowsOf(solid, mesh, cells.subspan(first, count));
      });
  CellPatches result;
  result.offsets.reserve(cells.size() + 1);
  for (const auto& part : parts) {
    for (const auto length : part.lengths) {
      result.offsets.push_back(result.offsets.back() + length);
    }
    result.patches.insert(result.patches.end(), part.patches.begin(), part.patches.end());
    result.isComplete = result.isComplete && part.isComplete;
  }
  return result;
}

template CellPatches cellPatches(const SignedDistanceFunction<float>&, const OctreeCells<float>&,
                                 const CellPatchesOptions&);
template CellPatches cellPatches(const SignedDistanceFunction<double>&, const OctreeCells<double>&,
                                 const CellPatchesOptions&);

}  // namespace cutwater
