#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Scratch.hpp>
#include <Cutwater/Grid/Tag.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

/// Neighbouring cells of a patch that are judged together.
constexpr std::array<std::size_t, 3> kBlock{8, 8, 4};
constexpr std::size_t kBlockCells = kBlock[0] * kBlock[1] * kBlock[2];

template <std::floating_point T>
class Tagging {
 public:
  static_assert(kBlockCells <= CellJudge<T>::kMost);

  Tagging(const SignedDistanceFunction<T>& solid, const CellJudge<T>& judge, const Patch<T>& patch,
          int level, const GridView<std::uint8_t>& tags)
      : solid_(solid), judge_(judge), patch_(patch), level_(level), tags_(tags) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lengths_[axis] = patch.indices.length(static_cast<int>(axis));
      blocks_[axis] = (lengths_[axis] + kBlock[axis] - 1) / kBlock[axis];
    }
  }

  [[nodiscard]] std::size_t blockCount() const { return blocks_[0] * blocks_[1] * blocks_[2]; }

  void tagBlock(std::size_t number) const {
    std::array<std::size_t, 3> first{};
    std::array<std::size_t, 3> end{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = number % blocks_[axis] * kBlock[axis];
      number /= blocks_[axis];
      end[axis] = std::min(first[axis] + kBlock[axis], lengths_[axis]);
    }
    Scratch<Box<T>, kBlockCells> cells;
    Box<T> around;
    std::size_t count = 0;
    forEach(first, end, [&](std::size_t i, std::size_t j, std::size_t k) {
      cells[count] = patch_.level.cell(indexAt(i, j, k));
      around.extend(cells[count++]);
    });
    // What is found out about all of them helps with each.
    BoxHint hint;
    static_cast<void>(solid_.classify(around, &hint));
    Scratch<BoxHint, kBlockCells> hints;
    Scratch<CellVerdict, kBlockCells> verdicts;
    std::ranges::fill(hints.first(count), hint);
    judge_.judge(level_, cells.first(count), hints.first(count), verdicts.first(count));
    count = 0;
    forEach(first, end, [&](std::size_t i, std::size_t j, std::size_t k) {
      tags_.at(i, j, k) = verdicts[count++].isRefined ? 1 : 0;
    });
  }

 private:
  template <typename Visit>
  static void forEach(const std::array<std::size_t, 3>& first,
                      const std::array<std::size_t, 3>& end, const Visit& visit) {
    for (auto k = first[2]; k < end[2]; ++k) {
      for (auto j = first[1]; j < end[1]; ++j) {
        for (auto i = first[0]; i < end[0]; ++i) visit(i, j, k);
      }
    }
  }
  [[nodiscard]] Index3 indexAt(std::size_t i, std::size_t j, std::size_t k) const {
    const auto& lo = patch_.indices.lo;
    const auto sum = [](std::int32_t a, std::size_t b) {
      return static_cast<std::int32_t>(a + static_cast<std::int64_t>(b));
    };
    return {sum(lo.i, i), sum(lo.j, j), sum(lo.k, k)};
  }

  const SignedDistanceFunction<T>& solid_;
  const CellJudge<T>& judge_;
  const Patch<T>& patch_;
  int level_;
  const GridView<std::uint8_t>& tags_;
  std::array<std::size_t, 3> lengths_{};
  std::array<std::size_t, 3> blocks_{};
};

}  // namespace

template <std::floating_point T>
void tag(const Refinement<T>& refinement, const SignedDistanceFunction<T>& solid,
         const Patch<T>& patch, int level, const GridView<std::uint8_t>& tags,
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
                  const Patch<float>&, int, const GridView<std::uint8_t>&, const TagOptions&);
template void tag(const Refinement<double>&, const SignedDistanceFunction<double>&,
                  const Patch<double>&, int, const GridView<std::uint8_t>&, const TagOptions&);

}  // namespace cutwater
