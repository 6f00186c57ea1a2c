#include <Cutwater/Adapters/Detail/SingleValuedParts.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace cutwater {

namespace {

/// Hosts ask whether a face is all open by comparing with 1.
constexpr double kAllOpen = 1 - 8 * std::numeric_limits<double>::epsilon();

bool extends(unsigned extent, int axis) {
  return (extent >> static_cast<unsigned>(axis) & 1U) != 0;
}

}  // namespace

SingleValuedParts::SingleValuedParts(MergedCells merged, const EdgeOpenings& raw,
                                     const SingleValuedOptions& options)
    : merged_(std::move(merged)), options_(options), box_(merged_.cells.grid.indices()) {
  for (int axis = 0; axis < 3; ++axis) {
    isPeriodic_[asIndex(axis)] = merged_.cells.grid.period[asIndex(axis)] != 0;
  }
  if (options.isPlane) return;
  auto edges = edgesOfCells(merged_.cells);
  parallelFor(edges.size(), {.threads = options.threads, .grain = 1024},
              [&](std::size_t begin, std::size_t end) {
                for (auto n = begin; n < end; ++n) {
                  const auto axis = static_cast<unsigned>(edges[n].axis);
                  edges[n] = finalEdge(inBox({edges[n].cell, 1U << axis}), raw);
                }
              });
  edges_ = EdgeOpenings(std::move(edges));
}

SingleValuedParts::Place SingleValuedParts::inBox(Place place) const {
  for (int axis = 0; axis < 3; ++axis) {
    auto& at = along(place.at, axis);
    const auto lowest = along(box_.lo, axis);
    const auto highest = along(box_.hi, axis);
    if (axis >= dimensions()) {
      at = lowest;
    } else if (isPeriodic_[asIndex(axis)]) {
      const auto count = highest - lowest + 1;
      const auto rest = (at - lowest) % count;
      at = lowest + (rest < 0 ? rest + count : rest);
    } else if (at < lowest || at > highest) {
      place.extent &= ~(1U << static_cast<unsigned>(axis));
      at = at < lowest ? lowest : highest + 1;
    }
  }
  return place;
}

/// The cells of the box that meet in a face, an edge or a node of it.
template <typename Visit>
void SingleValuedParts::forCellsAround(const Place& place, const Visit& visit) const {
  for (unsigned corner = 0; corner < (1U << static_cast<unsigned>(dimensions())); ++corner) {
    if ((corner & place.extent) != 0) continue;
    auto cell = place.at;
    for (int axis = 0; axis < 3; ++axis) {
      if (extends(corner, axis)) --along(cell, axis);
    }
    const auto found = inBox({cell, kCell});
    if (found.extent == kCell) visit(found.at, corner);
  }
}

SingleValuedParts::Part SingleValuedParts::partOf(const Index3& at, unsigned extent) const {
  auto place = inBox({at, extent});
  constexpr unsigned kAlongZ = 4;
  if (options_.isPlane && place.extent == kAlongZ) place.extent = 0;
  switch (std::popcount(place.extent)) {
    case 3:
      return ofCell(place.at);
    case 2:
      return ofFace(place);
    case 1:
      return ofEdge(place);
    default:
      return {.share = levelSetIn(place) < 0 ? 1.0 : 0.0};
  }
}

SingleValuedParts::Part SingleValuedParts::ofCell(const Index3& cell) const {
  const auto& cells = merged_.cells;
  const auto row = cells.rowOf(cell);
  if (row == CutCells::kNoRow) {
    return {.share = cells.classOf(cell) == FluidClass::Body ? 0.0 : 1.0};
  }
  const auto piece = cells.cells.firstPiece[row];
  const auto box = cells.boxOf(cell);
  const auto size = box.size();
  Part part{.share = cells.volumeFraction(piece)};
  for (int a = 0; a < 3; ++a) {
    part.centroid[a] = (cells.pieces.centroid[piece][a] - box.center()[a]) / size[a];
  }
  return part;
}

SingleValuedParts::Part SingleValuedParts::ofFace(const Place& face) const {
  const auto& cells = merged_.cells;
  const auto& arcs = cells.arcs;
  const int axis = std::countr_one(face.extent);
  const auto order = [](const Index3& cell, int across) {
    return std::tuple(cell.k, cell.j, cell.i, across);
  };
  const auto key = order(face.at, axis);
  std::size_t arc = 0;
  for (std::size_t count = arcs.area.size(); count > 0;) {
    const auto half = arc + count / 2;
    const bool isBefore = order(arcs.cell[half], arcs.axis[half]) < key;
    count = isBefore ? arc + count - half - 1 : count / 2;
    if (isBefore) arc = half + 1;
  }
  Part part;
  const auto box = cells.boxOf(face.at);
  const auto size = box.size();
  const double whole = cells.faceArea(face.at, axis);
  bool isAny = false;
  for (; arc < arcs.area.size() && order(arcs.cell[arc], arcs.axis[arc]) == key; ++arc) {
    const double share = arcs.area[arc] / whole;
    isAny = true;
    part.share += share;
    for (int a = 0; a < 3; ++a) {
      if (a != axis)
        part.centroid[a] += share * (arcs.centroid[arc][a] - box.center()[a]) / size[a];
    }
  }
  if (!isAny) {
    bool isOpen = true;
    forCellsAround(face, [&](const Index3& cell, unsigned /*corner*/) {
      isOpen = isOpen && cells.classOf(cell) == FluidClass::Fluid;
    });
    return {.share = isOpen ? 1.0 : 0.0};
  }
  if (part.share > kAllOpen) return {.share = 1};
  if (part.share > 0) part.centroid = part.centroid / part.share;
  return part;
}

SingleValuedParts::Part SingleValuedParts::ofEdge(const Place& edge) const {
  const int axis = std::countr_zero(edge.extent);
  Part part{.share = 1};
  if (const auto found = edges_.at(edge.at, axis)) {
    part.share = found->share;
    part.centroid[axis] = found->centroid;
    return part;
  }
  forCellsAround(edge, [&](const Index3& cell, unsigned /*corner*/) {
    if (merged_.cells.classOf(cell) == FluidClass::Body) part.share = 0;
  });
  return part;
}

double SingleValuedParts::levelSetAt(const Index3& node) const {
  return levelSetIn(inBox({node, 0}));
}

double SingleValuedParts::levelSetIn(const Place& node) const {
  const auto& cells = merged_.cells;
  bool isBody = false;
  bool isCut = false;
  forCellsAround(node, [&](const Index3& cell, unsigned corner) {
    const auto row = cells.rowOf(cell);
    if (row == CutCells::kNoRow) {
      isBody = isBody || cells.classOf(cell) == FluidClass::Body;
    } else {
      isCut = true;
      isBody = isBody || (cells.cells.fluidCorners[row] >> corner & 1U) == 0;
    }
  });
  if (isBody) return 1;
  return isCut && touchesClosedFace(node) ? 0 : -1;
}

/// Of an edge or a node.
bool SingleValuedParts::touchesClosedFace(const Place& place) const {
  for (int axis = 0; axis < dimensions(); ++axis) {
    if (extends(place.extent, axis)) continue;
    const unsigned extent = kCell & ~(1U << static_cast<unsigned>(axis));
    for (unsigned corner = 0; corner < 8; ++corner) {
      if ((corner & place.extent) != 0 || extends(corner, axis)) continue;
      Place face{place.at, extent};
      for (int a = 0; a < 3; ++a) {
        if (extends(corner, a)) --along(face.at, a);
      }
      face = inBox(face);
      if (face.extent == extent && ofFace(face).share == 0) return true;
    }
  }
  return false;
}

/// Closed beside faces that are closed, and as it was otherwise: all open if no cell around it was
/// cut, or if one still is all fluid.
EdgeOpening SingleValuedParts::finalEdge(const Place& edge, const EdgeOpenings& raw) const {
  const int axis = std::countr_zero(edge.extent);
  EdgeOpening result{.cell = edge.at, .axis = axis};
  if (touchesClosedFace(edge)) return result;
  const auto found = raw.at(edge.at, axis);
  bool isWhole = !found || found->share > kAllOpen;
  forCellsAround(edge, [&](const Index3& cell, unsigned /*corner*/) {
    isWhole = isWhole || merged_.cells.classOf(cell) == FluidClass::Fluid;
  });
  if (!isWhole) return *found;
  result.share = 1;
  return result;
}

FluidClass SingleValuedParts::kindOf(const Index3& cell) const {
  const auto place = inBox({cell, kCell});
  if (place.extent == kCell) return merged_.cells.classOf(place.at);
  const double share = partOf(cell, kCell).share;
  if (share == 0) return FluidClass::Body;
  const auto isOpen = [&](int axis) {
    auto above = cell;
    ++along(above, axis);
    return partOfFace(cell, axis).share == 1 && partOfFace(above, axis).share == 1;
  };
  if (share == 1 && isOpen(0) && isOpen(1) && (options_.isPlane || isOpen(2)))
    return FluidClass::Fluid;
  return wallOf(cell).vector == Vec3<double>{} ? FluidClass::Body : FluidClass::Cut;
}

SingleValuedParts::Wall SingleValuedParts::wallOf(const Index3& cell) const {
  Wall wall{};
  std::array<std::array<Part, 2>, 3> faces;
  for (int axis = 0; axis < dimensions(); ++axis) {
    auto above = cell;
    ++along(above, axis);
    auto& [low, high] = faces[asIndex(axis)];
    low = partOfFace(cell, axis);
    high = partOfFace(above, axis);
    wall.open[asIndex(axis)] = {low.share, high.share};
    wall.vector[axis] = low.share - high.share;
  }
  const auto place = inBox({cell, kCell});
  if (place.extent == kCell) {
    const auto& cells = merged_.cells;
    const auto box = cells.boxOf(place.at);
    const auto& centroid = cells.pieces.wallCentroid[cells.cells.firstPiece[cells.rowOf(place.at)]];
    for (int a = 0; a < 3; ++a) {
      wall.centroid[a] = (centroid[a] - box.center()[a]) / box.size()[a];
    }
    return wall;
  }
  // With n, the wall's normal: the integral of x (n . normal) over the boundary is n times the
  // volume.
  const double area = length(wall.vector);
  if (area == 0) return wall;
  const auto n = wall.vector / area;
  wall.centroid = n * partOf(cell, kCell).share;
  for (int axis = 0; axis < dimensions(); ++axis) {
    for (const bool isHigh : {false, true}) {
      const auto& face = faces[asIndex(axis)][isHigh ? 1 : 0];
      auto centroid = face.centroid;
      centroid[axis] = isHigh ? 0.5 : -0.5;
      wall.centroid -= centroid * (face.share * (isHigh ? n[axis] : -n[axis]));
    }
  }
  wall.centroid = wall.centroid / area;
  return wall;
}

EdgeOpenings SingleValuedParts::coarseEdges(const CutCells& coarse) const {
  if (options_.isPlane) return {};
  auto edges = edgesOfCells(coarse);
  for (auto& edge : edges) {
    double moment = 0;
    for (int half = 0; half < 2; ++half) {
      Index3 at{2 * edge.cell.i, 2 * edge.cell.j, 2 * edge.cell.k};
      along(at, edge.axis) += half;
      const auto part = partOfEdge(at, edge.axis);
      edge.share += part.share / 2;
      moment += part.share / 2 * (part.centroid[edge.axis] / 2 + (half == 0 ? -0.25 : 0.25));
    }
    if (edge.share > 0) edge.centroid = moment / edge.share;
  }
  return EdgeOpenings(std::move(edges));
}

}  // namespace cutwater
