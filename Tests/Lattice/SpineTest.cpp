#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Spine.hpp>

#include <array>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

using Points = std::vector<Vec3<double>>;

/// Radius 2, rising by 2 pi c a turn.
struct Helix {
  double radius = 2;
  double c = 0.5;

  [[nodiscard]] Vec3<double> point(double angle) const {
    return {radius * std::cos(angle), radius * std::sin(angle), c * angle};
  }
  [[nodiscard]] double speed() const { return std::sqrt(radius * radius + c * c); }
  [[nodiscard]] double torsion() const { return c / (radius * radius + c * c); }
  /// Frenet's, towards the axis.
  [[nodiscard]] Vec3<double> normal(double angle) const {
    return {-std::cos(angle), -std::sin(angle), 0};
  }
  [[nodiscard]] Spine spine(int points, double turns) const {
    Points through;
    for (int i = 0; i <= points; ++i) {
      through.push_back(point(2 * std::numbers::pi * turns * i / points));
    }
    return Spine(through);
  }
};

void expectOrthonormal(const SpineFrame& frame) {
  EXPECT_NEAR(length(frame.tangent), 1, 1e-14);
  EXPECT_NEAR(length(frame.normal), 1, 1e-14);
  EXPECT_NEAR(dot(frame.tangent, frame.normal), 0, 1e-14);
  EXPECT_LT(length(frame.binormal - cross(frame.tangent, frame.normal)), 1e-14);
}

TEST(SpineTest, TwoPointsAreAStraightLine) {
  const Spine spine(Points{{1, 2, 3}, {1, 2, 8}});
  EXPECT_DOUBLE_EQ(spine.length(), 5);
  for (const double arc : {-1.0, 0.0, 0.1, 2.5, 5.0, 7.0}) {
    const auto frame = spine.frameAt(arc);
    EXPECT_LT(length(frame.point - Vec3<double>{1, 2, 3 + arc}), 1e-14) << arc;
    EXPECT_EQ(frame.tangent, (Vec3<double>{0, 0, 1}));
    EXPECT_EQ(frame.normal, (Vec3<double>{1, 0, 0}));
    EXPECT_EQ(frame.binormal, (Vec3<double>{0, 1, 0}));
  }
  const auto chosen = Spine(Points{{1, 2, 3}, {1, 2, 8}}, {0, 3, 4}).frameAt(2);
  EXPECT_EQ(chosen.normal, (Vec3<double>{0, 1, 0}));
}

TEST(SpineTest, PassesThroughItsPointsAndKnowsItsLength) {
  const Points points{{0, 0, 0}, {3, 0, 1}, {4, 2, 1}, {4, 3, 5}, {0, 3, 5}};
  const Spine spine(points);
  for (const auto& point : points) {
    double nearest = 1e300;
    for (int i = 0; i <= 20000; ++i) {
      const auto at = spine.frameAt(spine.length() * i / 20000).point;
      nearest = std::min(nearest, length(at - point));
    }
    EXPECT_LT(nearest, 1e-3);
  }
  EXPECT_LT(length(spine.frameAt(0).point - points.front()), 1e-14);
  EXPECT_LT(length(spine.frameAt(spine.length()).point - points.back()), 1e-9);
  // By arc length: between neighbours, chords are as long as arcs.
  auto before = spine.frameAt(0);
  double sum = 0;
  constexpr int kSteps = 5000;
  for (int i = 1; i <= kSteps; ++i) {
    const auto frame = spine.frameAt(spine.length() * i / kSteps);
    expectOrthonormal(frame);
    const double chord = length(frame.point - before.point);
    EXPECT_NEAR(chord, spine.length() / kSteps, 1e-4 * spine.length() / kSteps);
    EXPECT_LT(length(frame.normal - before.normal), 0.05);
    EXPECT_LT(length((frame.point - before.point) / chord - frame.tangent), 0.05);
    sum += chord;
    before = frame;
  }
  EXPECT_NEAR(sum, spine.length(), 1e-6 * spine.length());
}

TEST(SpineTest, IsSmooth) {
  const Spine spine(Points{{0, 0, 0}, {3, 0, 1}, {4, 2, 1}, {4, 3, 5}, {0, 3, 5}});
  // The tangent's change does not jump: what is twice differentiable has none, at points either.
  constexpr int kSteps = 4000;
  const double step = spine.length() / kSteps;
  Vec3<double> before;
  for (int i = 1; i < kSteps; ++i) {
    const auto bend =
        (spine.frameAt((i + 1) * step).tangent - spine.frameAt((i - 1) * step).tangent) /
        (2 * step);
    EXPECT_LT(length(bend - before), 0.05) << i;
    before = bend;
  }
}

TEST(SpineTest, FrameTurnsAgainstFrenetsByTheTorsion) {
  const Helix helix;
  const auto spine = helix.spine(64, 2);
  // Far from its ends, which are straight, the spline is the helix.
  const double begin = helix.speed() * std::numbers::pi;
  const auto angleAt = [&](double arc) {
    const auto frame = spine.frameAt(arc);
    const double angle = std::atan2(frame.point.y, frame.point.x);
    const auto frenet = helix.normal(angle);
    return std::atan2(dot(cross(frenet, frame.normal), frame.tangent), dot(frenet, frame.normal));
  };
  const double atBegin = angleAt(begin);
  for (int i = 1; i <= 20; ++i) {
    const double way = helix.speed() * std::numbers::pi * i / 10;
    const double turned = std::remainder(angleAt(begin + way) - atBegin + helix.torsion() * way,
                                         2 * std::numbers::pi);
    EXPECT_NEAR(turned, 0, 1e-4) << i;
  }
  EXPECT_NEAR(spine.length(), 4 * std::numbers::pi * helix.speed(), 1e-3);
}

/// A vector carried from one direction to the next by the least turn that takes it there.
Vec3<double> carried(const Vec3<double>& v, const Vec3<double>& from, const Vec3<double>& to) {
  const auto axis = cross(from, to);
  return v + cross(axis, v) + cross(axis, cross(axis, v)) / (1 + dot(from, to));
}

TEST(SpineTest, FrameIsParallelTransport) {
  const Spine spine(Points{{0, 0, 0}, {3, 0, 1}, {4, 2, 1}, {4, 3, 5}, {0, 3, 5}});
  constexpr int kSteps = 40000;
  auto before = spine.frameAt(0);
  auto normal = before.normal;
  for (int i = 1; i <= kSteps; ++i) {
    const auto frame = spine.frameAt(spine.length() * i / kSteps);
    normal = carried(normal, before.tangent, frame.tangent);
    before = frame;
    if (i % 1000 == 0) {
      EXPECT_LT(length(normal - frame.normal), 2e-6) << i;
    }
  }
}

TEST(SpineTest, FramesOfPlaneCurvesStayUpright) {
  Points points;
  for (int i = 0; i <= 8; ++i) {
    const double angle = std::numbers::pi / 2 * i / 8;
    points.push_back({std::sin(angle), 0, 1 - std::cos(angle)});
  }
  const Spine spine(points, {0, 1, 0});
  for (int i = 0; i <= 40; ++i) {
    EXPECT_LT(length(spine.frameAt(spine.length() * i / 40).normal - Vec3<double>{0, 1, 0}), 1e-14);
  }
}

std::string spineRefusal(const Points& points, const Vec3<double>& side = {}) {
  return refusal([&] { return Spine(points, side); });
}

TEST(SpineTest, RefusesWhatIsNoCurve) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spineRefusal({}), "Spine: need two points (points = 0)");
  EXPECT_EQ(spineRefusal({{1, 2, 3}}), "Spine: need two points (points = 1)");
  EXPECT_TRUE(
      spineRefusal({{1, 2, 3}, {nan, 2, 3}}).starts_with("Spine: need points that are finite"));
  EXPECT_TRUE(spineRefusal({{0, 0, 0}, {1, 2, 3}, {1, 2, 3}})
                  .starts_with("Spine: need points that differ from the next (index = 1"));
  EXPECT_TRUE(spineRefusal({{0, 0, 0}, {0, 0, 1}}, {0, 0, 2})
                  .starts_with("Spine: need a side that is not along the curve"));
  EXPECT_TRUE(spineRefusal({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}})
                  .starts_with("Spine: need a curve that does not turn on the spot"));
}

}  // namespace
}  // namespace cutwater::test
