#include <Cutwater/CutCells/Detail/Faces/EdgeLoops.hpp>
#include <Cutwater/CutCells/Detail/Faces/FaceFrame.hpp>
#include <Cutwater/CutCells/Detail/Faces/JoinedLoops.hpp>
#include <Cutwater/CutCells/Detail/Faces/MergedPoints.hpp>
#include <Cutwater/CutCells/Detail/Faces/RegionOutlines.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using Loop = EdgeLoops::Loop;

/// Adds the corners of the face, ends of stretches and of traces; returns what stands for them.
std::vector<Vec3<double>> addKnown(const FacePieces& faces, std::uint32_t face,
                                   MergedPoints& merged) {
  const auto& surface = faces.surface();
  const FaceFrame frame(surface.numbers(), faces.planes(), face);
  std::vector<Vec3<double>> points;
  for (int corner = 0; corner < 4; ++corner) points.push_back(frame.corner(corner));
  for (int side = 0; side < 4; ++side) {
    const auto edge = edgeOfFace(frame.axes().across, frame.place(), side);
    for (const auto& stretch : faces.stretches().of(edge.axis, edge.place)) {
      for (const auto& end : frame.endsOf(side, stretch)) points.push_back(end);
    }
  }
  merged.keep(points);
  for (const auto& trace : sortedUnder(surface.traces(), face, &FaceTrace::face)) {
    points.push_back(merged.merged(trace.from));
    points.push_back(merged.merged(trace.to));
  }
  return points;
}

/// Whether a point lies on the line between two, but for rounding.
bool isBetween(const Vec3<double>& p, const Vec3<double>& from, const Vec3<double>& to) {
  const auto way = to - from;
  return dot(p - from, way) > 0 && dot(p - to, way) < 0 &&
         length(cross(p - from, way)) <= MergedPoints::kSame * length(way);
}

/// Takes away corners at which the outline goes straight on, but for those of triangles within the
/// face: others do not have them.
void straighten(Loop& loop, std::span<const Vec3<double>> kept) {
  for (std::size_t i = 0; i < loop.size() && loop.size() > 3;) {
    const auto& before = loop[(i + loop.size() - 1) % loop.size()];
    const auto& after = loop[(i + 1) % loop.size()];
    const bool isNeeded =
        std::ranges::find(kept, loop[i]) != kept.end() || !isBetween(loop[i], before, after);
    if (isNeeded) {
      ++i;
    } else {
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace

void addRegionOutlines(const FacePieces& faces, std::uint32_t face, CutCells::Polygons& out) {
  const FaceAxes axes(faces.surface().numbers().axisOfFace(face));
  MergedPoints points;
  const auto known = addKnown(faces, face, points);
  auto regions = faces.regionsOn(face);
  for (auto& region : regions) region.polygon = points.mergedPolygon(region.polygon);
  const auto [first, last] = faces.of(face);
  std::vector<EdgeLoops> edges(last - first);
  for (const auto& region : regions) {
    if (region.part != kNone) edges[region.part - first].add(points.throughPoints(region.polygon));
  }
  for (auto& ofPart : edges) {
    auto loops = ofPart.loopsAcross(axes.across);
    for (auto& loop : loops) straighten(loop, known);
    std::erase_if(loops, [](const Loop& loop) { return loop.size() < 3; });
    out.add(joinedLoops(axes, std::move(loops)));
  }
}

}  // namespace cutwater
