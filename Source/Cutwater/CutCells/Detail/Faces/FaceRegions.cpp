#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Faces/BaffleWays.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceRegions.hpp>
#include <Cutwater/CutCells/Detail/Faces/LocalWinding.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

/// A box about the face, as thick as wide: traces stand for walls across it.
Box<double> slabOf(const GridPlanes& planes, const FaceAxes& axes, const TilePlace& place) {
  Box<double> box;
  double width = 0;
  for (const int axis : {axes.first, axes.second}) {
    box.lower[axis] = planes.at(axis, place[asIndex(axis)]);
    box.upper[axis] = planes.at(axis, place[asIndex(axis)] + 1);
    width = std::max(width, box.upper[axis] - box.lower[axis]);
  }
  const double plane = planes.at(axes.across, place[asIndex(axes.across)]);
  box.lower[axes.across] = plane - 0.5 * width;
  box.upper[axes.across] = plane + 0.5 * width;
  return box;
}

std::vector<Sheet> sheetsOf(const TileSurface& surface, std::span<const FaceTrace> traces,
                            const FaceAxes& axes, const Box<double>& slab) {
  std::vector<Sheet> sheets;
  for (const auto& trace : traces) {
    const auto way = trace.to - trace.from;
    const double size = length(way);
    if (!(size > SheetTree::kNear)) continue;
    Sheet sheet{.points = {trace.from, trace.from, trace.to, trace.to}, .plane = {}};
    for (const std::size_t n : {0, 3}) sheet.points[n][axes.across] = slab.lower[axes.across];
    for (const std::size_t n : {1, 2}) sheet.points[n][axes.across] = slab.upper[axes.across];
    // To the left: where the fluid is.
    sheet.plane.normal[axes.first] = -way[axes.second] / size;
    sheet.plane.normal[axes.second] = way[axes.first] / size;
    sheet.plane.offset = dot(sheet.plane.normal, trace.from);
    sheet.width = size;
    sheet.patch = surface.patchOf(trace.triangle);
    sheet.isBaffle = surface.isBaffle(trace.triangle);
    sheets.push_back(std::move(sheet));
  }
  std::stable_partition(sheets.begin(), sheets.end(),
                        [](const Sheet& sheet) { return !sheet.isBaffle; });
  return sheets;
}

/// The parts of baffles that lie in a face, from the cells on both sides.
std::vector<std::span<const Vec3<double>>> bafflesIn(const TileSurface& surface, int axis,
                                                     TilePlace place, double plane) {
  std::vector<std::span<const Vec3<double>>> result;
  const auto a = asIndex(axis);
  for (const int side : {0, 1}) {
    place[a] -= side;
    if (place[a] < 0 || place[a] >= surface.numbers().cells()[a]) continue;
    const auto cell = surface.numbers().cell(place);
    for (const auto& fragment : sortedUnder(surface.fragments(), cell, &TileFragment::cell)) {
      const auto points = surface.points(fragment);
      const auto isIn = [&](const Vec3<double>& p) { return p[axis] == plane; };
      if (surface.isBaffle(fragment.triangle) && std::ranges::all_of(points, isIn)) {
        result.push_back(points);
      }
    }
  }
  return result;
}

bool contains(std::span<const Vec3<double>> polygon, const FaceAxes& axes, const Vec3<double>& p) {
  const int c = axes.first;
  const int d = axes.second;
  bool isInside = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto& from = polygon[k];
    const auto& to = polygon[(k + 1) % polygon.size()];
    if ((from[c] <= p[c]) == (to[c] <= p[c])) continue;
    const double height = from[d] + (p[c] - from[c]) / (to[c] - from[c]) * (to[d] - from[d]);
    if (height <= p[d]) isInside = !isInside;
  }
  return isInside;
}

}  // namespace

FaceRegions::FaceRegions(const TileSurface& surface, const EdgeStretches& stretches,
                         const GridPlanes& planes, std::uint32_t face)
    : axis_(surface.numbers().axisOfFace(face)) {
  const FaceAxes axes(axis_);
  const auto slab = slabOf(planes, axes, surface.numbers().placeOfFace(face));
  const auto found = sortedUnder(surface.traces(), face, &FaceTrace::face);
  const SheetTree tree(slab, sheetsOf(surface, found, axes, slab));
  const double plane = planes.at(axis_, surface.numbers().placeOfFace(face)[asIndex(axis_)]);
  const auto size = slab.size();
  const double least = kSliver * size[axes.first] * size[axes.second];

  const auto low = 2 * asIndex(axis_);
  std::vector<std::uint32_t> regionOf(tree.leafCount(), kNone);
  const auto points = tree.pointsIn();
  const WindingOnFace windings(surface, stretches, face);
  const auto baffles = bafflesIn(surface, axis_, surface.numbers().placeOfFace(face), plane);
  // The slab's high face is counterclockwise as seen against the axis.
  tree.divide(tree.face(low + 1), SheetTree::inwards(low + 1),
              [&](std::uint32_t leaf, SheetTree::Polygon polygon) {
                for (auto& p : polygon) p[axis_] = plane;
                regionOf[leaf] = static_cast<std::uint32_t>(regions_.size());
                auto point = points[leaf];
                point[axis_] = plane;
                const auto covers = [&](std::span<const Vec3<double>> baffle) {
                  return contains(baffle, axes, point);
                };
                const bool isFluid =
                    windings.at(points[leaf]) <= 0 && std::ranges::none_of(baffles, covers);
                regions_.push_back({std::move(polygon), point, isFluid, kNone});
              });
  joinRegions(tree, regionOf, BaffleWays(surface, face), least);
  if (!found.empty()) somePatch_ = surface.patchOf(found.front().triangle);
  addWalls(tree, regionOf, plane);
  noteRimTraces(tree);
  measure(face, least);
}

void FaceRegions::joinRegions(const SheetTree& tree, std::span<const std::uint32_t> regionOf,
                              const BaffleWays& ways, double least) {
  detail::DisjointSets sets(regions_.size());
  const auto isWayOpen = [&](std::uint32_t one, std::uint32_t other,
                             const SheetTree::Polygon& polygon) {
    auto middle = middleOf(polygon);
    middle[axis_] = regions_[one].point[axis_];
    return ways.isOpen(regions_[one].point, middle, regions_[other].point);
  };
  for (const auto& portal : tree.portals()) {
    const auto below = regionOf[portal.below];
    const auto above = regionOf[portal.above];
    if (below == kNone || above == kNone) continue;
    if (!regions_[below].isFluid || !regions_[above].isFluid) continue;
    const auto open = withoutBaffles(portal.polygon, tree.sheetsAt(portal), [](auto, auto&) {});
    for (const auto& polygon : open) {
      if (ways.areAny() && (isGap(polygon) || !isWayOpen(below, above, polygon))) continue;
      if (0.5 * length(twiceArea(polygon)) > least) sets.unite(below, above);
    }
  }
  for (std::uint32_t i = 0; i < regions_.size(); ++i) {
    if (!regions_[i].isFluid) continue;
    auto& part = regions_[sets.find(i)].part;
    if (part == kNone) {
      part = static_cast<std::uint32_t>(parts_.size());
      parts_.push_back({.centroid = {}});
    }
    regions_[i].part = part;
  }
}

void FaceRegions::addWalls(const SheetTree& tree, std::span<const std::uint32_t> regionOf,
                           double plane) {
  for (const auto& portal : tree.portals()) {
    if (regionOf[portal.below] == kNone || regionOf[portal.above] == kNone) continue;
    const auto& below = regions_[regionOf[portal.below]];
    const auto& above = regions_[regionOf[portal.above]];
    const auto up = twiceArea(portal.polygon);
    const auto sheets = tree.sheetsAt(portal);
    if (below.isFluid && above.isFluid) {
      (void)withoutBaffles(portal.polygon, sheets, [&](std::uint32_t patch, const auto& polygon) {
        addWall(above.part, patch, polygon, up, plane);
        addWall(below.part, patch, polygon, -up, plane);
      });
    }
    if (below.isFluid == above.isFluid) continue;
    const auto part = above.isFluid ? above.part : below.part;
    const auto normal = above.isFluid ? up : -up;
    const auto add = [&](std::uint32_t patch, const SheetTree::Polygon& polygon) {
      addWall(part, patch, polygon, normal, plane);
    };
    if (sheets.empty()) {  // only if rounding has hidden them
      add(somePatch_, portal.polygon);
    } else {
      sharedOut(portal.polygon, normal, sheets, add);
    }
  }
}

/// `normal`: into the fluid.
void FaceRegions::addWall(std::uint32_t part, std::uint32_t patch,
                          const SheetTree::Polygon& polygon, const Vec3<double>& normal,
                          double plane) {
  const FaceAxes axes(axis_);
  Vec3<double> way;
  way[axes.first] = normal[axes.second];
  way[axes.second] = -normal[axes.first];
  const auto along = [&](const Vec3<double>& p) { return dot(p, way); };
  Wall wall{.part = part,
            .patch = patch,
            .from = *std::ranges::min_element(polygon, {}, along),
            .to = *std::ranges::max_element(polygon, {}, along)};
  wall.from[axis_] = wall.to[axis_] = plane;
  walls_.push_back(wall);
}

void FaceRegions::noteRimTraces(const SheetTree& tree) {
  const FaceAxes axes(axis_);
  for (int side = 0; side < 4; ++side) {
    const int along = side < 2 ? axes.first : axes.second;
    const int across = side < 2 ? axes.second : axes.first;
    for (const auto& sheet : tree.sheetsIn(2 * asIndex(across) + asIndex(side % 2))) {
      RimTrace trace{.side = side, .patch = sheet.patch, .ends = {}};
      const auto at = [&](const Vec3<double>& p) { return p[along]; };
      trace.ends.lower = at(*std::ranges::min_element(sheet.points, {}, at));
      trace.ends.upper = at(*std::ranges::max_element(sheet.points, {}, at));
      rimTraces_.push_back(trace);
    }
  }
}

std::uint32_t FaceRegions::patchAt(int side, double place) const {
  for (const auto& trace : rimTraces_) {
    if (trace.side == side && trace.ends.contains(place)) return trace.patch;
  }
  return somePatch_;
}

void FaceRegions::shareRim(int side, const Interval<double>& part,
                           FunctionRef<void(std::uint32_t, const Interval<double>&)> visit) const {
  std::vector<double> ends{part.upper};
  for (const auto& trace : rimTraces_) {
    if (trace.side != side) continue;
    for (const double end : {trace.ends.lower, trace.ends.upper}) {
      if (part.lower < end && end < part.upper) ends.push_back(end);
    }
  }
  std::ranges::sort(ends);
  Interval<double> next{part.lower, part.lower};
  for (std::size_t n = 0; n < ends.size(); ++n) {
    const auto patchTo = [&](double end) { return patchAt(side, 0.5 * (next.upper + end)); };
    const auto patch = patchTo(ends[n]);
    next.upper = ends[n];
    if (n + 1 < ends.size() && patchTo(ends[n + 1]) == patch) continue;  // one part
    if (next.lower < next.upper) visit(patch, next);
    next.lower = next.upper;
  }
}

void FaceRegions::measure(std::uint32_t face, double least) {
  std::vector<Vec3<double>> moments(parts_.size());
  std::vector<Vec3<double>> middles(parts_.size());
  for (const auto& region : regions_) {
    if (region.part == kNone) continue;
    auto& part = parts_[region.part];
    middles[region.part] = middleOf(region.polygon);
    for (std::size_t k = 2; k < region.polygon.size(); ++k) {
      const auto& [a, b, c] = std::tie(region.polygon[0], region.polygon[k - 1], region.polygon[k]);
      const double area = 0.5 * cross(b - a, c - a)[axis_];
      part.area += area;
      moments[region.part] += area / 3 * ((a + b) + c);
    }
  }
  for (std::uint32_t n = 0; n < parts_.size(); ++n) {
    parts_[n].face = face;
    parts_[n].isNothing = !(parts_[n].area > least);
    parts_[n].centroid = parts_[n].isNothing ? middles[n] : moments[n] / parts_[n].area;
  }
}

bool makeSheet(const TileSurface& surface, const TileFragment& fragment, Sheet& sheet) {
  const auto points = surface.points(fragment);
  const auto corners = surface.cornersOf(fragment.triangle);
  const auto [normal, area] = polygonArea(corners);
  if (!(area > 0) || isNarrow(points, SheetTree::kFlat)) return false;
  sheet.points.assign(points.begin(), points.end());
  sheet.plane.normal = normal;
  sheet.plane.offset = dot(sheet.plane.normal, middleOf(points));
  const auto& [a, b, c] = corners;
  sheet.width = 2 * area / std::max({length(b - a), length(c - b), length(a - c)});
  sheet.patch = surface.patchOf(fragment.triangle);
  sheet.isBaffle = surface.isBaffle(fragment.triangle);
  return true;
}

}  // namespace cutwater
