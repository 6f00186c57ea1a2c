#include <Cutwater/CutCells/Detail/Faces/LocalWinding.hpp>

#include <algorithm>
#include <array>
#include <tuple>

namespace cutwater {

namespace {

/// By how much the winding number rises along the second axis of a face up to a point.
int riseAcross(const FaceTrace& trace, const FaceAxes& axes, const Vec3<double>& p) {
  const auto& from = trace.from;
  const auto& to = trace.to;
  const int c = axes.first;
  const int d = axes.second;
  if ((from[c] <= p[c]) == (to[c] <= p[c])) return 0;
  const double height = from[d] + (p[c] - from[c]) / (to[c] - from[c]) * (to[d] - from[d]);
  if (height > p[d]) return 0;
  return to[c] > from[c] ? -1 : 1;  // the fluid is on its left
}

/// By how much it rises up the z axis to a point.
int riseUp(std::span<const Vec3<double>> points, const Vec3<double>& p) {
  bool isInside = false;
  Vec3<double> normal;
  double lowest = points[0].z;
  double highest = points[0].z;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto* a = &points[k];
    const auto* b = &points[(k + 1) % points.size()];
    normal += cross(*a - points[0], *b - points[0]);
    lowest = std::min(lowest, a->z);
    highest = std::max(highest, a->z);
    if ((a->y <= p.y) == (b->y <= p.y)) continue;
    if (a->y > b->y) std::swap(a, b);  // the same for both polygons at the edge
    if (p.x < a->x + (p.y - a->y) / (b->y - a->y) * (b->x - a->x)) isInside = !isInside;
  }
  if (!isInside || normal.z == 0 || lowest > p.z) return 0;
  const double height =
      points[0].z - (normal.x * (p.x - points[0].x) + normal.y * (p.y - points[0].y)) / normal.z;
  if (std::clamp(height, lowest, highest) > p.z) return 0;
  return normal.z > 0 ? -1 : 1;
}

/// Boxes in a leaf of the trees.
constexpr std::uint32_t kLeafWidth = 8;
/// By how much crossings of a polygon's edges may be computed beyond its ends.
constexpr double kBeyondEnds = 0x1p-40;

/// Calls visit(i) for the boxes that may contain something at the point or below it along z.
template <typename Visit>
void forBoxesAt(const detail::BinaryBvh& tree, const Vec3<double>& p, Visit&& visit) {
  if (tree.nodes.empty()) return;
  std::array<std::uint32_t, detail::mostLevels(kLeafWidth) + 2> pending{};
  std::size_t count = 1;
  while (count > 0) {
    const auto& node = tree.nodes[pending[--count]];
    const auto& [lower, upper] = std::tie(node.box.lower, node.box.upper);
    const bool isBeside = p.x < lower.x || p.x > upper.x || p.y < lower.y || p.y > upper.y;
    if (isBeside || p.z < lower.z) continue;
    if (node.isLeaf()) {
      for (auto i = node.begin; i < node.end; ++i) visit(tree.order[i]);
    } else {
      pending[count++] = node.left;
      pending[count++] = node.left + 1;
    }
  }
}

}  // namespace

WindingOnFace::WindingOnFace(const TileSurface& surface, const EdgeStretches& stretches,
                             std::uint32_t face)
    : axes_(surface.numbers().axisOfFace(face)) {
  const auto place = surface.numbers().placeOfFace(face);
  atCorner_ = stretches.winding(place);
  crossings_ = surface.crossingsOf(surface.numbers().edge(axes_.first, place));
  std::vector<Box<double>> boxes;
  for (const auto traces : {surface.traces(), surface.buriedTraces()}) {
    for (const auto& trace : sortedUnder(traces, face, &FaceTrace::face)) {
      if (surface.isBaffle(trace.triangle)) continue;
      const double from = trace.from[axes_.first];
      const double to = trace.to[axes_.first];
      traces_.push_back(&trace);
      boxes.push_back({{std::min(from, to), 0, 0}, {std::max(from, to), 0, 0}});
    }
  }
  if (!boxes.empty()) tree_ = detail::buildBinaryBvh(boxes, kLeafWidth, 1);
}

int WindingOnFace::at(const Vec3<double>& p) const {
  int winding = atCorner_;
  for (const auto& crossing : crossings_) {
    if (crossing.position <= p[axes_.first]) winding += crossing.rise;
  }
  forBoxesAt(tree_, {p[axes_.first], 0, 0},
             [&](std::uint32_t i) { winding += riseAcross(*traces_[i], axes_, p); });
  return winding;
}

WindingInCell::WindingInCell(const TileSurface& surface, const EdgeStretches& stretches,
                             std::uint32_t cell)
    : onFace_(surface, stretches, surface.numbers().face(2, surface.numbers().placeOfCell(cell))) {
  std::vector<Box<double>> boxes;
  for (const auto fragments : {surface.fragments(), surface.buriedFragments()}) {
    for (const auto& fragment : sortedUnder(fragments, cell, &TileFragment::cell)) {
      if (surface.isBaffle(fragment.triangle)) continue;
      polygons_.push_back(surface.points(fragment));
      auto& box = boxes.emplace_back();
      for (const auto& p : polygons_.back()) box.extend(p);
      box.lower.x -= kBeyondEnds;
      box.upper.x += kBeyondEnds;
    }
  }
  if (!boxes.empty()) tree_ = detail::buildBinaryBvh(boxes, kLeafWidth, 1);
}

int WindingInCell::at(const Vec3<double>& p) const {
  int winding = onFace_.at(p);
  forBoxesAt(tree_, p, [&](std::uint32_t i) { winding += riseUp(polygons_[i], p); });
  return winding;
}

}  // namespace cutwater
