#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/CutCells/Detail/Rows/ArcSources.hpp>

#include <algorithm>
#include <numeric>

namespace cutwater {

namespace {

void addSources(std::uint32_t tile, const TilePlace& firstCell, const TileCut& cut,
                const GrownBox& box, std::vector<ArcSource>& to) {
  std::vector<std::uint32_t> seen(cut.numbers.faceCount());
  for (std::uint32_t i = 0; i < cut.content.arcs.size(); ++i) {
    const auto& arc = cut.content.arcs[i];
    if (arc.isNothing) continue;
    const auto axis = static_cast<std::uint64_t>(cut.numbers.axisOfFace(arc.face));
    const auto place = placeIn(firstCell, cut.numbers.placeOfFace(arc.face));
    auto number = seen[arc.face]++;
    if (arc.isOpenPatch()) {
      number += arc.below != kNone ? ArcSource::kLeadsUp : ArcSource::kLeadsDown;
    }
    to.push_back(
        {.face = 3 * box.numberOf(place) + axis, .number = number, .tile = tile, .arc = i});
  }
}

/// Layer by layer, in parallel.
void sortSources(const GrownBox& box, int threads, std::vector<ArcSource>& sources) {
  const auto inLayer = 3 * box.numberOf({0, 0, 1});
  const auto layers = asIndex(box.cells()[2]) + 3;
  std::vector<std::size_t> first(layers + 1);
  for (const auto& source : sources) ++first[source.face / inLayer + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<ArcSource> sorted(sources.size());
  auto next = first;
  for (const auto& source : sources) sorted[next[source.face / inLayer]++] = source;
  sources = std::move(sorted);
  const std::span all(sources);
  parallelFor(layers, {.threads = threads, .grain = 8}, [&](std::size_t begin, std::size_t end) {
    for (auto layer = begin; layer < end; ++layer) {
      const auto here = all.subspan(first[layer], first[layer + 1] - first[layer]);
      std::sort(here.begin(), here.end());
    }
  });
}

}  // namespace

std::vector<ArcSource> arcSourcesOf(const CutBlocks& tiles,
                                    std::span<const std::unique_ptr<const TileCut>> tileCuts,
                                    const GrownBox& box, int threads) {
  std::vector<ArcSource> sources;
  std::size_t count = 0;
  for (const auto& cut : tileCuts) count += cut ? cut->content.arcs.size() : 0;
  sources.reserve(count);
  for (std::uint32_t tile = 0; tile < tileCuts.size(); ++tile) {
    if (tileCuts[tile]) addSources(tile, tiles.firstCell(tile), *tileCuts[tile], box, sources);
  }
  sortSources(box, threads, sources);
  return sources;
}

}  // namespace cutwater
