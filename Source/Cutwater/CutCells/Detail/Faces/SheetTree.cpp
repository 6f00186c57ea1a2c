#include <Cutwater/CutCells/Detail/Faces/SheetDividers.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cutwater {

namespace {

using Polygon = SheetTree::Polygon;

/// More sheets than this are a crowd.
constexpr std::size_t kCrowd = 32;
/// So many are tried for the plane that divides the fewest others.
constexpr std::size_t kTries = 5;
/// Rounding tilts the planes of sheets that are wider than this share of the box by much less than
/// SheetTree::kFlat, across the box: they come first, and narrower ones beside them are in theirs.
constexpr double kSteady = 0x1p-6;

/// The parts of a polygon below a plane and above it. One in the plane is in neither.
std::array<Polygon, 2> parted(const Polygon& polygon, const SheetPlane& plane) {
  std::array<Polygon, 2> result;
  std::vector<double> heights;
  heights.reserve(polygon.size());
  double lowest = 0;
  double highest = 0;
  for (const auto& p : polygon) {
    heights.push_back(plane.height(p));
    lowest = std::min(lowest, heights.back());
    highest = std::max(highest, heights.back());
  }
  if (lowest >= -SheetTree::kNear || highest <= SheetTree::kNear) {
    if (highest > SheetTree::kNear) result[1] = polygon;
    if (lowest < -SheetTree::kNear) result[0] = polygon;
    return result;
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto next = (i + 1) % polygon.size();
    const double here = heights[i];
    const double there = heights[next];
    if (here <= SheetTree::kNear) result[0].push_back(polygon[i]);
    if (here >= -SheetTree::kNear) result[1].push_back(polygon[i]);
    const bool crosses = (here < -SheetTree::kNear && there > SheetTree::kNear) ||
                         (here > SheetTree::kNear && there < -SheetTree::kNear);
    if (!crosses) continue;
    const auto point = polygon[i] + here / (here - there) * (polygon[next] - polygon[i]);
    result[0].push_back(point);
    result[1].push_back(point);
  }
  return result;
}

/// The plane across the axis along which sheets are spread out most, through the mean of their
/// middles.
SheetPlane halvingPlane(std::span<const Sheet> sheets) {
  Box<double> box;
  Vec3<double> sum;
  for (const auto& sheet : sheets) {
    const auto middle = middleOf(sheet.points);
    box.extend(middle);
    sum += middle;
  }
  const int axis = nearestAxis(box.size());
  SheetPlane plane;
  plane.normal[axis] = 1;
  plane.offset = sum[axis] / static_cast<double>(sheets.size());
  return plane;
}

struct Counts {
  std::size_t below = 0;
  std::size_t above = 0;
};
Counts countsBeside(std::span<const Sheet> sheets, const SheetPlane& plane) {
  Counts counts;
  for (const auto& sheet : sheets) {
    bool isBelow = false;
    bool isAbove = false;
    for (const auto& p : sheet.points) {
      const double height = plane.height(p);
      isBelow = isBelow || height < -SheetTree::kNear;
      isAbove = isAbove || height > SheetTree::kNear;
    }
    counts.below += isBelow ? 1 : 0;
    counts.above += isAbove ? 1 : 0;
  }
  return counts;
}

/// Whether all points of a sheet are within a distance of a plane.
bool isWithin(const Sheet& sheet, const SheetPlane& plane, double distance) {
  return std::ranges::all_of(sheet.points,
                             [&](const auto& p) { return std::abs(plane.height(p)) <= distance; });
}

/// Whether a sheet all of whose points lie in a plane with this normal is in its own plane there:
/// else it is a line.
bool hasAreaIn(const Sheet& sheet, const Vec3<double>& normal) {
  return std::abs(dot(sheet.plane.normal, normal)) > 0.5;
}

SheetPlane facePlane(const Box<double>& box, std::size_t face) {
  const int axis = static_cast<int>(face / 2);
  SheetPlane plane;
  plane.normal = -SheetTree::inwards(face);
  plane.offset = face % 2 == 0 ? -box.lower[axis] : box.upper[axis];
  return plane;
}

}  // namespace

Vec3<double> twiceArea(std::span<const Vec3<double>> polygon) {
  Vec3<double> sum;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    sum += cross(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  }
  return sum;
}

Vec3<double> middleOf(std::span<const Vec3<double>> polygon) {
  Vec3<double> sum;
  for (const auto& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

bool isNarrow(std::span<const Vec3<double>> polygon, double width) {
  double perimeter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    perimeter += length(polygon[(i + 1) % polygon.size()] - polygon[i]);
  }
  return length(twiceArea(polygon)) <= width * perimeter;
}

SheetTree::SheetTree(const Box<double>& box, std::vector<Sheet> sheets) : box_(box) {
  std::vector<Sheet> within;
  for (auto& sheet : sheets) {
    std::size_t face = 0;
    const auto isIn = [&](std::size_t n) { return isWithin(sheet, facePlane(box_, n), kNear); };
    while (face < 6 && !isIn(face)) ++face;
    if (face == 6) {
      within.push_back(std::move(sheet));
    } else if (hasAreaIn(sheet, inwards(face))) {
      inFaces_[face].push_back(std::move(sheet));
    }
  }
  std::ranges::move(dividersOf(within), std::back_inserter(within));
  root_ = build(std::move(within));
  std::vector<SheetPlane> path;
  if ((root_ & kLeaf) == 0) findPortals(root_, path);
}

/// A plane to divide by, and the sheet that it is the plane of, if any.
struct SheetTree::Choice {
  SheetPlane plane;
  const Sheet* sheet = nullptr;
};

SheetTree::Choice SheetTree::chosenPlane(std::span<const Sheet> sheets) const {
  const auto of = [](const Sheet& sheet) { return Choice{sheet.plane, &sheet}; };
  const auto divider = std::ranges::find(sheets, true, &Sheet::isDivider);
  if (divider != sheets.end()) return of(*divider);
  if (sheets.size() > kCrowd) {
    const auto plane = halvingPlane(sheets);
    const auto counts = countsBeside(sheets, plane);
    if (4 * std::max(counts.below, counts.above) <= 3 * sheets.size()) return {plane};
  }
  const double widest = std::ranges::max_element(sheets, {}, &Sheet::width)->width;
  const double least = std::min(0.5 * widest, kSteady * box_.diagonal());
  const auto wide = [&](const Sheet& sheet) { return sheet.width >= least; };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(sheets, wide));
  const auto step = std::max<std::size_t>(1, count / kTries);
  Choice best;
  std::size_t fewest = ~std::size_t{0};
  std::size_t number = 0;
  for (const auto& sheet : sheets) {
    if (!wide(sheet) || number++ % step != 0) continue;
    const auto counts = countsBeside(sheets, sheet.plane);
    const auto sum = counts.below + counts.above;
    if (sum < fewest) fewest = sum, best = of(sheet);
  }
  return best;
}

std::uint32_t SheetTree::build(std::vector<Sheet> sheets) {
  if (sheets.empty()) return kLeaf | leafCount_++;
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  const auto [plane, chosen] = chosenPlane(sheets);
  nodes_.push_back({.plane = plane, .sheets = {}});
  std::array<std::vector<Sheet>, 2> sides;
  for (auto& sheet : sheets) {
    // The chosen one is, whatever the rounding of its points: each part has one less.
    if (&sheet == chosen || isWithin(sheet, plane, kFlat)) {
      if (!sheet.isDivider && hasAreaIn(sheet, plane.normal)) {
        nodes_[number].sheets.push_back(std::move(sheet));
      }
      continue;
    }
    auto parts = parted(sheet.points, plane);
    for (const std::size_t side : {0, 1}) {
      if (parts[side].empty()) continue;
      auto part = sheet;
      part.points = std::move(parts[side]);
      sides[side].push_back(std::move(part));
    }
  }
  sheets.clear();
  for (const std::size_t side : {0, 1}) {
    const auto child = build(std::move(sides[side]));
    nodes_[number].children[side] = child;
  }
  return number;
}

/// Of this node and those below it. `path`: planes with the node's part of the box below them.
void SheetTree::findPortals(std::uint32_t node, std::vector<SheetPlane>& path) {
  const auto& plane = nodes_[node].plane;
  const auto polygon = inBox(plane, path);
  if (polygon.size() > 2) {
    const auto& children = nodes_[node].children;
    divideFrom(children[0], polygon, -plane.normal, [&](std::uint32_t below, const Polygon& part) {
      divideFrom(children[1], part, plane.normal, [&](std::uint32_t above, const Polygon& both) {
        portals_.push_back({below, above, node, both});
      });
    });
  }
  for (const std::size_t side : {0, 1}) {
    const auto child = nodes_[node].children[side];
    if ((child & kLeaf) != 0) continue;
    path.push_back(side == 0 ? plane : SheetPlane{-plane.normal, -plane.offset});
    findPortals(child, path);
    path.pop_back();
  }
}

/// A plane's part of the box that lies below other planes. Empty if it lies in one of them.
SheetTree::Polygon SheetTree::inBox(const SheetPlane& plane,
                                    std::span<const SheetPlane> path) const {
  const int axis = nearestAxis(plane.normal);
  Vec3<double> along;
  along[(axis + 1) % 3] = 1;
  const auto u = cross(plane.normal, along) / length(cross(plane.normal, along));
  const auto v = cross(plane.normal, u);
  const double size = box_.diagonal();
  const auto center = box_.center() - plane.height(box_.center()) * plane.normal;
  Polygon polygon{center - size * u - size * v, center + size * u - size * v,
                  center + size * u + size * v, center - size * u + size * v};
  for (std::size_t face = 0; face < 6 && !polygon.empty(); ++face) {
    polygon = parted(polygon, facePlane(box_, face))[0];
  }
  for (const auto& other : path) {
    if (polygon.empty()) break;
    polygon = parted(polygon, other)[0];
  }
  return polygon;
}

void SheetTree::divideFrom(std::uint32_t node, const Polygon& polygon, const Vec3<double>& side,
                           FunctionRef<void(std::uint32_t, const Polygon&)> visit) const {
  if ((node & kLeaf) != 0) return visit(node & ~kLeaf, polygon);
  const auto& plane = nodes_[node].plane;
  const auto parts = parted(polygon, plane);
  const auto& children = nodes_[node].children;
  if (parts[0].empty() && parts[1].empty()) {
    return divideFrom(children[dot(plane.normal, side) > 0 ? 1 : 0], polygon, side, visit);
  }
  for (const std::size_t n : {0, 1}) {
    if (!parts[n].empty()) divideFrom(children[n], parts[n], side, visit);
  }
}

std::uint32_t SheetTree::leafAt(const Vec3<double>& p, const Vec3<double>& side) const {
  auto node = root_;
  while ((node & kLeaf) == 0) {
    const auto& plane = nodes_[node].plane;
    const double height = plane.height(p);
    const bool isAbove = std::abs(height) > kNear ? height > 0 : dot(plane.normal, side) > 0;
    node = nodes_[node].children[isAbove ? 1 : 0];
  }
  return node & ~kLeaf;
}

std::vector<Vec3<double>> SheetTree::pointsIn() const {
  std::vector<Vec3<double>> sums(leafCount_);
  std::vector<double> weights(leafCount_);
  double share = 0.5;
  const auto add = [&](std::uint32_t leaf, const Polygon& polygon) {
    for (const auto& p : polygon) {
      share += 0.6180339887498949;
      share -= std::floor(share);
      const double weight = 1 + share * share * share;  // linear ones leave some symmetries
      sums[leaf] += weight * p;
      weights[leaf] += weight;
    }
  };
  for (const auto& portal : portals_) {
    add(portal.below, portal.polygon);
    add(portal.above, portal.polygon);
  }
  for (std::size_t n = 0; n < 6; ++n) divide(face(n), inwards(n), add);
  for (std::size_t leaf = 0; leaf < sums.size(); ++leaf) {
    sums[leaf] = weights[leaf] > 0 ? sums[leaf] / weights[leaf] : box_.center();
  }
  return sums;
}

Vec3<double> SheetTree::inwards(std::size_t face) {
  Vec3<double> result;
  result[static_cast<int>(face / 2)] = face % 2 == 0 ? 1 : -1;
  return result;
}

SheetTree::Polygon SheetTree::face(std::size_t face) const {
  const int axis = static_cast<int>(face / 2);
  const int c = (axis + 1) % 3;
  const int d = (axis + 2) % 3;
  Polygon result;
  for (const auto& [alongC, alongD] :
       {std::pair(false, false), {true, false}, {true, true}, {false, true}}) {
    auto p = face % 2 == 0 ? box_.lower : box_.upper;
    p[c] = alongC ? box_.upper[c] : box_.lower[c];
    p[d] = alongD ? box_.upper[d] : box_.lower[d];
    result.push_back(p);
  }
  if (face % 2 == 0) std::ranges::reverse(result);
  return result;
}

namespace {

/// The part of a polygon within a sheet in its plane; adds what is outside to others.
Polygon partWithin(Polygon part, const Sheet& sheet, std::vector<Polygon>& outside) {
  for (std::size_t i = 0; i < sheet.points.size() && !part.empty(); ++i) {
    const auto way = sheet.points[(i + 1) % sheet.points.size()] - sheet.points[i];
    const auto outwards = cross(way, sheet.plane.normal);
    const double size = length(outwards);
    if (!(size > SheetTree::kNear)) continue;
    SheetPlane side{outwards / size, 0};
    side.offset = dot(side.normal, sheet.points[i]);
    auto parts = parted(part, side);
    if (!parts[1].empty()) outside.push_back(std::move(parts[1]));
    part = std::move(parts[0]);
  }
  return part;
}

/// Shares a polygon out among the sheets that `counts` accepts; returns the rest.
template <typename Counts>
std::vector<Polygon> shareOut(const Polygon& polygon, std::span<const Sheet> sheets,
                              Counts&& counts,
                              FunctionRef<void(std::uint32_t, const Polygon&)> visit) {
  std::vector<Polygon> rest{polygon};
  for (const auto& sheet : sheets) {
    if (!counts(sheet)) continue;
    std::vector<Polygon> left;
    for (auto& part : rest) {
      const auto within = partWithin(std::move(part), sheet, left);
      if (!within.empty()) visit(sheet.patch, within);
    }
    rest = std::move(left);
  }
  return rest;
}

}  // namespace

void sharedOut(const Polygon& polygon, const Vec3<double>& normal, std::span<const Sheet> sheets,
               FunctionRef<void(std::uint32_t, const Polygon&)> visit) {
  std::uint32_t last = sheets.front().patch;
  const auto facesItsWay = [&](const Sheet& sheet) {
    const bool facesIt = sheet.isBaffle || dot(sheet.plane.normal, normal) > 0;
    if (facesIt) last = sheet.patch;
    return facesIt;
  };
  for (const auto& part : shareOut(polygon, sheets, facesItsWay, visit)) visit(last, part);
}

std::vector<Polygon> withoutBaffles(const Polygon& polygon, std::span<const Sheet> sheets,
                                    FunctionRef<void(std::uint32_t, const Polygon&)> visit) {
  const auto isBaffle = [](const Sheet& sheet) { return sheet.isBaffle; };
  return shareOut(polygon, sheets, isBaffle, visit);
}

}  // namespace cutwater
