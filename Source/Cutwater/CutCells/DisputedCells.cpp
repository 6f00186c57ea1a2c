#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapAngles.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

/// Finds the cells in which caps and the winding number of the open surface may disagree.
class DisputeSearch {
 public:
  DisputeSearch(const CutCells& cells, const CutSurface& surface, const CapAngles& angles)
      : cells_(cells), surface_(surface), angles_(angles) {}

  /// Blocks of a few cells that may have some.
  [[nodiscard]] std::vector<IndexBox> blocks() const {
    constexpr std::size_t kFewCells = 256;
    std::vector<IndexBox> result;
    visit(cells_.grid.indices(), kFewCells, [&](const IndexBox& box) { result.push_back(box); });
    return result;
  }
  /// Appends the cells of a block that are.
  void addCells(const IndexBox& block, std::vector<Index3>& result) const {
    visit(block, 1, [&](const IndexBox& box) {
      if (isDisputed(boxOf(box), sidesOf(box.lo), kHalvings)) result.push_back(box.lo);
    });
  }

 private:
  /// How often a cell is halved before it is one because nothing else is known.
  static constexpr int kHalvings = 9;

  /// Visits boxes of at most so many cells, but for those that certainly have none.
  template <typename Visit>
  void visit(const IndexBox& box, std::size_t most, const Visit& take) const {
    if (box.empty() || angles_.in(boxOf(box), {}) == Disagreement::None) return;
    if (box.count() <= most) {
      take(box);
      return;
    }
    const auto longer = [&](int a, int b) { return box.length(a) < box.length(b) ? b : a; };
    const int axis = longer(longer(0, 1), 2);
    IndexBox lower = box;
    IndexBox upper = box;
    const auto middle = static_cast<std::int32_t>(box.length(axis) / 2);
    along(upper.lo, axis) += middle;
    along(lower.hi, axis) = along(upper.lo, axis) - 1;
    visit(lower, most, take);
    visit(upper, most, take);
  }

  /// In the frame of the surface.
  [[nodiscard]] Box<double> boxOf(const IndexBox& indices) const {
    Box<double> box{cells_.boxOf(indices.lo).lower, cells_.boxOf(indices.hi).upper};
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = surface_.frame().toFrame(axis, box.lower[axis]);
      box.upper[axis] = surface_.frame().toFrame(axis, box.upper[axis]);
    }
    return box;
  }

  [[nodiscard]] CapAngles::Sides sidesOf(const Index3& cell) const {
    const auto found = cells_.classOf(cell);
    const bool isFluidInside = surface_.windingOutside() == 1;
    const auto within = isFluidInside ? FluidClass::Fluid : FluidClass::Body;
    return {.inside = found == FluidClass::Cut || found == within,
            .outside = found == FluidClass::Cut || found != within};
  }

  [[nodiscard]] bool isDisputed(const Box<double>& box, CapAngles::Sides sides,
                                int halvings) const {
    const auto found = angles_.in(box, sides);
    if (found != Disagreement::Possible || halvings == 0) return found != Disagreement::None;
    const auto size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Box<double> lower = box;
    Box<double> upper = box;
    lower.upper[axis] = upper.lower[axis] = box.center()[axis];
    return isDisputed(lower, sides, halvings - 1) || isDisputed(upper, sides, halvings - 1);
  }

  const CutCells& cells_;
  const CutSurface& surface_;
  const CapAngles& angles_;
};

}  // namespace

std::vector<Index3> CellCutter::disputedCells(const CutCells& cells,
                                              const ParallelOptions& options) const {
  const auto& period = surface_->period();
  require(!period.isOnAny(), "cut cells: the winding number of a surface has no period",
          Named{"period", period.length});
  if (caps_ == nullptr) return {};
  const DisputeSearch search(cells, *surface_, *caps_);
  const auto blocks = search.blocks();
  std::vector<std::vector<Index3>> found(blocks.size());
  parallelFor(blocks.size(), options, [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) search.addCells(blocks[n], found[n]);
  });
  std::vector<Index3> result;
  for (const auto& part : found) result.insert(result.end(), part.begin(), part.end());
  std::ranges::sort(result, {},
                    [](const Index3& cell) { return std::tuple(cell.k, cell.j, cell.i); });
  return result;
}

}  // namespace cutwater
