#include <Cutwater/CutCells/Detail/Curved/SurfaceMeetings.hpp>
#include <Cutwater/CutCells/Detail/Curved/SurfaceSweep.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kOnIt = 1e-3;         // of the box: how near to a surface samples are
constexpr std::ptrdiff_t kFew = 3;     // samples on a surface
constexpr double kClearly = 1 + 1e-9;  // larger, and not by rounding: mirror images are alike
constexpr double kParallel = 1e-7;     // components of a unit normal that count as zero

bool haveBothSigns(std::span<const double> values) {
  const auto [least, most] = std::ranges::minmax(values);
  return least < -kParallel && most > kParallel;
}

}  // namespace

SurfaceSweep::SurfaceSweep(const FluidField& field, std::span<const GaussPoint> gauss,
                           const Box<double>& box, std::span<const FluidField* const> surfaces)
    : field_(field), gauss_(gauss), box_(box), flatAxis_(flatAxisOf(box)) {
  for (const auto* surface : surfaces) see(*surface);
  for (const auto& seen : seen_) surfaces_.push_back(seen.field);
  chooseAxes();
}

/// Samples a surface near the corners and the middle of the box. One that none of these meets on
/// the way to it, and that has the corners on one side, is left out, as is a plane that a rectangle
/// lies in.
void SurfaceSweep::see(const FluidField& surface) {
  Seen seen{.field = &surface};
  std::array<double, kSamples> values{};
  for (int i = 0; i < 8; ++i) seen.points[static_cast<std::size_t>(i)] = box_.corner(i);
  seen.points.back() = box_.center();
  surface.values(seen.points, values);
  const bool isMet = sample(values, seen);
  bool isSteady = true;
  double best = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!isFree(axis)) continue;
    std::array<double, kSamples> along{};
    std::array<double, kSamples> onIt{};
    double least = 1;
    for (std::size_t i = 0; i < kSamples; ++i) {
      along[i] = seen.normals[i][axis];
      if (!seen.isOnIt[i]) continue;
      onIt[i] = along[i];
      least = std::min(least, std::abs(along[i]));
    }
    seen.isMonotone[static_cast<std::size_t>(axis)] = !haveBothSigns(onIt);
    isSteady = isSteady && !haveBothSigns(along);
    if (least > kClearly * best) best = least, seen.wallAxis = axis;
  }
  constexpr double kSlope = 0.2;
  seen.isGraph = best >= kSlope;
  const auto isAbove = [](double value) { return value > 0; };
  const auto isBelow = [](double value) { return value < 0; };
  const bool isElsewhere =
      !isMet && (std::ranges::all_of(values, isAbove) || std::ranges::all_of(values, isBelow));
  const bool isParallel = surface.facts().isFlat && seen.normals[0] == Vec3<double>{};
  if (!(isSteady && (isElsewhere || isParallel))) seen_.push_back(seen);
}

/// Moves a point with a value to the surface, within the box: by steps of Newton's method along the
/// gradient, or what of it does not lead out of the box.
void SurfaceSweep::draw(Vec3<double>& point, double& value, const FluidField& surface) const {
  constexpr int kSteps = 4;
  const double near = kOnIt * box_.diagonal();
  for (int step = 0; step < kSteps && std::abs(value) > near; ++step) {
    auto slope = slopeOf(surface, point);
    for (int axis = 0; axis < 3; ++axis) {
      const double move = -value * slope[axis];
      const bool leaves = (point[axis] <= box_.lower[axis] && move < 0) ||
                          (point[axis] >= box_.upper[axis] && move > 0);
      if (leaves) slope[axis] = 0;
    }
    const double steepness = lengthSquared(slope);
    if (steepness == 0) break;
    point -= (value / steepness) * slope;
    point = max(box_.lower, min(point, box_.upper));
    value = surface.value(point);
  }
}

Vec3<double> SurfaceSweep::slopeOf(const FluidField& surface, const Vec3<double>& point) const {
  auto slope = surface.gradient(point);
  if (flatAxis_ >= 0) slope[flatAxis_] = 0;
  return slope;
}

/// Returns whether a way from a sample to a curved surface ends on it, within the box.
bool SurfaceSweep::sample(std::span<const double> values, Seen& seen) const {
  if (seen.field->facts().isFlat) {
    seen.normals.fill(normalized(slopeOf(*seen.field, seen.points[0])));
    seen.isOnIt.fill(true);
    return false;
  }
  for (std::size_t i = 0; i < kSamples; ++i) {
    auto& point = seen.points[i];
    double value = values[i];
    draw(point, value, *seen.field);
    seen.normals[i] = normalized(slopeOf(*seen.field, point));
    seen.isOnIt[i] = std::abs(value) <= kOnIt * box_.diagonal();
  }
  const auto count = std::ranges::count(seen.isOnIt, true);
  if (count < kFew) seen.isOnIt.fill(true);
  return count > 0;
}

/// Whether two surfaces may begin or end to meet at a slice: their tangents in it are parallel
/// somewhere between the samples.
bool SurfaceSweep::mayTouchInRows(const Seen& a, const Seen& b, const SweepAxes& axes) const {
  std::array<double, kSamples> determinants{};
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (!a.isOnIt[i] && !b.isOnIt[i]) continue;
    determinants[i] = a.normals[i][axes.line] * b.normals[i][axes.row] -
                      a.normals[i][axes.row] * b.normals[i][axes.line];
  }
  return haveBothSigns(determinants) && mayMeet(a, b) && mayMeet(b, a);
}

/// Whether samples of one surface are on both sides of another.
bool SurfaceSweep::mayMeet(const Seen& a, const Seen& b) const {
  std::array<double, kSamples> other{};
  b.field->values(a.points, other);
  bool isAbove = false;
  bool isBelow = false;
  for (std::size_t i = 0; i < kSamples; ++i) {
    isAbove = isAbove || (a.isOnIt[i] && other[i] >= 0);
    isBelow = isBelow || (a.isOnIt[i] && other[i] <= 0);
  }
  return isAbove && isBelow;
}

int SurfaceSweep::flawsOf(const SweepAxes& axes) const {
  int flaws = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const auto& seen = seen_[i];
    flaws += seen.isGraph ? 0 : 1;
    flaws += seen.isMonotoneAlong(axes.line) ? 0 : 1;
    flaws += seen.isMonotoneAlong(axes.row) ? 0 : 1;
    if (flatAxis_ >= 0) continue;
    for (std::size_t j = 0; j < i; ++j) flaws += mayTouchInRows(seen, seen_[j], axes) ? 1 : 0;
  }
  return flaws;
}

/// Whether a surface that is no plane leaves through the ends of lines nearly along rows: where it
/// leaves a row then changes abruptly from slice to slice.
bool SurfaceSweep::leavesAlongRows(const Seen& seen, const SweepAxes& axes) const {
  constexpr double kSlope = 0.3;
  if (flatAxis_ >= 0 || seen.field->facts().isFlat) return false;
  bool isAlong = false;
  double most = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    if (!seen.isOnIt[i]) continue;
    const double row = std::abs(seen.normals[i][axes.row]);
    const double slice = std::abs(seen.normals[i][axes.slice]);
    isAlong = isAlong || row < kSlope * std::hypot(row, slice);
    most = std::max(most, row);
  }
  return isAlong && most > kParallel;
}

/// Those with the fewest flaws, along which most walls are graphs.
void SurfaceSweep::chooseAxes() {
  constexpr int kFlaw = 1000;
  constexpr int kAbrupt = 50;
  constexpr int kSlice = 4;  // a sweep of its own, which a wall along rows does not need
  int least = -1;
  for (int line = 0; line < 3; ++line) {
    for (const int turn : {1, 2}) {
      const SweepAxes axes{line, (line + turn) % 3, (line + 3 - turn) % 3};
      const int flat = flatAxis_;
      if (flat >= 0 && axes.slice != flat) continue;
      const int flaws = flawsOf(axes);
      int cost = kFlaw * flaws;
      for (const auto& seen : seen_) {
        if (leavesAlongRows(seen, axes)) cost += kAbrupt;
        if (seen.wallAxis == axes.slice) cost += kSlice;
        if (seen.wallAxis == axes.row) cost += 1;
      }
      if (least < 0 || cost < least) least = cost, axes_ = axes, flaws_ = flaws;
    }
  }
}

bool SurfaceSweep::hasWallAlong(int axis) const {
  return std::ranges::any_of(seen_, [&](const Seen& seen) { return seen.wallAxis == axis; });
}

bool SurfaceSweep::hasKink() const {
  return std::ranges::any_of(seen_, [&](const Seen& seen) {
    if (seen.field->facts().isFlat) return false;
    std::vector<Vec3<double>> points;
    std::vector<Vec3<double>> normals;
    for (std::size_t i = 0; i < kSamples; ++i) {
      if (!seen.isOnIt[i]) continue;
      points.push_back(seen.points[i]);
      normals.push_back(seen.normals[i]);
    }
    return isKinked(*seen.field, points, normals, flatAxis_);
  });
}

/// Where a surface turns along an axis that it should not turn along, on the line through the
/// middle; else the middle along the axis along which normals differ most.
SurfaceSweep::Division SurfaceSweep::division() const {
  constexpr int kHalvings = 40;
  constexpr double kMargin = 1e-3;  // of the box
  const auto size = box_.size();
  for (const auto& seen : seen_) {
    for (const int axis : {axes_.line, axes_.row}) {
      if (seen.isMonotoneAlong(axis)) continue;
      auto point = box_.center();
      const auto slopeAt = [&](double at) {
        point[axis] = at;
        return seen.field->gradient(point)[axis];
      };
      double low = box_.lower[axis];
      double high = box_.upper[axis];
      const double atLow = slopeAt(low);
      if ((atLow > 0) == (slopeAt(high) > 0)) continue;
      double at = 0.5 * (low + high);
      for (int i = 0; i < kHalvings; ++i) {
        const double slope = slopeAt(at);
        if (slope == 0) break;
        ((slope > 0) == (atLow > 0) ? low : high) = at;
        at = 0.5 * (low + high);
      }
      const double margin = kMargin * size[axis];
      if (at > box_.lower[axis] + margin && at < box_.upper[axis] - margin) return {axis, at};
    }
  }
  const int axis = bendingAxis();
  return {axis, box_.center()[axis]};
}

/// Along which normals at both ends of the box differ most; the longest, if they do not.
int SurfaceSweep::bendingAxis() const {
  constexpr double kSame = 1e-6;
  int best = nearestAxis(box_.size());
  double most = kSame;
  for (int axis = 0; axis < 3; ++axis) {
    if (!isFree(axis)) continue;
    const auto end = std::size_t{1} << static_cast<unsigned>(axis);
    for (const auto& seen : seen_) {
      double bend = 0;
      for (std::size_t corner = 0; corner < 8; ++corner) {
        if ((corner & end) == 0) {
          bend += length(seen.normals[corner | end] - seen.normals[corner]);
        }
      }
      if (bend > kClearly * most) most = bend, best = axis;
    }
  }
  return best;
}

/// Appends the coordinates of points of a region where as many surfaces meet in the wall as it has
/// dimensions.
void SurfaceSweep::addMeetings(const Box<double>& region, int axis,
                               std::vector<double>& found) const {
  constexpr double kInWall = 1e-9;  // of the region
  std::vector<const FluidField*> here;
  for (const auto* surface : surfaces_) {
    if (surface->mayReach(region)) here.push_back(surface);
  }
  const auto size = region.size();
  const bool isPlane = std::min({size.x, size.y, size.z}) <= 0;
  const double tolerance = kInWall * region.diagonal();
  const auto add = [&](std::span<const FluidField* const> surfaces) {
    const auto point = meetingOf(surfaces, region);
    if (point && std::abs(field_.value(*point)) <= tolerance) found.push_back((*point)[axis]);
  };
  for (std::size_t i = 0; i < here.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (isPlane) {
        add(std::array{here[j], here[i]});
        continue;
      }
      for (std::size_t k = 0; k < j; ++k) add(std::array{here[k], here[j], here[i]});
    }
  }
}

std::vector<SweptSlice> SurfaceSweep::slices(const SweepAxes& axes, LineCrossings& edges) const {
  const double lower = box_.lower[axes.slice];
  if (flatAxis_ >= 0) return {{lower, 1, 0}};
  std::vector<AxisLine> along;
  for (const double end : {box_.lower[axes.line], box_.upper[axes.line]}) {
    for (const double row : {box_.lower[axes.row], box_.upper[axes.row]}) {
      AxisLine edge{box_.lower, box_.upper[axes.slice], axes.slice};
      edge.start[axes.line] = end;
      edge.start[axes.row] = row;
      along.push_back(edge);
    }
  }
  edges.find(along, surfaces_);
  std::vector<double> ends;
  for (std::size_t i = 0; i < along.size(); ++i) {
    ends.insert(ends.end(), edges.of(i).begin(), edges.of(i).end());
  }
  for (const int axis : {axes.line, axes.row}) {
    for (const bool isHigh : {false, true}) {
      addMeetings(faceOf(box_, axis, isHigh), axes.slice, ends);
    }
  }
  addMeetings(box_, axes.slice, ends);
  std::ranges::sort(ends);
  ends.push_back(box_.upper[axes.slice]);
  std::vector<SweptSlice> found;
  forStretches(gauss_, lower, ends, [&](double at, double weight, std::uint32_t stretch) {
    found.push_back({at, weight, stretch});
  });
  return found;
}

void SurfaceSweep::run(const Into& into) const {
  auto axes = axes_;
  const auto found = slices(axes, into.rims);
  sweep(axes, found, true, into);
  std::swap(axes.line, axes.row);
  if (hasWallAlong(axes.line)) sweep(axes, found, false, into);
  if (flatAxis_ >= 0 || !hasWallAlong(axes.slice)) return;
  std::swap(axes.line, axes.slice);
  sweep(axes, slices(axes, into.rims), false, into);
}

/// Adds the fluid if it is asked for, and walls that are graphs along lines.
void SurfaceSweep::sweep(const SweepAxes& axes, std::span<const SweptSlice> slices, bool withFluid,
                         const Into& into) const {
  std::vector<AxisLine> rims;
  for (const auto& slice : slices) {
    for (const double end : {box_.lower[axes.line], box_.upper[axes.line]}) {
      rims.push_back(rimAt(box_, axes, slice.at, end));
    }
  }
  into.rims.find(rims, surfaces_);
  SweptLines swept{.sweep = into.points.sweeps++};
  std::vector<double> ends;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    ends.clear();
    for (const auto rim : {2 * i, 2 * i + 1}) {
      const auto found = into.rims.of(rim);
      ends.insert(ends.end(), found.begin(), found.end());
    }
    auto slice = box_;
    slice.lower[axes.slice] = slice.upper[axes.slice] = slices[i].at;
    addMeetings(slice, axes.row, ends);
    swept.addRow(gauss_, box_, axes, slices[i], ends);
  }
  into.lines.find(swept.lines, surfaces_);
  const auto takesWall = [&](const FluidField* surface, const Vec3<double>&) {
    const auto seen = std::ranges::find(seen_, surface, &Seen::field);
    return seen == seen_.end() ? withFluid : seen->wallAxis == axes.line;
  };
  for (std::size_t i = 0; i < swept.lines.size(); ++i) {
    addLinePoints(field_, {into.lines, i, {swept.lines[i], swept.weights[i]}},
                  {flatAxis_, withFluid, swept.places[i]}, takesWall, into.points);
  }
}

}  // namespace cutwater
