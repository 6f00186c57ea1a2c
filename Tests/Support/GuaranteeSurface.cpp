#include <algorithm>
#include <map>
#include <vector>

#include "Support/GuaranteeCheck.hpp"

namespace cutwater::test {

template <std::floating_point T>
void GuaranteeCheck<T>::checkGradient() {
  if (!promise_.lipschitz) return;
  Tally tally("gradient against centred differences");
  const T delta = static_cast<T>(0.3 * std::cbrt(std::numeric_limits<T>::epsilon()) * extent_);
  // Rounding of the differences, and curvature: within delta of a kink they are not compared.
  const T tolerance = static_cast<T>(2e-3) + 2 * error(randomPoint(extent_)) / delta;
  const int probes = options_.probes / 10;
  for (int i = 0; i < probes; ++i) {
    const auto p = randomPoint(extent_);
    const T value = solid_.signedDistance(p);
    Vec3<T> slope;
    bool isSmooth = true;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3<T> step;
      step[axis] = delta;
      const T after = (solid_.signedDistance(p + step) - value) / delta;
      const T before = (value - solid_.signedDistance(p - step)) / delta;
      slope[axis] = T(0.5) * (after + before);
      isSmooth = isSmooth && std::abs(after - before) < 4 * tolerance;
    }
    if (!isSmooth) continue;
    const auto g = solid_.gradient(p);
    tally.expect(length(g - slope) <= 4 * tolerance, "at", p, g, "differences", slope);
    if (promise_.quality(value) == Quality::Exact) {
      tally.expect(std::abs(length(g) - 1) <= 4 * tolerance, "length of", g, "at", p);
    }
  }
  EXPECT_GT(tally.all(), probes / 2) << "too few smooth points to say anything";
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkClosestPoints() {
  Tally tally("closest point");
  const auto patches = solid_.patchNames().size();
  for (int i = 0; i < options_.probes / 5; ++i) {
    // Every fifth a point of symmetry: coordinates in multiples of an eighth of the extent.
    auto p = probe();
    if (i % 5 == 0) {
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = static_cast<T>(extent_ * std::round(uniform(-8, 8)) / 8);
      }
    }
    const T value = solid_.signedDistance(p);
    const auto c = solid_.closestPoint(p);
    const T rounding = error(p) + error(c.point);
    tally.expect(c.distance == value, "distance", c.distance, "but value", value, "at", p);
    const auto quality = promise_.quality(value);
    const T gap = std::abs(length(c.point - p) - std::abs(value));
    if (quality == Quality::Exact) {
      tally.expect(c.exact, "not exact at", p, "value", value, "point", c.point, "gap", gap, "of",
                   rounding, "residual", solid_.signedDistance(c.point));
    }
    if (c.exact) {
      tally.expect(gap <= 4 * rounding, "at", p, "gap", gap, "rounding", rounding);
      tally.expect(std::abs(solid_.signedDistance(c.point)) <= 2 * rounding, "at", p,
                   "not on it:", c.point, solid_.signedDistance(c.point));
    }
    if (options_.hasSurface && quality != Quality::SignOnly) {
      const double nearest = samples_.nearest(Vec3<double>(p)).distance;
      tally.expect(static_cast<double>(length(c.point - p) - c.tolerance - 2 * rounding) <= nearest,
                   "at", p, "point", c.point, "tolerance", c.tolerance, "but", nearest);
    }
    tally.expect(std::abs(length(c.normal) - 1) < T(1e-3), "normal", c.normal, "at", p);
    tally.expect(c.owner.patch < patches, "patch", c.owner.patch);
  }
}

/// Each sample of the surface lies in one of those that are visited in boxes around it, and in the
/// surface of the operand that it comes with.
template <std::floating_point T>
void GuaranteeCheck<T>::checkSurfaces() {
  if (!promise_.continuous) return;  // values are not zero on the surface
  Tally tally("surfaces in boxes");
  const auto& points = samples_.points();
  const auto step = 1 + points.size() / static_cast<std::size_t>(options_.probes / 100 + 1);
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vec3<T> p(points[i]);
    const auto size = static_cast<T>(extent_ * std::exp2(uniform(-8, 0)));
    const Vec3<T> lower =
        p - size * Vec3<T>(Vec3<double>{uniform(0, 1), uniform(0, 1), uniform(0, 1)});
    const Box<T> box{min(lower, p), max(lower + Vec3<T>{size, size, size}, p)};
    T least = std::numeric_limits<T>::infinity();
    std::vector<Solid<T>> surfaces;
    solid_.surfacesIn(box, [&](const Solid<T>& surface, const Solid<T>* operand) {
      surfaces.push_back(surface);
      const auto excess = [&](const Solid<T>& solid) {
        return std::abs(solid.signedDistance(p)) -
               8 * (error(p) + solid.guarantee().error(length(p)));
      };
      least = std::min(least, std::max(excess(surface), excess(*operand)));
    });
    tally.expect(least <= 0, "at", p, "size", size, "off by", least);
    checkSidesOf(surfaces, box, tally);
  }
}

/// That points on the same sides of all surfaces are all in the solid, or all outside.
template <std::floating_point T>
void GuaranteeCheck<T>::checkSidesOf(std::span<const Solid<T>> surfaces, const Box<T>& box,
                                     Tally& tally) {
  constexpr int kPoints = 20;
  std::map<std::vector<bool>, bool> isInside;
  for (int n = 0; n < kPoints; ++n) {
    Vec3<T> p = box.lower;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] += static_cast<T>(uniform(0, 1)) * (box.upper[axis] - box.lower[axis]);
    }
    std::vector<bool> sides;
    const auto sideOf = [&](const Solid<T>& solid) {
      const T value = solid.signedDistance(p);
      if (std::abs(value) <= 8 * (error(p) + solid.guarantee().error(length(p)))) return false;
      sides.push_back(value < 0);
      return true;
    };
    if (!std::ranges::all_of(surfaces, sideOf) || !sideOf(solid_)) continue;
    const bool inside = sides.back();
    sides.pop_back();
    const auto [known, isNew] = isInside.try_emplace(sides, inside);
    tally.expect(isNew || known->second == inside, "sides at", p, "in", box.lower, box.upper);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkCrossings() {
  Tally tally("crossings");
  for (int i = 0; i < options_.probes / 50; ++i) {
    Segment<T> segment{probe(), probe()};
    if (i % 10 == 0) segment.end = segment.start;  // a point
    if (i % 10 == 1) segment = {randomPoint(extent_), -segment.start};
    checkOneSegment(segment, tally);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkOneSegment(const Segment<T>& segment, Tally& tally) {
  std::vector<Crossing<T>> found;
  const auto walk = solid_.crossings(segment, [&](const Crossing<T>& c) {
    found.push_back(c);
    return true;
  });
  const auto isInside = [&](const Vec3<T>& p) { return solid_.signedDistance(p) < 0; };
  bool inside = isInside(segment.start);
  tally.expect(walk.found == found.size(), "number told");
  tally.expect((found.size() % 2 == 1) == (inside != isInside(segment.end)), "parity from",
               segment.start, "to", segment.end, "found", found.size());
  T before = 0;
  const T size = length(segment.start) + length(segment.end);
  for (const auto& c : found) {
    tally.expect(c.entering == !inside, "entering at", c.point);
    tally.expect(before <= c.parameter && c.parameter <= 1, "order at", c.parameter);
    tally.expect(std::abs(solid_.signedDistance(c.point)) <= 4 * promise_.error(size) ||
                     !promise_.continuous,
                 "not on the surface:", c.point, solid_.signedDistance(c.point));
    inside = !inside;
    before = c.parameter;
  }

  // Brute force: between neighbouring samples of different sign there is an odd number.
  constexpr int kSteps = 500;
  std::size_t next = 0;
  for (int step = 1; step <= kSteps; ++step) {
    const T from = static_cast<T>(step - 1) / kSteps;
    const T to = static_cast<T>(step) / kSteps;
    const T valueFrom = solid_.signedDistance(segment.at(from));
    const T valueTo = solid_.signedDistance(segment.at(to));
    std::size_t here = 0;
    for (; next < found.size() && found[next].parameter <= to; ++next) ++here;
    const bool isSure = std::min(std::abs(valueFrom), std::abs(valueTo)) > 4 * promise_.error(size);
    if (!isSure) return;  // a crossing this near to a sample may count on either side
    tally.expect((here % 2 == 1) == ((valueFrom < 0) != (valueTo < 0)), "parity between", from,
                 "and", to, "from", segment.start, "to", segment.end);
  }
}

template void GuaranteeCheck<float>::checkGradient();
template void GuaranteeCheck<double>::checkGradient();
template void GuaranteeCheck<float>::checkClosestPoints();
template void GuaranteeCheck<double>::checkClosestPoints();
template void GuaranteeCheck<float>::checkCrossings();
template void GuaranteeCheck<double>::checkCrossings();
template void GuaranteeCheck<float>::checkSurfaces();
template void GuaranteeCheck<double>::checkSurfaces();

}  // namespace cutwater::test
