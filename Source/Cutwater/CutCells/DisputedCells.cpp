#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapAngles.hpp>

#include <algorithm>
#include <optional>
#include <tuple>

namespace cutwater {

namespace {

/// Finds out whether caps and the winding number of the open surface may disagree in a box, which
/// is in the frame of the surface.
class DisputeSearch {
 public:
  DisputeSearch(const CapAngles& angles, bool isFluidInside)
      : angles_(angles), within_(isFluidInside ? FluidClass::Fluid : FluidClass::Body) {}

  /// Whether they may anywhere.
  [[nodiscard]] bool mayBeIn(const Box<double>& box) const {
    return angles_.in(box, {}) != Disagreement::None;
  }
  /// Whether they may in a cell of this class.
  [[nodiscard]] bool isIn(const Box<double>& cell, FluidClass found) const {
    return isIn(cell,
                {.inside = found == FluidClass::Cut || found == within_,
                 .outside = found == FluidClass::Cut || found != within_},
                kHalvings);
  }

 private:
  /// How often a cell is halved before it is one because nothing else is known.
  static constexpr int kHalvings = 9;

  [[nodiscard]] bool isIn(const Box<double>& box, CapAngles::Sides sides, int halvings) const {
    const auto found = angles_.in(box, sides);
    if (found != Disagreement::Possible || halvings == 0) return found != Disagreement::None;
    const auto size = box.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    Box<double> lower = box;
    Box<double> upper = box;
    lower.upper[axis] = upper.lower[axis] = box.center()[axis];
    return isIn(lower, sides, halvings - 1) || isIn(upper, sides, halvings - 1);
  }

  const CapAngles& angles_;
  FluidClass within_;  // of a cell that is all in the body that the surface bounds
};

/// Finds the cells of a grid that are.
class GridDisputes {
 public:
  /// `z`: what lies there counts of each cell, and nothing else.
  GridDisputes(const CutCells& cells, const CutFrame& frame, const DisputeSearch& search,
               std::optional<double> z)
      : cells_(cells), frame_(frame), search_(search), z_(z) {}

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
      if (search_.isIn(boxOf(box), cells_.classOf(box.lo))) result.push_back(box.lo);
    });
  }

 private:
  /// Visits boxes of at most so many cells, but for those that certainly have none.
  template <typename Visit>
  void visit(const IndexBox& box, std::size_t most, const Visit& take) const {
    if (box.empty() || !search_.mayBeIn(boxOf(box))) return;
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

  [[nodiscard]] Box<double> boxOf(const IndexBox& indices) const {
    Box<double> box{cells_.boxOf(indices.lo).lower, cells_.boxOf(indices.hi).upper};
    if (z_) box.lower.z = box.upper.z = *z_;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = frame_.toFrame(axis, box.lower[axis]);
      box.upper[axis] = frame_.toFrame(axis, box.upper[axis]);
    }
    return box;
  }

  const CutCells& cells_;
  const CutFrame& frame_;
  const DisputeSearch& search_;
  std::optional<double> z_;
};

/// `caps`: null if there are none. `z`: see GridDisputes.
std::vector<Index3> disputedOf(const CutCells& cells, const CutSurface& surface,
                               const CapAngles* caps, std::optional<double> z,
                               const ParallelOptions& options) {
  if (caps == nullptr) return {};
  const DisputeSearch search(*caps, surface.windingOutside() == 1);
  const GridDisputes grid(cells, surface.frame(), search, z);
  const auto blocks = grid.blocks();
  std::vector<std::vector<Index3>> found(blocks.size());
  parallelFor(blocks.size(), options, [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) grid.addCells(blocks[n], found[n]);
  });
  std::vector<Index3> result;
  for (const auto& part : found) result.insert(result.end(), part.begin(), part.end());
  std::ranges::sort(result, {},
                    [](const Index3& cell) { return std::tuple(cell.k, cell.j, cell.i); });
  return result;
}

}  // namespace

std::vector<Index3> CellCutter::disputedCells(const CutCells& cells,
                                              const ParallelOptions& options) const {
  const auto& period = surface_->period();
  require(!period.isOnAny(), "cut cells: the winding number of a surface has no period",
          Named{"period", period.length});
  return disputedOf(cells, *surface_, caps_.get(), {}, options);
}

std::vector<Index3> CellCutter::disputedCellsInPlane(const CutCells& cells, double z,
                                                     const ParallelOptions& options) const {
  return disputedOf(cells, *surface_, caps_.get(), z, options);
}

template <std::floating_point T>
std::vector<std::uint32_t> CellCutter::disputedLeaves(const CutLeaves& leaves,
                                                      const OctreeCells<T>& mesh,
                                                      const ParallelOptions& options) const {
  const std::size_t count = mesh.cells().size();
  require(leaves.classes.size() == count, "disputedLeaves: need the mesh of these leaves",
          Named{"leaves", leaves.classes.size()}, Named{"cells", count});
  if (caps_ == nullptr) return {};
  const LeafGrid grid(mesh, surface_->frame());
  const DisputeSearch search(*caps_, surface_->windingOutside() == 1);
  std::vector<std::uint8_t> isDisputed(count);
  parallelFor(count, options, [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) {
      const auto leaf = static_cast<std::uint32_t>(n);
      isDisputed[n] = search.isIn(grid.boxInFrame(leaf), leaves.classes[n]) ? 1 : 0;
    }
  });
  std::vector<std::uint32_t> result;
  for (std::uint32_t n = 0; n < count; ++n) {
    if (isDisputed[n] != 0) result.push_back(n);
  }
  return result;
}

template std::vector<std::uint32_t> CellCutter::disputedLeaves(const CutLeaves&,
                                                               const OctreeCells<float>&,
                                                               const ParallelOptions&) const;
template std::vector<std::uint32_t> CellCutter::disputedLeaves(const CutLeaves&,
                                                               const OctreeCells<double>&,
                                                               const ParallelOptions&) const;

}  // namespace cutwater
