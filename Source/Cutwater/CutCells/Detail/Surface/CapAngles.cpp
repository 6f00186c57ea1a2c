#include <Cutwater/CutCells/Detail/Surface/CapAngles.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace cutwater {

namespace {

/// Estimates of solid angles are within this.
constexpr double kAngleTolerance = 0x1p-18;

void addAngle(Interval<double>& sum, const Interval<double>& other) {
  sum.lower += other.lower;
  sum.upper += other.upper;
}

/// How large an angle must be on the side of the body, and on the other its negative.
constexpr double kMostAngle = 0.5 + CapAngles::kMargin;

bool mayExceed(const Interval<double>& angle, CapAngles::Sides sides) {
  return (sides.inside && !(angle.upper <= kMostAngle)) ||
         (sides.outside && !(angle.lower >= -kMostAngle));
}
bool doesExceed(const Interval<double>& angle, double limit, CapAngles::Sides sides) {
  return (sides.inside && angle.lower > limit) || (sides.outside && angle.upper < -limit);
}

HoleCaps capsInFrame(const HoleCaps& caps, const CutFrame& frame) {
  auto result = caps;
  for (auto& p : result.positions) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = frame.toFrame(axis, p[axis]);
  }
  return result;
}

/// Beyond it, caps subtend less than half of the full solid angle: at a distance d, those of an
/// area A at most A / d^2.
Box<double> reachOfCaps(const HoleCaps& caps) {
  Box<double> box;
  double area = 0;
  const auto& p = caps.positions;
  for (const auto& [a, b, c] : caps.triangles) {
    box.extend(p[a]).extend(p[b]).extend(p[c]);
    area += 0.5 * length(cross(p[b] - p[a], p[c] - p[a]));
  }
  return box.grown((1 + 0x1p-20) * std::sqrt(area / (2 * std::numbers::pi)));
}

}  // namespace

CapSheet::CapSheet(const HoleCaps& caps, const CapGroup& group)
    : isFlat_(group.isFlat), positions_(caps.positions) {
  triangles_.reserve(group.triangles.size());
  for (const auto id : group.triangles) triangles_.push_back(caps.triangles[id]);
  boxes_ = triangleBoxes<double>(positions_, triangles_);
  constexpr std::uint32_t kLeafWidth = 4;
  boxTree_ = detail::buildBinaryBvh(boxes_, kLeafWidth, 0);
  bvh_ = buildBvh<WindingTree::kArity, WindingTree::kLeafWidth>(boxes_);
  arrays_ = buildWindingMoments<double>(positions_, triangles_, bvh_.tree());
}

bool CapSheet::mayMeet(const Box<double>& box, const QueryBox& query) const {
  return mayMeet(boxTree_.nodes.front(), box, query);
}

bool CapSheet::mayMeet(const detail::BinaryNode& node, const Box<double>& box,
                       const QueryBox& query) const {
  if (!node.box.overlaps(box)) return false;
  if (!node.isLeaf()) {
    return mayMeet(boxTree_.nodes[node.left], box, query) ||
           mayMeet(boxTree_.nodes[node.left + 1], box, query);
  }
  for (auto i = node.begin; i < node.end; ++i) {
    const auto id = boxTree_.order[i];
    if (!boxes_[id].overlaps(box)) continue;
    const auto& [a, b, c] = triangles_[id];
    const std::array corners{positions_[a], positions_[b], positions_[c]};
    if (query.overlapWith(corners) != BoxOverlap::None) return true;
  }
  return false;
}

auto CapSheet::anglesIn(const Box<double>& box) const -> Angles {
  const auto number = winding();
  const auto [value, error] = number.estimate(box.center(), kAngleTolerance);
  const double change = 0.5 * (1 + 0x1p-20) * box.diagonal() * number.gradientBound(box) + error;
  Angles angles{{value - error, value + error}, {value - change, value + change}};
  if (isFlat_) {
    angles.all.lower = std::max(angles.all.lower, -0.5);
    angles.all.upper = std::min(angles.all.upper, 0.5);
  }
  return angles;
}

CapAngles::CapAngles(const HoleCaps& caps, const CutFrame& frame) {
  const auto own = capsInFrame(caps, frame);
  reach_ = reachOfCaps(own);
  for (const auto& group : capsByPlane(own)) sheets_.emplace_back(own, group);
  if (sheets_.size() > 1) {
    CapGroup all{.triangles = std::vector<std::uint32_t>(own.triangles.size()), .isFlat = false};
    std::iota(all.triangles.begin(), all.triangles.end(), 0U);
    whole_.emplace_back(own, all);
  }
}

Disagreement CapAngles::in(const Box<double>& box, Sides sides) const {
  const auto near = box.intersection(reach_);
  if (near.empty()) return Disagreement::None;
  const QueryBox query(OrientedBox<double>::of(near));
  const bool isFree = std::ranges::none_of(
      whole_, [&](const CapSheet& sheet) { return sheet.mayMeet(near, query); });
  for (const auto& sheet : whole_) {
    if (isFree && !mayExceed(sheet.anglesIn(near).all, sides)) return Disagreement::None;
  }
  CapSheet::Angles sum;  // of the sheets that do not meet the box
  int flat = 0;          // sheets that may
  for (const auto& sheet : sheets_) {
    if (!sheet.mayMeet(near, query)) {
      const auto angles = sheet.anglesIn(near);
      addAngle(sum.center, angles.center);
      addAngle(sum.all, angles.all);
    } else if (!sheet.isFlat()) {
      return Disagreement::Possible;
    } else {
      ++flat;
    }
  }
  const double ofFlat = 0.5 * flat;
  const Interval<double> all{sum.all.lower - ofFlat, sum.all.upper + ofFlat};
  if (!mayExceed(all, sides)) return Disagreement::None;
  // Beside a flat cap, its angle comes as close to 1/2 as one likes.
  const bool isFound = flat == 0 ? doesExceed(sum.center, kMostAngle, sides)
                                 : flat == 1 && doesExceed(sum.all, kMargin, sides);
  return isFound ? Disagreement::Found : Disagreement::Possible;
}

}  // namespace cutwater
