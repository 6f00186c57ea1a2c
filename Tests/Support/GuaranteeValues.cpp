#include <Cutwater/Operations/Algebra.hpp>

#include <numbers>
#include <vector>

#include "Support/GuaranteeCheck.hpp"
#include "Support/SameClosestPoints.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {

namespace {

/// v turned about the unit axis u: Rodrigues' formula, independent of the library's matrices.
Vec3<double> turned(const Vec3<double>& v, const Vec3<double>& u, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::cos(angle) * v + std::sin(angle) * cross(u, v) +
         (1 - std::cos(angle)) * dot(u, v) * u;
}

}  // namespace

template <std::floating_point T>
GuaranteeCheck<T>::GuaranteeCheck(const Solid<T>& solid, double extent,
                                  const GuaranteeOptions& options)
    : solid_(solid),
      extent_(extent),
      options_(options),
      promise_(solid.guarantee()),
      engine_(options.seed),
      samples_(solid_, extent, options.lines, options.seed) {
  options_.probes = scaled(options_.probes);
}

template <std::floating_point T>
Vec3<T> GuaranteeCheck<T>::probe() {
  const auto& points = samples_.points();
  if (points.empty() || uniform(0, 1) < 0.5) return randomPoint(extent_);
  const auto i = static_cast<std::size_t>(uniform(0, static_cast<double>(points.size())));
  const double away = extent_ * std::pow(10.0, uniform(-9, -0.5));
  return Vec3<T>(points[std::min(i, points.size() - 1)] + away * Vec3<double>(randomDirection()));
}

template <std::floating_point T>
void GuaranteeCheck<T>::run() {
  if (options_.hasSurface) {
    ASSERT_GT(samples_.points().size(), 50U) << "the surface is hardly within the extent";
  }
  checkSign();
  checkLipschitz();
  if (!samples_.points().empty()) checkDistances();
  checkWithin();
  checkBatches();
  checkNonFinite();
  checkMotions();
  checkBoxes();
  checkBoundingBox();
  checkGradient();
  checkClosestPoints();
  checkCrossings();
  checkSurfaces();
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkSign() {
  Tally tally("sign");
  if (!options_.inside) return;
  for (int i = 0; i < options_.probes; ++i) {
    const auto p = probe();
    const T value = solid_.signedDistance(p);
    if (std::abs(value) <= error(p)) continue;
    tally.expect((value < 0) == options_.inside(Vec3<double>(p)), "at", p, "value", value);
  }
  EXPECT_GT(tally.all(), options_.probes / 4);
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkLipschitz() {
  if (!promise_.lipschitz) return;
  Tally tally("Lipschitz constant");
  for (int i = 0; i < options_.probes; ++i) {
    const auto p = probe();
    const T step = static_cast<T>(extent_ * std::pow(10.0, uniform(-6, 0)));
    const auto q = p + step * randomDirection();
    const T change = std::abs(solid_.signedDistance(p) - solid_.signedDistance(q));
    tally.expect(change <= *promise_.lipschitz * length(p - q) + error(p) + error(q), "between", p,
                 "and", q, "change", change, "distance", length(p - q));
  }
  counts_.pairs += tally.all();
}

template <std::floating_point T>
bool GuaranteeCheck<T>::hasSurfaceAt(const Vec3<T>& p, double distance) const {
  const auto found = solid_.closestPoint(p);
  const T across = 4 * (error(p) + error(found.point));
  const auto isInside = [&](T side) {
    return solid_.signedDistance(found.point + side * across * found.normal) < 0;
  };
  return static_cast<double>(length(found.point - p) - 2 * across) <= distance &&
         isInside(1) != isInside(-1);
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkDistances() {
  Tally under("no surface nearer than |value|");
  Tally over("a surface as near as |value| says");
  Tally polished("the nearest surface point at |value|");
  const double cover = options_.covering * samples_.spacing();
  for (int i = 0; i < options_.probes; ++i) {
    const auto p = probe();
    const Vec3<double> exactly(p);
    const double value = static_cast<double>(solid_.signedDistance(p));
    const auto quality = promise_.quality(static_cast<T>(value));
    if (quality == Quality::SignOnly) continue;
    const double rounding = 2 * static_cast<double>(error(p));
    const double nearest = samples_.nearest(exactly).distance;
    under.expect(std::abs(value) <= nearest + rounding, "at", p, "value", value, "but", nearest);
    const double reach = static_cast<double>(maxComponent(abs(p))) + std::abs(value) + cover;
    if (quality != Quality::Exact || reach > extent_) continue;
    // Lines miss thin parts, and a search by sign alone may end in the wrong valley: a change of
    // sign where the solid itself finds its surface is proof, too.
    over.expect(nearest <= std::abs(value) + cover || hasSurfaceAt(p, std::abs(value)), "at", p,
                "value", value, "but", nearest);
    if (!options_.polish || i % 50 != 0) continue;
    const double enough = std::abs(value) + 2e-3 * samples_.spacing() + rounding;
    const double distance = samples_.polishedDistance(exactly, enough);
    polished.expect(std::abs(value) - rounding <= distance &&
                        (distance <= enough || hasSurfaceAt(p, std::abs(value))),
                    "at", p, "value", value, "but", distance);
  }
  counts_.distances += under.all();
  if (promise_.inside == Quality::Exact && promise_.outside == Quality::Exact) {
    EXPECT_GT(over.all(), options_.probes / 20) << "choose a larger extent";
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkWithin() {
  Tally tally("value within an interval");
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const auto moved = translated(Solid<T>(scaled(named(solid_, "x"), T(-1.5))), {0, 1, 0});
  for (int i = 0; i < options_.probes / 2; ++i) {
    const auto& solid = i % 4 == 3 ? moved : solid_;
    const auto p = probe();
    const T value = solid.signedDistance(p);
    // From far beside the value to an end at it.
    const T reach = static_cast<T>(extent_ * std::pow(10.0, uniform(-9, 0.5)));
    const T end = i % 3 == 0 ? value : value + static_cast<T>(uniform(-1, 1)) * reach;
    const T lower = i % 2 == 0 ? -kInf : end;
    const T upper = i % 2 == 0 ? end : end + std::abs(reach);
    const T answer = solid.signedDistanceWithin(p, {lower, upper});
    const bool isRight = value < lower   ? answer < lower
                         : value > upper ? answer > upper
                                         : isSame(answer, value);
    tally.expect(isRight, "at", p, "value", value, "in", lower, upper, "is", answer);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkBatches() {
  Tally tally("batch as one by one");
  for (const std::size_t count : {std::size_t{1}, std::size_t{255}, std::size_t{1000}}) {
    std::vector<Vec3<T>> points(count);
    for (auto& p : points) p = probe();
    std::vector<T> values(count);
    solid_.signedDistances(points, values, {.threads = 2});
    for (std::size_t i = 0; i < count; ++i) {
      const T alone = solid_.signedDistance(points[i]);
      tally.expect(isSame(values[i], alone), "at", points[i], alone, "in batch", values[i]);
      tally.expect(!std::signbit(alone) || alone < 0, "-0 at", points[i]);
    }
    expectSameClosestPoints(solid_, points);
  }
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkNonFinite() {
  const T inf = std::numeric_limits<T>::infinity();
  const T nan = std::numeric_limits<T>::quiet_NaN();
  for (const T bad : {inf, -inf, nan}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3<T> p{1, 1, 1};
      p[axis] = bad;
      EXPECT_TRUE(std::isnan(solid_.signedDistance(p)));
      EXPECT_TRUE(std::isnan(solid_.gradient(p).x));
      EXPECT_TRUE(std::isnan(solid_.closestPoint(p).point.y));
      EXPECT_EQ(solid_.closestPoint(p).owner.face, kNone);
      T inBatch = 0;
      solid_.signedDistances(std::span<const Vec3<T>>(&p, 1), std::span<T>(&inBatch, 1));
      EXPECT_TRUE(std::isnan(inBatch));
      const auto walk = solid_.crossings({{0, 0, 0}, p}, [](const auto&) { return true; });
      EXPECT_EQ(walk.found, 0U);
      const Box<T> box{{0, 0, 0}, p};
      EXPECT_EQ(solid_.classify(box), BoxClass::Unknown);
      EXPECT_EQ(solid_.bounds(box), Interval<T>::everything());
    }
  }
  EXPECT_EQ(solid_.classify(Box<T>{}), BoxClass::Unknown);
  EXPECT_EQ(solid_.bounds(Box<T>{}), Interval<T>::everything());
}

template <std::floating_point T>
void GuaranteeCheck<T>::checkMotions() {
  if (!promise_.lipschitz) return;
  const Vec3<double> axis = normalized(Vec3<double>{1, -2, 3});
  const Vec3<double> through{0.25, 0.5, -1};
  const Vec3<double> offset{0.5 * extent_, -0.125 * extent_, extent_};
  auto moved = solid_;
  moved.translate(Vec3<T>(offset));
  moved.rotate(100, Vec3<T>{1, -2, 3}, Vec3<T>(through));
  Tally tally("value of a moved solid");
  for (int i = 0; i < options_.probes / 10; ++i) {
    const auto q = probe();
    const Vec3<double> there = turned(Vec3<double>(q) + offset - through, axis, 100) + through;
    const Vec3<T> p(there);
    // Rounding of both values, of the point p and of the placement's matrix.
    const T allowed = moved.guarantee().error(length(p)) + error(q) +
                      4 * *promise_.lipschitz * std::numeric_limits<T>::epsilon() * length(p);
    const T difference = std::abs(moved.signedDistance(p) - solid_.signedDistance(q));
    tally.expect(difference <= allowed, "at", q, "differs by", difference, "allowed", allowed);
  }
}

template <std::floating_point T>
GuaranteeCounts checkGuarantee(const Solid<T>& solid, double extent,
                               const GuaranteeOptions& options) {
  GuaranteeCheck<T> check(solid, extent, options);
  check.run();
  return check.counts();
}

void expectRounding(const Solid<float>& single, const Solid<double>& twice, double extent) {
  Tally tally("rounding of float");
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto promise = single.guarantee();
  for (int i = 0; i < scaled(20000); ++i) {
    const double size = extent * std::pow(10.0, 4.5 + 4.5 * coordinate(engine)) * 1e-3;
    Vec3<double> direction;
    for (int axis = 0; axis < 3; ++axis) direction[axis] = coordinate(engine);
    if (i % 4 == 1) direction[i / 4 % 3] = 0;  // planes of symmetry
    if (i % 4 == 2) direction = {i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? 1.0 : 0.0, 0.125};
    const Vec3<float> p(size * direction);
    const double value = single.signedDistance(p);
    const double exact = twice.signedDistance(Vec3<double>(p));
    const double allowed = promise.error(length(p));
    tally.expect(std::abs(value - exact) <= allowed, "at", p, value, "is", exact, "off by ulps",
                 promise.ulps * std::abs(value - exact) / allowed);
  }
}

template class GuaranteeCheck<float>;
template class GuaranteeCheck<double>;
template GuaranteeCounts checkGuarantee(const Solid<float>&, double, const GuaranteeOptions&);
template GuaranteeCounts checkGuarantee(const Solid<double>&, double, const GuaranteeOptions&);

}  // namespace cutwater::test
