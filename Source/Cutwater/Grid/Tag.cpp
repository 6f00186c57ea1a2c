#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/CellTagger.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>
#include <Cutwater/Grid/Tag.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Cells of a tile, which are tagged together.
constexpr detail::Offset kTile{8, 8, 4};
constexpr std::size_t kTileCells = std::size_t{kTile[0]} * kTile[1] * kTile[2];

template <std::floating_point T>
class Tagging {
 public:
  static_assert(kTileCells <= detail::CellTagger<T>::kMost);

  Tagging(const SignedDistanceFunction<T>& solid, const detail::CellTagger<T>& tagger,
          const GridPatch<T>& gridPatch, int level, const GridView<std::uint8_t>& tags)
      : solid_(solid),
        tagger_(tagger),
        gridPatch_(gridPatch),
        level_(level),
        tags_(tags),
        tiles_(gridPatch.indices, kTile) {}

  [[nodiscard]] std::size_t tileCount() const { return tiles_.count(); }

  void tagTile(std::size_t number) const {
    const auto tile = tiles_.tile(number);
    Scratch<Box<T>, kTileCells> cells;
    Box<T> around;
    std::size_t count = 0;
    forEach(tile, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      cells[count] = gridPatch_.level.cell(gridPatch_.indices.at(i, j, k));
      around.extend(cells[count++]);
    });
    // The hint found for all of them together helps with each one.
    BoxHint hint;
    static_cast<void>(solid_.classify(around, &hint));
    Scratch<BoxHint, kTileCells> hints;
    Scratch<detail::CellTag, kTileCells> cellTags;
    std::ranges::fill(hints.first(count), hint);
    tagger_.tag(level_, cells.first(count), hints.first(count), cellTags.first(count));
    count = 0;
    forEach(tile, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      tags_.at(i, j, k) = cellTags[count++].isRefined ? 1 : 0;
    });
  }

 private:
  template <typename Visit>
  static void forEach(const detail::OffsetBox& tile, const Visit& visit) {
    const auto& [first, size] = tile;
    for (auto k = first[2]; k < first[2] + size[2]; ++k) {
      for (auto j = first[1]; j < first[1] + size[1]; ++j) {
        for (auto i = first[0]; i < first[0] + size[0]; ++i) visit(i, j, k);
      }
    }
  }

  const SignedDistanceFunction<T>& solid_;
  const detail::CellTagger<T>& tagger_;
  const GridPatch<T>& gridPatch_;
  int level_;
  const GridView<std::uint8_t>& tags_;
  detail::GridTiles tiles_;
};

}  // namespace

template <std::floating_point T>
void tag(const Refinement<T>& refinement, const SignedDistanceFunction<T>& solid,
         const GridPatch<T>& gridPatch, int level, const GridView<std::uint8_t>& tags,
         const TagOptions& options) {
  require(level >= 0, "tag: need a level >= 0", Named{"level", level});
  require(options.threads >= 0, "tag: need threads >= 0", Named{"threads", options.threads});
  const detail::CellTagger<T> tagger(solid, refinement);
  const Tagging<T> tagging(solid, tagger, gridPatch, level, tags);
  parallelFor(tagging.tileCount(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto number = begin; number < end; ++number) tagging.tagTile(number);
              });
}

template void tag(const Refinement<float>&, const SignedDistanceFunction<float>&,
                  const GridPatch<float>&, int, const GridView<std::uint8_t>&, const TagOptions&);
template void tag(const Refinement<double>&, const SignedDistanceFunction<double>&,
                  const GridPatch<double>&, int, const GridView<std::uint8_t>&, const TagOptions&);

}  // namespace cutwater
