#include <Cutwater/CutCells/Detail/Curved/GridSamples.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

TilePlace cornerOf(TilePlace place, int corner) {
  for (std::size_t a = 0; a < 3; ++a) place[a] += corner >> a & 1;
  return place;
}

/// Whether a corner of a box is one of a rectangle, which has those below the axis across it.
bool isOfRectangle(int corner, int flatAxis) {
  return flatAxis < 0 || (corner >> flatAxis & 1) == 0;
}

}  // namespace

bool leavesRoom(const FluidField& field, const Box<double>& box, std::span<const double> corners) {
  // No point is farther from the nearest corner than half a diagonal.
  const double reach = field.changeToCorners(box);
  return std::ranges::any_of(corners, [&](double value) {
    return (value > 0) != (corners.front() > 0) || std::abs(value) <= reach;
  });
}

GridSamples::GridSamples(NearFields& fields, const GridPlanes& planes)
    : fields_(fields), field_(fields.here()), planes_(planes), numbers_(planes.sizes()) {
  auto nodes = numbers_.cells();
  for (auto& n : nodes) ++n;
  std::vector<Vec3<double>> points;
  points.reserve(numbers_.nodeCount());
  forTilePlaces(nodes,
                [&](const TilePlace& node) { points.push_back(pointAt(node) - shiftAt(node)); });
  values_.resize(points.size());
  field_.values(points, values_);
  gradients_.resize(points.size());
  hasGradient_.resize(points.size());
  edges_.resize(numbers_.edgeCount());
  hasEdge_.resize(edges_.size());
}

Box<double> GridSamples::boxOf(const TilePlace& cell, int flatAxis) const {
  Box<double> box;
  for (int axis = 0; axis < 3; ++axis) {
    const int plane = cell[asIndex(axis)];
    box.lower[axis] = planes_.at(axis, plane);
    box.upper[axis] = planes_.at(axis, axis == flatAxis ? plane : plane + 1);
  }
  return box;
}

bool GridSamples::leavesRoom(const TilePlace& cell, int flatAxis) const {
  std::array<double, 8> values{};
  for (int corner = 0; corner < 8; ++corner) {
    const auto node = isOfRectangle(corner, flatAxis) ? corner : corner - (1 << flatAxis);
    values[static_cast<std::size_t>(corner)] = valueAt(cornerOf(cell, node));
  }
  return cutwater::leavesRoom(field_, boxOf(cell, flatAxis), values);
}

const Vec3<double>& GridSamples::gradientAt(const TilePlace& node) {
  const auto number = numbers_.node(node);
  if (hasGradient_[number] == 0) {
    hasGradient_[number] = 1;
    gradients_[number] = field_.gradient(pointAt(node) - shiftAt(node));
  }
  return gradients_[number];
}

BoxSamples GridSamples::of(const TilePlace& cell, int flatAxis) {
  BoxSamples samples;
  std::vector<CrossedEdge*> unknown;
  std::vector<Vec3<double>> shifts;
  for (int corner = 0; corner < 8; ++corner) {
    const auto node =
        cornerOf(cell, isOfRectangle(corner, flatAxis) ? corner : corner - (1 << flatAxis));
    samples.values[static_cast<std::size_t>(corner)] = valueAt(node);
    // Not looked at where surfaces are known.
    if (!field_.knowsSurfaces())
      samples.gradients[static_cast<std::size_t>(corner)] = gradientAt(node);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == flatAxis) continue;
    for (int corner = 0; corner < 8; ++corner) {
      if ((corner >> axis & 1) != 0 || !isOfRectangle(corner, flatAxis)) continue;
      const auto node = cornerOf(cell, corner);
      const auto number = numbers_.edge(axis, node);
      if (hasEdge_[number] == 0) {
        hasEdge_[number] = 1;
        edges_[number].line = {pointAt(node), planes_.at(axis, node[asIndex(axis)] + 1), axis};
        unknown.push_back(&edges_[number]);
        shifts.push_back(shiftAt(node));
      }
      samples.edges.push_back(&edges_[number]);
      samples.corners.push_back(corner);
    }
  }
  findEdges(unknown, shifts);
  return samples;
}

/// Along their own axis, edges begin below the seam.
void GridSamples::findEdges(std::span<CrossedEdge* const> edges,
                            std::span<const Vec3<double>> shifts) {
  if (std::ranges::all_of(shifts, [](const Vec3<double>& s) { return s == Vec3<double>{}; })) {
    return findCrossings(field_, edges, !field_.knowsSurfaces());
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& field = fields_.below(shifts[i]);
    edges[i]->line.start -= shifts[i];
    findCrossings(field, edges.subspan(i, 1), !field.knowsSurfaces());
    edges[i]->line.start += shifts[i];
  }
}

}  // namespace cutwater
