#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/PatchBlocks.hpp>
#include <Cutwater/Grid/Tag.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Neighbouring cells of a patch that are judged together.
constexpr detail::Offset kBlock{8, 8, 4};
constexpr std::size_t kBlockCells = std::size_t{kBlock[0]} * kBlock[1] * kBlock[2];

template <std::floating_point T>
class Tagging {
 public:
  static_assert(kBlockCells <= CellJudge<T>::kMost);

  Tagging(const SignedDistanceFunction<T>& solid, const CellJudge<T>& judge,
          const GridPatch<T>& patch, int level, const GridView<std::uint8_t>& tags)
      : solid_(solid),
        judge_(judge),
        patch_(patch),
        level_(level),
        tags_(tags),
        blocks_(patch.indices, kBlock) {}

  [[nodiscard]] std::size_t blockCount() const { return blocks_.count(); }

  void tagBlock(std::size_t number) const {
    const auto block = blocks_.block(number);
    Scratch<Box<T>, kBlockCells> cells;
    Box<T> around;
    std::size_t count = 0;
    forEach(block, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      cells[count] = patch_.level.cell(patch_.indices.at(i, j, k));
      around.extend(cells[count++]);
    });
    // The hint found for all of them together helps with each one.
    BoxHint hint;
    static_cast<void>(solid_.classify(around, &hint));
    Scratch<BoxHint, kBlockCells> hints;
    Scratch<CellVerdict, kBlockCells> verdicts;
    std::ranges::fill(hints.first(count), hint);
    judge_.judge(level_, cells.first(count), hints.first(count), verdicts.first(count));
    count = 0;
    forEach(block, [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
      tags_.at(i, j, k) = verdicts[count++].isRefined ? 1 : 0;
    });
  }

 private:
  template <typename Visit>
  static void forEach(const detail::GridBlock& block, const Visit& visit) {
    const auto& [first, size] = block;
    for (auto k = first[2]; k < first[2] + size[2]; ++k) {
      for (auto j = first[1]; j < first[1] + size[1]; ++j) {
        for (auto i = first[0]; i < first[0] + size[0]; ++i) visit(i, j, k);
      }
    }
  }

  const SignedDistanceFunction<T>& solid_;
  const CellJudge<T>& judge_;
  const GridPatch<T>& patch_;
  int level_;
  const GridView<std::uint8_t>& tags_;
  detail::PatchBlocks blocks_;
};

}  // namespace

template <std::floating_point T>
void tag(const Refinement<T>& refinement, const SignedDistanceFunction<T>& solid,
         const GridPatch<T>& patch, int level, const GridView<std::uint8_t>& tags,
         const TagOptions& options) {
  require(level >= 0, "tag: need a level >= 0", Named{"level", level});
  require(options.threads >= 0, "tag: need threads >= 0", Named{"threads", options.threads});
  const CellJudge<T> judge(solid, refinement);
  const Tagging<T> tagging(solid, judge, patch, level, tags);
  parallelFor(tagging.blockCount(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto number = begin; number < end; ++number) tagging.tagBlock(number);
              });
}

template void tag(const Refinement<float>&, const SignedDistanceFunction<float>&,
                  const GridPatch<float>&, int, const GridView<std::uint8_t>&, const TagOptions&);
template void tag(const Refinement<double>&, const SignedDistanceFunction<double>&,
                  const GridPatch<double>&, int, const GridView<std::uint8_t>&, const TagOptions&);

}  // namespace cutwater
