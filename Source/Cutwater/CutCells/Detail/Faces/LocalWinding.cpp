#include <Cutwater/CutCells/Detail/Faces/FaceAxes.hpp>
#include <Cutwater/CutCells/Detail/Faces/LocalWinding.hpp>

#include <algorithm>

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

}  // namespace

int windingOnFace(const TileSurface& surface, const EdgeStretches& stretches, std::uint32_t face,
                  const Vec3<double>& p) {
  const auto& numbers = surface.numbers();
  const FaceAxes axes(numbers.axisOfFace(face));
  const auto place = numbers.placeOfFace(face);
  int winding = stretches.winding(place);
  for (const auto& crossing : surface.crossingsOf(numbers.edge(axes.first, place))) {
    if (crossing.position <= p[axes.first]) winding += crossing.rise;
  }
  for (const auto traces : {surface.traces(), surface.buriedTraces()}) {
    for (const auto& trace : sortedUnder(traces, face, &FaceTrace::face)) {
      winding += riseAcross(trace, axes, p);
    }
  }
  return winding;
}

int windingInCell(const TileSurface& surface, const EdgeStretches& stretches, std::uint32_t cell,
                  const Vec3<double>& p) {
  const auto& numbers = surface.numbers();
  int winding = windingOnFace(surface, stretches, numbers.face(2, numbers.placeOfCell(cell)), p);
  for (const auto fragments : {surface.fragments(), surface.buriedFragments()}) {
    for (const auto& fragment : sortedUnder(fragments, cell, &TileFragment::cell)) {
      winding += riseUp(surface.points(fragment), p);
    }
  }
  return winding;
}

}  // namespace cutwater
