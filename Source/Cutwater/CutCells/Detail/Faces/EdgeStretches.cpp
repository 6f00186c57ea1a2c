#include <Cutwater/CutCells/Detail/Faces/EdgeStretches.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace cutwater {

namespace {

/// Takes crossings away that are those of no walls; returns whether there were any.
bool hidesBuried(const TileSurface& surface, std::vector<EdgeCrossing>& crossings) {
  return std::erase_if(crossings, [&](const EdgeCrossing& crossing) {
           return surface.kindOf(crossing.triangle) == SheetKind::Buried;
         }) > 0;
}

}  // namespace

EdgeStretches::EdgeStretches(const TileSurface& surface, const GridPlanes& planes, int winding,
                             std::span<const std::int32_t> windings)
    : numbers_(surface.numbers()), windings_(windings.begin(), windings.end()) {
  if (windings.empty()) setWindings(surface, winding);
  setStretches(surface, planes);
}

void EdgeStretches::setWindings(const TileSurface& surface, int winding) {
  std::vector<std::int32_t> rises(numbers_.edgeCount());
  for (const auto& crossing : surface.crossings()) rises[crossing.edge] += crossing.rise;
  windings_.resize(numbers_.nodeCount());
  windings_[0] = winding;
  const auto& cells = numbers_.cells();
  forTilePlaces({cells[0] + 1, cells[1] + 1, cells[2] + 1}, [&](const TilePlace& node) {
    // Along x where there is an edge before the node, else along y, else along z.
    for (int axis = 0; axis < 3; ++axis) {
      auto before = node;
      if (--before[static_cast<std::size_t>(axis)] < 0) continue;
      windings_[numbers_.node(node)] =
          windings_[numbers_.node(before)] + rises[numbers_.edge(axis, before)];
      return;
    }
  });
}

void EdgeStretches::setStretches(const TileSurface& surface, const GridPlanes& planes) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int plane = 0; plane < planes.cells(axis); ++plane) {
      wholeEdges_[asIndex(axis)].push_back(
          {.from = planes.at(axis, plane), .to = planes.at(axis, plane + 1)});
    }
  }
  crossedEdge_.assign(numbers_.edgeCount(), kNone);
  std::vector<EdgeCrossing> here;
  for (auto crossings = surface.crossings(); !crossings.empty();) {
    const auto edge = crossings.front().edge;
    std::size_t count = 1;
    while (count < crossings.size() && crossings[count].edge == edge) ++count;
    here.assign(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(count));
    crossings = crossings.subspan(count);
    crossedEdge_[edge] = static_cast<std::uint32_t>(firstOfCrossed_.size());
    firstOfCrossed_.push_back(static_cast<std::uint32_t>(stretches_.size()));
    const int axis = numbers_.axisOfEdge(edge);
    const auto first = numbers_.placeOfEdge(edge);
    const int plane = first[asIndex(axis)];
    const bool meets = surface.meetAny(here);
    int before = winding(first);
    if (!meets && hidesBuried(surface, here)) before = before > 0 ? 1 : 0;
    divide({planes.at(axis, plane), planes.at(axis, plane + 1)}, before, !meets, here);
  }
  firstOfCrossed_.push_back(static_cast<std::uint32_t>(stretches_.size()));
}

void EdgeStretches::divide(const Interval<double>& edge, int winding, bool takeTurns,
                           std::vector<EdgeCrossing>& crossings) {
  std::ranges::sort(crossings, {}, [&](const EdgeCrossing& crossing) {
    return std::tuple(crossing.position, crossing.triangle);
  });
  EdgeStretch stretch{.from = edge.lower};
  bool isFluid = winding <= 0;
  for (auto it = crossings.begin(); it != crossings.end(); ++it) {
    if (takeTurns && isFluid == (winding + it->rise <= 0)) {
      // Fluid and body take turns: rounding has put these in the wrong order, or in none.
      const auto other = std::find_if(it + 1, crossings.end(), [&](const EdgeCrossing& c) {
        return c.position - it->position <= EdgeStretch::kRounding && c.rise != it->rise;
      });
      if (other != crossings.end()) {
        std::rotate(it, other, other + 1);
        it->position = (it + 1)->position;
      }
    }
    winding += it->rise;
    // Where solids meet, what counts is how it goes on beyond all of them.
    const auto next = it + 1;
    if (!takeTurns && next != crossings.end() && next->position == it->position) continue;
    if (isFluid == (winding <= 0)) continue;
    isFluid = winding <= 0;
    if (!isFluid) {
      stretch.to = it->position;
      stretch.end = it->triangle;
      stretches_.push_back(stretch);
    } else {
      stretch = {.from = it->position, .start = it->triangle};
    }
  }
  if (winding > 0) return;
  stretch.to = edge.upper;
  stretch.end = kNone;
  stretches_.push_back(stretch);
}

std::span<const EdgeStretch> EdgeStretches::of(int axis, const TilePlace& first) const {
  const auto crossed = crossedEdge_[numbers_.edge(axis, first)];
  if (crossed != kNone) {
    return std::span(stretches_)
        .subspan(firstOfCrossed_[crossed], firstOfCrossed_[crossed + 1] - firstOfCrossed_[crossed]);
  }
  const auto whole = static_cast<std::size_t>(first[asIndex(axis)]);
  return std::span(wholeEdges_[asIndex(axis)]).subspan(whole, isFluid(first) ? 1 : 0);
}

}  // namespace cutwater
