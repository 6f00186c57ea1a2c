#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Mesh/Detail/ClippedSegment.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

struct Place {
  Vec3<double> point;
  double parameter;
};

/// Where the segment meets the plane at this height along the axis.
std::optional<Place> meet(const Segment<double>& segment, int axis, double height) {
  const auto& [s, e] = segment;
  if (s[axis] == e[axis] || height < std::min(s[axis], e[axis]) ||
      height > std::max(s[axis], e[axis])) {
    return std::nullopt;
  }
  const auto whole = DoubleDouble::difference(e[axis], s[axis]);
  Place result{s, static_cast<double>(DoubleDouble::difference(height, s[axis]) / whole)};
  for (int other = 0; other < 3; ++other) {
    // From the line's height above the origin, as interpolation would cancel digits.
    const auto atOrigin =
        DoubleDouble::product(s[other], e[axis]) - DoubleDouble::product(e[other], s[axis]);
    const auto rise = DoubleDouble(height) * DoubleDouble::difference(e[other], s[other]);
    result.point[other] = static_cast<double>((atOrigin + rise) / whole);
  }
  result.point[axis] = height;
  return result;
}

}  // namespace

std::optional<ClippedSegment> clipped(const Segment<double>& segment, const Box<double>& box) {
  const bool startsWithin = box.contains(segment.start);
  const bool endsWithin = box.contains(segment.end);
  if (startsWithin && endsWithin) return ClippedSegment{segment};

  // Scaled so that products of the largest do not overflow, and of the others do not underflow.
  const double largest = std::max(maxComponent(abs(segment.start)), maxComponent(abs(segment.end)));
  const double unit = std::ldexp(1.0, std::max(std::ilogb(largest) - 400, -1022));
  const Segment<double> local{segment.start / unit, segment.end / unit};
  // Points are ordered along the axis in which the segment is longest: parameters need not
  // distinguish the two sides of the box.
  const Vec3<double> extent = abs(local.end - local.start);
  const int longest = extent.x >= extent.y && extent.x >= extent.z ? 0
                      : extent.y >= extent.z                       ? 1
                                                                   : 2;
  const bool upwards = local.start[longest] < local.end[longest];
  const auto isBefore = [&](const Place& a, const Place& b) {
    return upwards ? a.point[longest] < b.point[longest] : b.point[longest] < a.point[longest];
  };
  std::optional<Place> entry;
  std::optional<Place> exit;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double height : {box.lower[axis], box.upper[axis]}) {
      auto place = meet(local, axis, height / unit);
      if (!place) continue;
      place->point = unit * place->point;
      if (!box.contains(place->point)) continue;
      if (!entry || isBefore(*place, *entry)) entry = place;
      if (!exit || isBefore(*exit, *place)) exit = place;
    }
  }
  if (!entry) return std::nullopt;
  const Place first = startsWithin ? Place{segment.start, 0} : *entry;
  const Place last = endsWithin ? Place{segment.end, 1} : *exit;
  return ClippedSegment{
      {first.point, last.point}, first.parameter, std::max(first.parameter, last.parameter)};
}

}  // namespace cutwater
