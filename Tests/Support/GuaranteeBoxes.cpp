#include "Support/GuaranteeCheck.hpp"

namespace cutwater::test {

template <std::floating_point T>
void GuaranteeCheck<T>::checkBoxes() {
  Tally bounds("bounds of a box");
  Tally classes("class of a box");
  Tally cut("a cube on the surface of an exact distance is cut");
  const bool isExact = promise_.inside == Quality::Exact && promise_.outside == Quality::Exact;
  for (int i = 0; i < options_.probes / 10; ++i) {
    const bool onSurface = i % 2 == 0 && !samples_.points().empty();
    const auto& points = samples_.points();
    const auto center =
        onSurface ? Vec3<T>(points[static_cast<std::size_t>(i) * 7919 % points.size()]) : probe();
    const double size = extent_ * std::pow(10.0, uniform(-5, 0));
    Vec3<T> half(Vec3<double>{uniform(0, size), uniform(0, size), uniform(0, size)});
    if (i % 5 == 1) half[i % 3] = 0;  // a 2D code's cells have zero thickness
    if (i % 4 == 0) half = Vec3<T>(Vec3<double>{size, size, size});
    const Box<T> box{center - half, center + half};
    checkOneBox(box, bounds, classes);
    ++counts_.boxes;
    if (i % 4 == 0 && onSurface && isExact && static_cast<T>(size) > 50 * error(center)) {
      cut.expect(solid_.classify(box) == BoxClass::Cut, "at", center, "half", size);
    }
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkOneBox(const Box<T>& box, Tally& bounds, Tally& classes) {
  BoxHint hint;
  const auto range = solid_.bounds(box);
  const auto kind = solid_.classify(box);
  bounds.expect(solid_.bounds(box, &hint) == range && solid_.classify(box, &hint) == kind,
                "a hint changes the answer");
  const auto octant = Box<T>{box.center(), box.center()}.extend(box.corner(5));
  bounds.expect(solid_.classify(octant, &hint) == solid_.classify(octant) &&
                    solid_.bounds(octant, &hint) == solid_.bounds(octant),
                "a hint changes the answer for an octant of", box.lower, box.upper);
  checkDistanceBounds(box, bounds);
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < 32; ++i) {
    Vec3<T> p = box.corner(i % 8);
    for (int axis = 0; axis < 3 && i >= 8; ++axis) {
      const double t = uniform(0, 1);
      p[axis] = static_cast<T>((1 - t) * static_cast<double>(box.lower[axis]) +
                               t * static_cast<double>(box.upper[axis]));
      p[axis] = std::clamp(p[axis], box.lower[axis], box.upper[axis]);
    }
    const T value = solid_.signedDistance(p);
    bounds.expect(range.contains(value), "value", value, "at", p, "not in", range.lower,
                  range.upper, "of the box", box.lower, box.upper);
    const bool agrees = kind == BoxClass::Inside    ? value < 0
                        : kind == BoxClass::Outside ? value >= 0
                                                    : true;
    classes.expect(agrees, "class", static_cast<int>(kind), "value", value, "at", p);
    ++(value < 0 ? inside : outside);
  }
  if (kind == BoxClass::Cut && promise_.lipschitz && (inside == 0 || outside == 0)) {
    classes.expect(!isCertainlyFree(box, 4), "no surface in the cut box", box.lower, box.upper);
  }
  if (kind == BoxClass::Inside || kind == BoxClass::Outside) {
    const double margin = static_cast<double>(promise_.error(length(box.upper)));
    const Box<double> certain{Vec3<double>(box.lower), Vec3<double>(box.upper)};
    classes.expect(!samples_.anyIn(certain.grown(-margin)), "surface in the box", box.lower,
                   box.upper, "of class", static_cast<int>(kind));
  } else if (kind == BoxClass::Cut) {
    classes.expect(range.contains(0), "cut, but bounds exclude 0", range.lower, range.upper);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkDistanceBounds(const Box<T>& box, Tally& bounds) const {
  const auto distances = solid_.distanceBounds(box);
  const auto range = solid_.bounds(box);
  bounds.expect(distances.lower >= 0 && distances.lower <= distances.upper, "distances from",
                distances.lower, "to", distances.upper);
  if (samples_.points().empty()) return;
  for (int i = 0; i < 9; i += 4) {
    const auto p = i == 8 ? box.center() : box.corner(i);
    const double nearest = samples_.nearest(Vec3<double>(p)).distance;
    const double cover = options_.covering * samples_.spacing();
    const double rounding{error(p)};
    // Farther away there may be surface that was not sampled.
    const double reach = double{maxComponent(abs(p))} + double{distances.upper} + cover;
    bounds.expect(double{distances.lower} <= nearest + rounding &&
                      (reach > extent_ || double{distances.upper} >= nearest - cover - rounding ||
                       hasSurfaceAt(p, double{distances.upper} + rounding)),
                  "distance", nearest, "at", p, "not in", distances.lower, distances.upper);
  }
  if (promise_.outside == Quality::Exact && range.lower > 0 &&
      promise_.domain == Box<T>::everywhere()) {
    bounds.expect(distances == range, "distances outside are not the values");
  }
}

template <std::floating_point T>
bool GuaranteeCheck<T>::isCertainlyFree(const Box<T>& box, int depth) const {
  const auto center = box.center();
  const T radius = length(max(box.upper - center, center - box.lower));
  const T value = std::abs(solid_.signedDistance(center));
  if (value > *promise_.lipschitz * radius + 2 * error(center)) return true;
  for (int i = 0; i < 8 && depth > 0; ++i) {
    const auto corner = box.corner(i);
    const Box<T> octant{min(center, corner), max(center, corner)};
    if (!isCertainlyFree(octant, depth - 1)) return false;
  }
  return depth > 0;
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkBoundingBox() {
  Tally tally("bounding box");
  auto moved = solid_;
  moved.rotate(31, Vec3<T>{1, 2, -1});
  moved.translate(Vec3<T>{static_cast<T>(extent_), 0, 1});
  for (const auto& solid : {solid_, moved}) {
    const auto box = solid.boundingBox();
    for (int i = 0; i < options_.probes / 10; ++i) {
      const auto p = solid.placement().toWorld(solid_.placement().toLocal(probe()));
      if (solid.signedDistance(p) < 0)
        tally.expect(box.contains(p), "leaves out", p, box.lower, box.upper);
    }
    for (const auto& sample : samples_.points()) {
      const auto p = solid.placement().toWorld(solid_.placement().toLocal(Vec3<T>(sample)));
      tally.expect(box.grown(error(p)).contains(p), "leaves out", p, box.lower, box.upper);
    }
    checkClearance(solid);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkClearance(const Solid<T>& solid) {
  Tally tally("no less than the distance to the clearance box");
  const Box<T> box = solid.clearanceBox();
  if (promise_.outside == Quality::Exact && promise_.domain == Box<T>::everywhere()) {
    tally.expect(box == solid.boundingBox(), "that of exact distances is the bounding box");
  }
  if (box == Box<T>::everywhere()) return;
  const auto promise = solid.guarantee();
  for (int i = 0; i < options_.probes / 2; ++i) {
    const auto p = randomPoint(i % 2 == 0 ? 2 * extent_ : 20 * extent_);
    const Vec3<double> gaps(max(max(box.lower - p, p - box.upper), Vec3<T>{}));
    if (gaps == Vec3<double>{}) continue;
    const T value = solid.signedDistance(p);
    tally.expect(double{value} >= length(gaps) - double{promise.error(length(p))}, "at", p, "value",
                 value, "but the box", box.lower, box.upper, "is away", length(gaps));
  }
}

template void GuaranteeCheck<float>::checkBoxes();
template void GuaranteeCheck<double>::checkBoxes();
template void GuaranteeCheck<float>::checkBoundingBox();
template void GuaranteeCheck<double>::checkBoundingBox();
template void GuaranteeCheck<float>::checkClearance(const Solid<float>&);
template void GuaranteeCheck<double>::checkClearance(const Solid<double>&);

}  // namespace cutwater::test
