#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallFaces.hpp>
#include <Cutwater/CutCells/Detail/Rows/CoarseNodes.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

CoarseNodes::Place placeOf(const Index3& index) {
  return {index.i, index.j, index.k};
}

Index3 indexOf(const CoarseNodes::Place& place) {
  return {static_cast<std::int32_t>(place[0]), static_cast<std::int32_t>(place[1]),
          static_cast<std::int32_t>(place[2])};
}

Index3 stepped(const Index3& cell, std::size_t axis, int step) {
  auto place = placeOf(cell);
  place[axis] += step;
  return indexOf(place);
}

}  // namespace

CoarseNodes::CoarseNodes(const CutCells& fine, const std::array<int, 3>& ratios,
                         const SpannedAxes& spanned)
    : fine_(fine),
      box_(fine.grid.indices()),
      spanned_(spanned),
      ratios_{ratios[0], ratios[1], ratios[2]} {
  makeGrid();
  findRows();
  addNodes();
}

CoarseNodes::Place CoarseNodes::coarse(const Place& fine) const {
  Place result{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto ratio = ratios_[axis];
    result[axis] = (fine[axis] - (fine[axis] < 0 ? ratio - 1 : 0)) / ratio;
  }
  return result;
}

void CoarseNodes::makeGrid() {
  const auto& planes = fine_.grid.planes;
  const auto first = placeOf(box_.lo);
  std::array<std::vector<double>, 3> kept;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto ratio = ratios_[axis];
    const auto cells = static_cast<std::int64_t>(planes[axis].size()) - 3;
    require(ratio >= 1 && first[axis] % ratio == 0 && cells % ratio == 0,
            "coarsened: need a box that begins and ends at coarse cells", Named{"axis", axis},
            Named{"first", first[axis]}, Named{"cells", cells}, Named{"ratio", ratio});
    for (std::int64_t n = 0; n <= cells; n += ratio) {
      kept[axis].push_back(planes[axis][static_cast<std::size_t>(n + 1)]);
    }
  }
  coarse_.grid = cellsBetween(kept, indexOf(coarse(first)));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto period = fine_.grid.period[axis];
    const auto ratio = static_cast<std::int32_t>(ratios_[axis]);
    coarse_.grid.period[axis] = period % ratio == 0 ? period / ratio : 0;
    if (!spanned_[axis]) continue;
    auto& coarsePlanes =
        coarse_.grid.planes[axis];  // the cells around the box are those of its ends
    const auto& own = kept[axis];
    coarsePlanes.front() = own.front() - (own.back() - own[own.size() - 2]);
    coarsePlanes.back() = own.back() + (own[1] - own[0]);
  }
}

/// Coarse cells are cut if one of theirs is: a wall in a plane of the grid is that of a fine cell.
void CoarseNodes::findRows() {
  auto& index = coarse_.cells.index;
  for (std::size_t row = 0; row < fine_.cellCount; ++row) {
    index.push_back(indexOf(coarse(placeOf(fine_.cells.index[row]))));
  }
  std::ranges::sort(index, {}, [](const Index3& at) { return std::tuple(at.k, at.j, at.i); });
  index.erase(std::unique(index.begin(), index.end()), index.end());
  coarse_.cellCount = index.size();
}

std::size_t CoarseNodes::numberWithin(const Place& fine) const {
  const auto cell = coarse(fine);
  std::int64_t number = 0;
  for (std::size_t axis = 3; axis-- > 0;) {
    number = number * ratios_[axis] + fine[axis] - ratios_[axis] * cell[axis];
  }
  return static_cast<std::size_t>(number);
}

Index3 CoarseNodes::firstOf(const Index3& coarse) const {
  auto place = placeOf(coarse);
  for (std::size_t axis = 0; axis < 3; ++axis) place[axis] *= ratios_[axis];
  return indexOf(place);
}

Index3 CoarseNodes::fineCell(std::uint32_t row, std::size_t number) const {
  auto place = placeOf(firstOf(cells()[row]));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto ratio = static_cast<std::size_t>(ratios_[axis]);
    place[axis] += static_cast<std::int64_t>(number % ratio);
    number /= ratio;
  }
  return indexOf(place);
}

unsigned CoarseNodes::outerFaces(std::uint32_t node) const {
  auto number = nodes_[node].number;
  unsigned faces = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto ratio = static_cast<std::size_t>(ratios_[axis]);
    const auto along = number % ratio;
    number /= ratio;
    if (along == 0) faces |= bitOfFace(static_cast<int>(axis), false);
    if (along + 1 == ratio) faces |= bitOfFace(static_cast<int>(axis), true);
  }
  return faces;
}

void CoarseNodes::addNodes() {
  perCell_ = static_cast<std::size_t>(ratios_[0] * ratios_[1] * ratios_[2]);
  nodes_.resize(fine_.pieceCount);
  for (std::uint32_t piece = 0; piece < fine_.pieceCount; ++piece) {
    const auto cell = placeOf(fine_.cells.index[fine_.pieces.cell[piece]]);
    nodes_[piece] = {coarse_.rowOf(indexOf(coarse(cell))), numberWithin(cell)};
  }
  whole_.assign(cells().size() * perCell_, CutCells::kWholeCell);
  for (std::uint32_t row = 0; row < cells().size(); ++row) {
    for (std::size_t number = 0; number < perCell_; ++number) {
      if (fine_.classOf(fineCell(row, number)) != FluidClass::Fluid) continue;
      whole_[row * perCell_ + number] = count();
      nodes_.push_back({row, number});
    }
  }
}

/// The node of a fine cell that is not cut; kWholeCell where the coarse cell is not cut either.
std::uint32_t CoarseNodes::wholeNode(const Index3& cell) const {
  const auto row = coarse_.rowOf(indexOf(coarse(placeOf(cell))));
  return row == CutCells::kNoRow ? CutCells::kWholeCell
                                 : whole_[row * perCell_ + numberWithin(placeOf(cell))];
}

CoarseNodes::Face CoarseNodes::faceBelow(const Index3& cell, int axis) const {
  const auto a = static_cast<std::size_t>(axis);
  const auto place = placeOf(cell);
  return {.cell = indexOf(coarse(place)),
          .isBetween = place[a] % ratios_[a] == 0,
          .axis = axis,
          .below = CutCells::kBeyond,
          .above = CutCells::kBeyond,
          .area = 0,
          .centroid = {},
          .fine = cell,
          .arc = CutCells::kNoRow};
}

void CoarseNodes::forFaces(FunctionRef<void(const Face&)> visit) const {
  const auto& arcs = fine_.arcs;
  for (std::uint32_t a = 0; a < arcs.area.size(); ++a) {
    const auto nodeOf = [&](const Index3& beside, std::uint32_t piece) {
      const auto cell = inPeriod(fine_.grid, spanned_, beside);
      if (!box_.contains(cell)) return CutCells::kBeyond;
      return piece == CutCells::kWholeCell ? wholeNode(cell) : piece;
    };
    auto face = faceBelow(arcs.cell[a], arcs.axis[a]);
    face.below = nodeOf(stepped(arcs.cell[a], arcs.axis[a], -1), arcs.below[a]);
    face.above = nodeOf(arcs.cell[a], arcs.above[a]);
    face.area = arcs.area[a];
    face.centroid = arcs.centroid[a];
    face.arc = a;
    const bool leadsOut = face.below == CutCells::kBeyond || face.above == CutCells::kBeyond;
    require(face.isBetween || !leadsOut,
            "coarsened: need open patches in planes between coarse cells", Named{"axis", face.axis},
            Named{"centroid", face.centroid});
    visit(face);
  }
  for (auto node = static_cast<std::uint32_t>(fine_.pieceCount); node < count(); ++node) {
    forFacesOfWhole(node, visit);
  }
}

/// The faces of a whole cell to other whole cells, or beyond the box: no arc says that they are
/// open.
void CoarseNodes::forFacesOfWhole(std::uint32_t node, FunctionRef<void(const Face&)> visit) const {
  const auto cell = cellOf(node);
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isAbove : {false, true}) {
      const auto next = inPeriod(fine_.grid, spanned_,
                                 stepped(cell, static_cast<std::size_t>(axis), isAbove ? 1 : -1));
      auto other = CutCells::kBeyond;
      if (box_.contains(next)) {
        if (fine_.rowOf(next) != CutCells::kNoRow) continue;
        other = wholeNode(next);
        if (isAbove && other != CutCells::kWholeCell) continue;  // that node has the face, too
      }
      auto face = faceBelow(isAbove ? next : cell, axis);
      face.below = isAbove ? node : other;
      face.above = isAbove ? other : node;
      face.area = fine_.faceArea(cell, axis);
      face.centroid = fine_.boxOf(cell).center();
      face.centroid[axis] = fine_.boxOf(isAbove ? next : cell).lower[axis];
      visit(face);
    }
  }
}

}  // namespace cutwater
