#include <Cutwater/CutCells/Detail/Faces/BaffleWays.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

/// On which side of a line from p to q an edge passes; the opposite one for the edge reversed.
bool passesLeft(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& u,
                const Vec3<double>& v) {
  const bool isReversed = std::tie(v.x, v.y, v.z) < std::tie(u.x, u.y, u.z);
  const auto& from = isReversed ? v : u;
  const auto& to = isReversed ? u : v;
  return (dot(cross(from - p, to - p), q - p) >= 0) != isReversed;
}

bool crosses(const Vec3<double>& p, const Vec3<double>& q, const Vec3<double>& a,
             const Vec3<double>& b, const Vec3<double>& c) {
  const auto normal = cross(b - a, c - a);
  if ((dot(normal, p - a) >= 0) == (dot(normal, q - a) >= 0)) return false;
  const bool isLeft = passesLeft(p, q, a, b);
  return isLeft == passesLeft(p, q, b, c) && isLeft == passesLeft(p, q, c, a);
}

/// The same in a plane, of a line and an edge.
bool crossesIn(const FaceAxes& axes, const Vec3<double>& p, const Vec3<double>& q,
               const FaceTrace& trace) {
  const auto side = [&](const Vec3<double>& from, const Vec3<double>& to, const Vec3<double>& at) {
    const auto way = to - from;
    const auto off = at - from;
    return way[axes.first] * off[axes.second] - way[axes.second] * off[axes.first] >= 0;
  };
  return side(p, q, trace.from) != side(p, q, trace.to) &&
         side(trace.from, trace.to, p) != side(trace.from, trace.to, q);
}

}  // namespace

BaffleWays::BaffleWays(const TileSurface& surface, std::span<const TileFragment> fragments) {
  for (const auto& fragment : fragments) {
    if (surface.isBaffle(fragment.triangle)) polygons_.push_back(surface.points(fragment));
  }
}

BaffleWays::BaffleWays(const TileSurface& surface, std::uint32_t face)
    : axes_(surface.numbers().axisOfFace(face)) {
  for (const auto& trace : sortedUnder(surface.traces(), face, &FaceTrace::face)) {
    if (surface.isBaffle(trace.triangle)) traces_.push_back(&trace);
  }
}

bool BaffleWays::isOpen(const Vec3<double>& p, const Vec3<double>& q) const {
  const auto isCrossed = [&](std::span<const Vec3<double>> polygon) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      if (crosses(p, q, polygon[0], polygon[k - 1], polygon[k])) return true;
    }
    return false;
  };
  return std::ranges::none_of(polygons_, isCrossed) &&
         std::ranges::none_of(
             traces_, [&](const FaceTrace* trace) { return crossesIn(axes_, p, q, *trace); });
}

}  // namespace cutwater
