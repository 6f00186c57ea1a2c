#include <Cutwater/CutCells/Detail/CutSurface.hpp>

#include <algorithm>
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

/// The triangles with three different corners, turned if the fluid is inside. The sides of the
/// others cancel each other.
PolygonSoup properTriangles(const PolygonSoup& soup, FluidSide side) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
    std::array corners{p[0], p[1], p[2]};
    if (side == FluidSide::Inside) std::swap(corners[1], corners[2]);
    result.addPolygon(corners, soup.patches[i]);
  }
  return result;
}

std::vector<MovedSurface::Corners> cornersOf(const PolygonSoup& soup) {
  std::vector<MovedSurface::Corners> result;
  result.reserve(soup.polygonCount());
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    result.push_back({p[0], p[1], p[2]});
  }
  return result;
}

}  // namespace

CutSurface::CutSurface(const PolygonSoup& triangles, FluidSide side)
    : CutSurface(properTriangles(triangles, side), side == FluidSide::Inside ? 1 : 0) {}

CutSurface::CutSurface(const PolygonSoup& triangles, int windingOutside)
    : frame_(frameOf(triangles.boundingBox())),
      windingOutside_(windingOutside),
      patches_(triangles.patches),
      patchNames_(triangles.patchNames),
      moved_(inFrame(frame_, triangles.points), cornersOf(triangles)) {
  boxes_.reserve(moved_.triangleCount());
  for (std::uint32_t id = 0; id < moved_.triangleCount(); ++id) {
    Box<double> box;
    for (const auto& vertex : moved_.triangle(id)) box.extend(vertex.position);
    boxes_.push_back(box);
  }
}

}  // namespace cutwater
