#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/CutPlane.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

CutPlane CutPlane::across(int axis, double value, Keep keep) {
  require(axis >= 0 && axis <= 2, "CutPlane: need an axis 0, 1 or 2", Named{"axis", axis});
  require(std::isfinite(value), "CutPlane: need a finite position", Named{"value", value});
  const double sign = keep == Keep::Lower ? 1 : -1;
  CutPlane plane{{}, sign * value};
  plane.normal[axis] = sign;
  return plane;
}

CutPlane CutPlane::through(const Vec3<double>& point, const Vec3<double>& removed) {
  require(isFinite(point), "CutPlane: need a finite point", Named{"point", point});
  const auto normal = detail::unitVector("CutPlane", "direction", removed);
  return {normal, dot(normal, point)};
}

namespace detail {

namespace {

std::vector<CutPlane> sidesOf(const Box<double>& box) {
  std::vector<CutPlane> sides;
  for (int axis = 0; axis < 3; ++axis) {
    sides.push_back(CutPlane::across(axis, box.upper[axis], CutPlane::Keep::Lower));
    sides.push_back(CutPlane::across(axis, box.lower[axis], CutPlane::Keep::Upper));
  }
  return sides;
}

/// Clips the range to the part that the plane keeps; returns whether the ray now enters through it.
bool clipTo(const CutPlane& plane, const Ray& ray, RayRange& range) {
  const double speed = dot(plane.normal, ray.direction);  // outwards
  const double height = plane.beyond(ray.origin);
  if (speed > 0) {
    range.end = std::min(range.end, -height / speed);
  } else if (speed < 0) {
    const double entry = -height / speed;
    if (!(entry > range.begin)) return false;
    range.begin = entry;
    return true;
  } else if (height > 0) {
    range.end = -std::numeric_limits<double>::infinity();
  }
  return false;
}

}  // namespace

KeptRegion::KeptRegion(const Box<double>& box, std::span<const CutPlane> cuts, bool cutsAtBox)
    : box_(box), cuts_(cuts.begin(), cuts.end()) {
  const auto sides = sidesOf(box);
  auto& list = cutsAtBox ? cuts_ : sides_;
  list.insert(list.end(), sides.begin(), sides.end());
}

Box<double> KeptRegion::rest() const {
  auto rest = box_;
  for (const auto& cut : cuts_) {
    for (int axis = 0; axis < 3; ++axis) {
      if (cut.normal[axis] == 1) rest.upper[axis] = std::min(rest.upper[axis], cut.offset);
      if (cut.normal[axis] == -1) rest.lower[axis] = std::max(rest.lower[axis], -cut.offset);
    }
  }
  return rest;
}

RayRange KeptRegion::clip(const Ray& ray, double nearest) const {
  RayRange range{nearest, std::numeric_limits<double>::infinity()};
  for (const auto& side : sides_) clipTo(side, ray, range);
  for (std::size_t i = 0; i < cuts_.size(); ++i) {
    if (clipTo(cuts_[i], ray, range)) range.cut = static_cast<std::uint32_t>(i);
  }
  return range;
}

double KeptRegion::clearance(const Vec3<double>& p) const {
  double farthest = 0;
  for (const auto& cut : cuts_) farthest = std::max(farthest, cut.beyond(p));
  return farthest;
}

}  // namespace detail

}  // namespace cutwater
