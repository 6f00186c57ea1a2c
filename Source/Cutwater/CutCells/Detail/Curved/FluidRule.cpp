#include <Cutwater/CutCells/Detail/Curved/ExposedSurfaces.hpp>
#include <Cutwater/CutCells/Detail/Curved/FluidRule.hpp>
#include <Cutwater/CutCells/Detail/Curved/KinkSweep.hpp>
#include <Cutwater/CutCells/Detail/Curved/SurfaceSweep.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

namespace {

constexpr int kMostHalvings = 4;  // along each axis
constexpr int kMostParts = 400;

/// The area of the largest side of a box; the length of that of a rectangle.
double largestSide(const BoxView& view) {
  const auto size = view.box().size();
  if (view.flatAxis() >= 0) return maxComponent(size);
  return std::max({size.x * size.y, size.y * size.z, size.z * size.x});
}

/// The volume of a box; the area of a rectangle.
double measureOf(const BoxView& view) {
  double product = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (view.isFree(axis)) product *= view.box().size()[axis];
  }
  return product;
}

/// What edges of a rectangle have of fluid.
OpenShares openEdges(const BoxView& view) {
  OpenShares edges;
  for (int axis = 0; axis < 3; ++axis) {
    if (!view.isFree(axis)) continue;
    const int across = 3 - axis - view.flatAxis();
    for (const int side : {0, 1}) edges.add(across, side, view.fluidLength(axis, side));
  }
  return edges;
}

/// The parts of a box below and above a coordinate.
std::array<Box<double>, 2> halvesOf(const Box<double>& box, int axis, double at) {
  std::array halves{box, box};
  halves[0].upper[axis] = at;
  halves[1].lower[axis] = at;
  return halves;
}

/// Whether faces of a box that no wall crosses in edges are not all fluid or all body, as its
/// corners are.
bool isPierced(const BoxView& view, const OpenShares& sides) {
  constexpr double kRounding = 1e-14;
  if (view.flatAxis() >= 0 || view.isCrossed()) return false;
  const auto size = view.box().size();
  bool result = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double both = 2 * size[(axis + 1) % 3] * size[(axis + 2) % 3];
    const double other = view.isFluid(0) ? both - sides.sum[axis] : sides.sum[axis];
    result = result || other > kRounding * both;
  }
  return result;
}

}  // namespace

void FluidRule::findIn(const BoxView& rectangle, double tolerance) {
  findIn(rectangle, openEdges(rectangle), tolerance);
}

void FluidRule::findIn(const BoxView& view, const OpenShares& sides, double tolerance) {
  constexpr int kMostLines = 6000;
  struct Attempt {
    int points = 0;    // of each Gauss rule
    int halvings = 0;  // along each axis
  };
  const std::array<Attempt, 4> attempts{
      {{fewest_, 0}, {kMostGaussPoints, 0}, {kMostGaussPoints, 1}, {fewest_, 2}}};
  flatAxis_ = view.flatAxis();
  parts_ = 0;
  linesLeft_ = kMostLines;
  int partsOfLast = 0;
  const bool isFoundInFaces =
      !field_.knowsSurfaces() && isPierced(view, sides) && !view.hiddenPoint();
  const auto pierced = isFoundInFaces ? view.hiddenPointInFaces() : std::nullopt;
  bool isFirst = true;
  for (const auto& [points, halvings] : attempts) {
    if (!isFirst && points == fewest_ && halvings == 0) continue;
    if (!isFirst && parts_ + partsOfLast > kMostParts) return;  // it could not be as thorough
    const int partsBefore = parts_;
    mostParts_ = kMostParts;
    gauss_ = gaussPoints(points);
    std::swap(points_, best_);
    points_.clear();
    missed_ = 0;
    if (field_.knowsSurfaces()) {
      addBetweenSurfaces(view.box(), field_.surfacesNear(view.box()), 0, halvings);
    } else if (pierced) {
      splitAt(view.box(), *pierced, 0, halvings);
    } else {
      addPart(view, 0, halvings);
    }
    const double gap = gapIn(view, sides);
    if (isFirst || gap < gap_) {
      gap_ = gap;
    } else {
      std::swap(points_, best_);
    }
    isFirst = false;
    partsOfLast = parts_ - partsBefore;
    if (gap_ <= tolerance) return;
  }
}

void FluidRule::takeAll(const Box<double>& box) {
  points_.clear();
  gap_ = 0;
  gauss_ = gaussPoints(fewest_);
  addWhole(box, flatAxisOf(box));
}

double FluidRule::gapIn(const BoxView& view, const OpenShares& sides) const {
  const auto middle = view.box().center();
  auto open = sides.difference;
  Vec3<double> moments;
  for (const auto& wall : points_.walls) {
    const auto vector = wall.weight * wall.normal;
    open += vector;
    for (int axis = 0; axis < 3; ++axis) {
      moments[axis] += vector[axis] * (wall.at[axis] - middle[axis]);
    }
  }
  double volume = 0;
  for (const auto& span : points_.spans) volume += span.size();
  double error = missed_;
  for (int axis = 0; axis < 3; ++axis) {
    if (!view.isFree(axis)) continue;
    const double ofSides = 0.5 * view.box().size()[axis] * sides.sum[axis];
    error = std::max(error, std::abs(ofSides + moments[axis] - volume));
  }
  return std::max(length(open) / largestSide(view), error / measureOf(view));
}

void FluidRule::addPart(const BoxView& view, int depth, int halvings) {
  const auto& box = view.box();
  const int dimension = view.flatAxis() < 0 ? 3 : 2;
  ++parts_;
  const bool mayHalve = depth < kMostHalvings * dimension && parts_ < mostParts_;
  if (mayHalve && splitAtTurn(view, depth, halvings)) return;
  if (!view.isCrossed()) return addUncrossed(view, depth, halvings, mayHalve);
  bool isGood = false;
  const auto axes = view.bestAxes(isGood);
  const bool mustHalve = mayHalve && depth < halvings * dimension;
  if (!mustHalve && linesLeft_ > 0 && view.hasKink()) {
    return KinkSweep(field_, gauss_, view, linesLeft_, points_).run(axes, isGood);
  }
  if (mustHalve || (mayHalve && !isGood)) {
    const int longest = nearestAxis(box.size());
    return split(box, longest, box.center()[longest], depth, halvings);
  }
  const auto other = mayHalve ? view.pointAgainstGraph(axes.line) : std::nullopt;
  if (other) return splitAt(box, *other, depth, halvings);
  sweep(view, axes);
}

/// Each may be divided into as many parts as the others, and into what those before it left.
void FluidRule::forEachPart(std::span<const Box<double>> parts,
                            FunctionRef<void(const Box<double>&)> add) {
  const int most = mostParts_;
  auto left = static_cast<int>(parts.size());
  for (const auto& part : parts) {
    mostParts_ = parts_ + (most - parts_) / left--;
    add(part);
  }
  mostParts_ = most;
}

/// Where the surfaces that the wall lies in are known.
void FluidRule::addBetweenSurfaces(const Box<double>& box,
                                   std::span<const FluidField* const> surfaces, int depth,
                                   int halvings) {
  const int dimension = flatAxis_ < 0 ? 3 : 2;
  ++parts_;
  const auto exposed = exposedIn(field_, box, surfaces);
  const auto divide = [&](int axis, double at) {
    forEachPart(halvesOf(box, axis, at), [&](const Box<double>& half) {
      std::vector<const FluidField*> near;
      std::ranges::copy_if(exposed, std::back_inserter(near),
                           [&](const FluidField* surface) { return surface->mayReach(half); });
      addBetweenSurfaces(half, near, depth + 1, halvings);
    });
  };
  const bool mayHalve = depth < kMostHalvings * dimension && parts_ < mostParts_;
  const SurfaceSweep sweep(field_, gauss_, box, exposed);
  if (sweep.isUncrossed()) {
    if (field_.value(box.center()) > 0) addWhole(box, flatAxis_);
  } else if (sweep.hasKink()) {
    addPart(BoxView(field_, box), depth, halvings);
  } else if (mayHalve && !sweep.isGood()) {
    const auto [axis, at] = sweep.division();
    divide(axis, at);
  } else if (mayHalve && depth < halvings * dimension) {
    const int longest = nearestAxis(box.size());
    divide(longest, box.center()[longest]);
  } else {
    sweep.run({rims_, crossings_, points_});
  }
}

/// Along the first axis in which a turning point lies inside: then it is on the rim of both parts.
bool FluidRule::splitAtTurn(const BoxView& view, int depth, int halvings) {
  const auto turn = view.turningPoint();
  if (!turn) return false;
  const auto& box = view.box();
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] < (*turn)[axis] && (*turn)[axis] < box.upper[axis]) {
      split(box, axis, (*turn)[axis], depth, halvings);
      return true;
    }
  }
  return false;
}

void FluidRule::addUncrossed(const BoxView& view, int depth, int halvings, bool mayHalve) {
  if (const auto hidden = view.hiddenPoint()) {
    if (mayHalve) return splitAt(view.box(), *hidden, depth, halvings);
    missed_ += measureOf(view);
  }
  if (view.isFluid(0)) addWhole(view.box(), view.flatAxis());
}

void FluidRule::split(const Box<double>& box, int axis, double at, int depth, int halvings) {
  forEachPart(halvesOf(box, axis, at), [&](const Box<double>& half) {
    addPart(BoxView(field_, half), depth + 1, halvings);
  });
}

/// The middle of what is on a point's side of the surface along each axis, in turns.
Vec3<double> FluidRule::centered(const Box<double>& box, Vec3<double> point) {
  constexpr int kTurns = 2;
  for (int turn = 0; turn < kTurns; ++turn) {
    for (int axis = 0; axis < 3; ++axis) {
      if (axis == flatAxis_) continue;
      // From the point to both sides.
      AxisLine below{point, point[axis], axis};
      below.start[axis] = box.lower[axis];
      const AxisLine above{point, box.upper[axis], axis};
      crossings_.find(std::array{below, above});
      const double from = crossings_.of(0).empty() ? box.lower[axis] : crossings_.of(0).back();
      const double to = crossings_.of(1).empty() ? box.upper[axis] : crossings_.of(1).front();
      if (from > box.lower[axis] || to < box.upper[axis]) point[axis] = 0.5 * (from + to);
    }
  }
  return point;
}

/// Into parts that have a point, or the middle of what is on its side, as a corner.
void FluidRule::splitAt(const Box<double>& box, const Vec3<double>& found, int depth,
                        int halvings) {
  const auto parts = partsAround(box, centered(box, found), flatAxis_);
  const int halved = flatAxis_ < 0 ? 3 : 2;
  forEachPart(std::span(parts.boxes).first(parts.count), [&](const Box<double>& part) {
    auto size = part.size();
    if (flatAxis_ >= 0) size[flatAxis_] = 1;
    const bool isEmpty = std::min({size.x, size.y, size.z}) <= 0;
    if (!isEmpty) addPart(BoxView(field_, part), depth + halved, halvings);
  });
}

void FluidRule::addWhole(const Box<double>& box, int flatAxis) {
  const SweepAxes axes{(flatAxis + 1) % 3, (flatAxis + 2) % 3, (flatAxis + 3) % 3};
  const auto block = points_.blockAt({.sweep = points_.sweeps++}, 1, 0);
  const auto addSlice = [&](double slice, double weight, std::uint32_t) {
    forStretches(
        gauss_, box.lower[axes.row], std::array{box.upper[axes.row]},
        [&](double row, double rowWeight, std::uint32_t) {
          points_.spans.push_back({lineAt(box, axes, slice, row), weight * rowWeight, block});
        });
  };
  if (flatAxis >= 0) return addSlice(box.lower[axes.slice], 1, 0);
  forStretches(gauss_, box.lower[axes.slice], std::array{box.upper[axes.slice]}, addSlice);
}

void FluidRule::sweep(const BoxView& view, const SweepAxes& axes) {
  const auto& box = view.box();
  // Slices at Gauss points between the places where rims leave through the ends of rows.
  std::vector<SweptSlice> slices;
  if (flatAxis_ >= 0) {
    slices.push_back({box.lower[axes.slice], 1, 0});
  } else {
    auto ends = view.crossingsAlong(axes.slice);
    ends.push_back(box.upper[axes.slice]);
    forStretches(gauss_, box.lower[axes.slice], ends,
                 [&](double at, double weight, std::uint32_t stretch) {
                   slices.push_back({at, weight, stretch});
                 });
  }
  rows_.clear();
  for (const auto& slice : slices) {
    for (const double end : {box.lower[axes.line], box.upper[axes.line]}) {
      rows_.push_back(rimAt(box, axes, slice.at, end));
      rows_.back().mayTurn = !view.isMonotone(axes.row);
    }
  }
  rims_.find(rows_);
  SweptLines lines{.sweep = points_.sweeps++};
  const bool mayTurn = !view.isMonotone(axes.line);
  std::vector<double> ends;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    ends.clear();
    for (const auto row : {2 * i, 2 * i + 1}) {
      const auto found = rims_.of(row);
      ends.insert(ends.end(), found.begin(), found.end());
    }
    lines.addRow(gauss_, box, axes, slices[i], ends, mayTurn);
  }
  crossings_.find(lines.lines);
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    addLinePoints(
        field_, {crossings_, i, {lines.lines[i], lines.weights[i]}},
        {.flatAxis = flatAxis_, .withFluid = true, .place = lines.places[i]},
        [](const FluidField*, const Vec3<double>&) { return true; }, points_);
  }
}

}  // namespace cutwater
