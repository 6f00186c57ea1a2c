#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/CutSurface.hpp>

#include <algorithm>
#include <bit>
#include <cmath>

namespace cutwater {

namespace {

/// Where a surface is farther away from 0 along an axis than it is long, its lowest coordinate:
/// differences from that are exact (Sterbenz 1974).
CutFrame frameOf(const Box<double>& box) {
  CutFrame frame;
  for (int axis = 0; axis < 3; ++axis) {
    const double lower = box.lower[axis];
    const double upper = box.upper[axis];
    if (lower > 0 && upper <= 2 * lower) frame.origin[axis] = lower;
    if (upper < 0 && lower >= 2 * upper) frame.origin[axis] = upper;
  }
  const double size =
      maxComponent(max(abs(box.lower - frame.origin), abs(box.upper - frame.origin)));
  if (size > 0) frame.scale = std::ldexp(1.0, -std::ilogb(size));
  return frame;
}

std::vector<Vec3<double>> inFrame(const CutFrame& frame, std::span<const Vec3<double>> points) {
  std::vector<Vec3<double>> result;
  result.reserve(points.size());
  for (const auto& p : points) {
    result.push_back({frame.toFrame(0, p.x), frame.toFrame(1, p.y), frame.toFrame(2, p.z)});
  }
  return result;
}

/// Which triangles have three different corners. The sides of the others cancel each other.
std::vector<std::uint32_t> properTriangles(const PolygonSoup& soup) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) result.push_back(i);
  }
  return result;
}

/// Those that are left once triangles with the same corners that face opposite ways have cancelled
/// each other: where solids have a face in common, it is within their union.
std::vector<std::uint32_t> withoutOpposites(const PolygonSoup& soup,
                                            std::span<const std::uint32_t> triangles) {
  struct Face {
    std::array<std::uint32_t, 3> corners;  // ascending
    bool isEven;                           // they are in the triangle's order
    std::uint32_t triangle;
  };
  std::vector<Face> faces;
  for (const auto i : triangles) {
    const auto p = soup.polygon(i);
    Face face{{p[0], p[1], p[2]}, true, i};
    for (const std::size_t n : {0, 1, 0}) {
      auto& first = face.corners[n];
      auto& second = face.corners[n + 1];
      if (first > second) std::swap(first, second), face.isEven = !face.isEven;
    }
    faces.push_back(face);
  }
  std::ranges::stable_sort(faces, {}, &Face::corners);
  std::vector<std::uint32_t> left;
  std::vector<std::uint32_t> open;  // of one way, in the group of equal corners
  bool isEven = true;
  for (std::size_t n = 0; n < faces.size(); ++n) {
    if (open.empty() || faces[n].isEven == isEven) {
      isEven = faces[n].isEven;
      open.push_back(faces[n].triangle);
    } else {
      open.pop_back();
    }
    if (n + 1 < faces.size() && faces[n + 1].corners == faces[n].corners) continue;
    left.insert(left.end(), open.begin(), open.end());
    open.clear();
  }
  std::ranges::sort(left);
  return left;
}

/// The corners of triangles, turned if the fluid is inside.
std::vector<MovedSurface::Corners> cornersOf(const PolygonSoup& soup,
                                             std::span<const std::uint32_t> triangles,
                                             FluidSide side) {
  std::vector<MovedSurface::Corners> result;
  result.reserve(triangles.size());
  for (const auto i : triangles) {
    const auto p = soup.polygon(i);
    result.push_back({p[0], p[1], p[2]});
    if (side == FluidSide::Inside) std::swap(result.back()[1], result.back()[2]);
  }
  return result;
}

std::vector<std::uint32_t> patchesOf(const PolygonSoup& soup,
                                     std::span<const std::uint32_t> triangles) {
  std::vector<std::uint32_t> result;
  result.reserve(triangles.size());
  for (const auto i : triangles) result.push_back(soup.patches[i]);
  return result;
}

/// Different numbers below `count`, in ascending order: many of them by a bit for each.
void sortNumbers(std::vector<std::uint32_t>& numbers, std::size_t count) {
  constexpr std::uint32_t kBits = 64;
  if (numbers.size() < count / kBits) {
    std::ranges::sort(numbers);
    return;
  }
  std::vector<std::uint64_t> words(count / kBits + 1);
  for (const auto n : numbers) words[n / kBits] |= std::uint64_t{1} << n % kBits;
  numbers.clear();
  for (std::uint32_t i = 0; i < words.size(); ++i) {
    for (auto word = words[i]; word != 0; word &= word - 1) {
      numbers.push_back(kBits * i + static_cast<std::uint32_t>(std::countr_zero(word)));
    }
  }
}

}  // namespace

CutSurface::Selection CutSurface::selected(const PolygonSoup& soup, MeetingsOf meetings,
                                           std::span<const std::uint32_t> baffles) {
  Selection result;
  for (const auto i : properTriangles(soup)) {
    const bool isBaffle = std::ranges::find(baffles, soup.patches[i]) != baffles.end();
    (isBaffle ? result.baffles : result.walls).push_back(i);
  }
  if (meetings == MeetingsOf::All) result.walls = withoutOpposites(soup, result.walls);
  if (result.walls.empty() && result.baffles.empty()) {
    throw Error(ErrorKind::Topology, "cut cells: the surface bounds nothing");
  }
  return result;
}

CutSurface::CutSurface(const PolygonSoup& triangles, FluidSide side, MeetingsOf meetings,
                       std::span<const std::uint32_t> openPatches,
                       std::span<const std::uint32_t> baffles, const CutPeriod& period)
    : CutSurface(triangles, selected(triangles, meetings, baffles), side, meetings, openPatches,
                 period) {}

CutSurface::CutSurface(const PolygonSoup& soup, const Selection& selection, FluidSide side,
                       MeetingsOf meetings, std::span<const std::uint32_t> openPatches,
                       const CutPeriod& period)
    : frame_(frameOf(soup.boundingBox())),
      period_(period),
      windingOutside_(side == FluidSide::Inside ? 1 : 0),
      patches_(patchesOf(soup, selection.walls)),
      patchNames_(soup.patchNames),
      moved_(inFrame(frame_, soup.points), cornersOf(soup, selection.walls, side),
             cornersOf(soup, selection.baffles, side)),
      openKinds_(findOpenKinds(moved_, patches_, openPatches)) {
  boxes_.reserve(moved_.triangleCount());
  for (std::uint32_t id = 0; id < moved_.triangleCount(); ++id) {
    Box<double> box;
    for (const auto& vertex : moved_.triangle(id)) box.extend(vertex.position);
    boxes_.push_back(box);
  }
  constexpr std::uint32_t kLeafWidth = 16;
  tree_ = detail::buildBinaryBvh(boxes_, kLeafWidth, 0);
  if (meetings != MeetingsOf::None) {
    const auto positions = inFrame(frame_, soup.points);
    const auto corners = cornersOf(soup, selection.walls, side);
    kinds_ =
        findSheetKinds({.surface = moved_,
                        .positions = positions,
                        .corners = corners,
                        .trianglesIn = [this](const Box<double>& box) { return trianglesIn(box); },
                        .windingOutside = windingOutside_,
                        .meetings = meetings,
                        .where = whereCut()});
  }
  if (!moved_.overlapping().empty()) kinds_.resize(moved_.closedCount(), SheetKind::Wall);
  for (const auto i : moved_.overlapping()) kinds_[i] = SheetKind::Meeting;
  if (!selection.baffles.empty()) addBaffles(soup, selection.baffles);
  meetsItself_ = std::ranges::any_of(kinds_, [](SheetKind kind) {
    return kind == SheetKind::Meeting || kind == SheetKind::Baffle;
  });
}

Box<double> CutSurface::whereCut() const {
  auto box = Box<double>::everywhere();
  for (int axis = 0; axis < 3; ++axis) {
    if (!period_.isOn(axis)) continue;
    box.lower[axis] = frame_.toFrame(axis, period_.start[axis]);
    box.upper[axis] = frame_.toFrame(axis, period_.endOf(axis));
  }
  return box;
}

void CutSurface::addBaffles(const PolygonSoup& soup, std::span<const std::uint32_t> baffles) {
  kinds_.resize(moved_.closedCount(), SheetKind::Wall);
  kinds_.resize(moved_.triangleCount(), SheetKind::Baffle);
  patches_.resize(moved_.closedCount(), kNone);
  for (const auto i : baffles) patches_.push_back(soup.patches[i]);
}

bool CutSurface::hasBaffleAt(double z) const {
  return std::any_of(boxes_.begin() + static_cast<std::ptrdiff_t>(moved_.closedCount()),
                     boxes_.end(),
                     [&](const Box<double>& box) { return box.lower.z == z && box.upper.z == z; });
}

std::vector<std::uint32_t> CutSurface::trianglesIn(const Box<double>& box) const {
  std::vector<std::uint32_t> result;
  std::vector<std::uint32_t> pending{0};
  while (!pending.empty()) {
    const auto& node = tree_.nodes[pending.back()];
    pending.pop_back();
    if (!node.box.overlaps(box)) continue;
    if (box.covers(node.box)) {
      const auto all = std::span(tree_.order).subspan(node.begin, node.count());
      result.insert(result.end(), all.begin(), all.end());
      continue;
    }
    if (!node.isLeaf()) {
      pending.push_back(node.left);
      pending.push_back(node.left + 1);
      continue;
    }
    for (auto i = node.begin; i < node.end; ++i) {
      if (boxes_[tree_.order[i]].overlaps(box)) result.push_back(tree_.order[i]);
    }
  }
  sortNumbers(result, boxes_.size());
  return result;
}

}  // namespace cutwater
