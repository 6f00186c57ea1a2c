#include <Cutwater/CutCells/Detail/Curved/FluidRule.hpp>
#include <Cutwater/CutCells/Detail/Curved/KinkSweep.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

namespace {

/// The area of the largest side of a box; the length of that of a rectangle.
double largestSide(const BoxView& view) {
  const auto size = view.box().size();
  if (view.flatAxis() >= 0) return maxComponent(size);
  return std::max({size.x * size.y, size.y * size.z, size.z * size.x});
}

/// What edges of a rectangle have of fluid, times their normals out of it.
Vec3<double> openEdges(const BoxView& view) {
  Vec3<double> sum;
  for (int axis = 0; axis < 3; ++axis) {
    if (!view.isFree(axis)) continue;
    const int across = 3 - axis - view.flatAxis();
    sum[across] = view.fluidLength(axis, 1) - view.fluidLength(axis, 0);
  }
  return sum;
}

}  // namespace

void FluidRule::findIn(const BoxView& rectangle, double tolerance) {
  findIn(rectangle, openEdges(rectangle), tolerance);
}

void FluidRule::findIn(const BoxView& view, const Vec3<double>& openSides, double tolerance) {
  constexpr int kMostHalvings = 2;
  constexpr int kMostLines = 6000;
  flatAxis_ = view.flatAxis();
  const double side = largestSide(view);
  points_.clear();
  parts_ = 0;
  linesLeft_ = kMostLines;
  addPart(view, 0, 0);
  gap_ = gapOf(openSides, side);
  for (int halvings = 1; halvings <= kMostHalvings && gap_ > tolerance; ++halvings) {
    std::swap(points_, best_);
    points_.clear();
    addPart(view, 0, halvings);
    const double gap = gapOf(openSides, side);
    if (gap < gap_) {
      gap_ = gap;
    } else {
      std::swap(points_, best_);
    }
  }
}

void FluidRule::takeAll(const Box<double>& box) {
  int flatAxis = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lower[axis] == box.upper[axis]) flatAxis = axis;
  }
  points_.clear();
  gap_ = 0;
  addWhole(box, flatAxis);
}

double FluidRule::gapOf(const Vec3<double>& openSides, double side) const {
  auto sum = openSides;
  for (const auto& wall : points_.walls) sum += wall.weight * wall.normal;
  return length(sum) / side;
}

void FluidRule::addPart(const BoxView& view, int depth, int halvings) {
  constexpr int kMostHalvings = 4;  // along each axis
  constexpr int kMostParts = 400;
  const auto& box = view.box();
  const int dimension = view.flatAxis() < 0 ? 3 : 2;
  ++parts_;
  const bool mayHalve = depth < kMostHalvings * dimension && parts_ < kMostParts;
  if (mayHalve) {
    if (const auto turn = view.turningPoint()) {
      // Along the first axis in which it lies inside: then it is on the rim of both parts.
      for (int axis = 0; axis < 3; ++axis) {
        if (box.lower[axis] < (*turn)[axis] && (*turn)[axis] < box.upper[axis]) {
          return split(box, axis, (*turn)[axis], depth, halvings);
        }
      }
    }
  }
  if (!view.isCrossed()) {
    if (view.isFluid(0)) addWhole(box, view.flatAxis());
    return;
  }
  bool isGood = false;
  const auto axes = view.bestAxes(isGood);
  const bool mustHalve = mayHalve && depth < halvings * dimension;
  if (!mustHalve && linesLeft_ > 0 && view.hasKink()) {
    return KinkSweep(field_, gauss_, view, linesLeft_, points_).run(axes, isGood);
  }
  if (mustHalve || (mayHalve && !isGood)) {
    const auto size = box.size();
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (size[axis] > size[longest]) longest = axis;
    }
    return split(box, longest, box.center()[longest], depth, halvings);
  }
  sweep(view, axes);
}

void FluidRule::split(const Box<double>& box, int axis, double at, int depth, int halvings) {
  auto low = box;
  auto high = box;
  low.upper[axis] = at;
  high.lower[axis] = at;
  addPart(BoxView(field_, low), depth + 1, halvings);
  addPart(BoxView(field_, high), depth + 1, halvings);
}

void FluidRule::addWhole(const Box<double>& box, int flatAxis) {
  const SweepAxes axes{(flatAxis + 1) % 3, (flatAxis + 2) % 3, (flatAxis + 3) % 3};
  const auto addSlice = [&](double slice, double weight) {
    forStretches(gauss_, box.lower[axes.row], std::array{box.upper[axes.row]},
                 [&](double row, double rowWeight) {
                   points_.spans.push_back({lineAt(box, axes, slice, row), weight * rowWeight});
                 });
  };
  if (flatAxis >= 0) return addSlice(box.lower[axes.slice], 1);
  forStretches(gauss_, box.lower[axes.slice], std::array{box.upper[axes.slice]}, addSlice);
}

void FluidRule::sweep(const BoxView& view, const SweepAxes& axes) {
  const auto& box = view.box();
  // Slices at Gauss points between the places where rims leave through the ends of rows.
  std::vector<GaussPoint> slices;
  const auto addSlice = [&](double at, double weight) { slices.push_back({at, weight}); };
  if (flatAxis_ >= 0) {
    addSlice(box.lower[axes.slice], 1);
  } else {
    auto ends = view.crossingsAlong(axes.slice);
    ends.push_back(box.upper[axes.slice]);
    forStretches(gauss_, box.lower[axes.slice], ends, addSlice);
  }
  rows_.clear();
  for (const auto& slice : slices) {
    for (const double end : {box.lower[axes.line], box.upper[axes.line]}) {
      rows_.push_back(rimAt(box, axes, slice.at, end));
      rows_.back().mayTurn = !view.isMonotone(axes.row);
    }
  }
  rims_.find(rows_);
  lines_.clear();
  weights_.clear();
  const bool mayTurn = !view.isMonotone(axes.line);
  std::vector<double> ends;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    ends.clear();
    for (const auto row : {2 * i, 2 * i + 1}) {
      const auto found = rims_.of(row);
      ends.insert(ends.end(), found.begin(), found.end());
    }
    std::ranges::sort(ends);
    ends.push_back(box.upper[axes.row]);
    forStretches(gauss_, box.lower[axes.row], ends, [&](double row, double weight) {
      lines_.push_back(lineAt(box, axes, slices[i].at, row));
      lines_.back().mayTurn = mayTurn;
      weights_.push_back(slices[i].weight * weight);
    });
  }
  crossings_.find(lines_);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    addLinePoints(field_, crossings_, i, {lines_[i], weights_[i]}, {.flatAxis = flatAxis_},
                  points_);
  }
}

}  // namespace cutwater
