#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/Detail/CappedBeam.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>

#include <algorithm>
#include <variant>

#include "Support/Grid.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BeamLatticeTest : public ::testing::Test {};
TYPED_TEST_SUITE(BeamLatticeTest, Precisions);

/// Beams between nodes near each other, of all kinds and radii; some swallow their other end.
BeamGraph randomGraph(int nodes, double length, double thickness, unsigned seed) {
  RandomPoints<double> random(1, seed);
  BeamGraph graph;
  for (int i = 0; i < nodes; ++i) graph.nodes.push_back(random.next());
  for (std::uint32_t i = 0; i + 1 < graph.nodes.size(); i += 2) {
    graph.nodes[i + 1] =
        graph.nodes[i] + std::ldexp(length, -static_cast<int>(i % 5)) * random.next();
    const auto r = thickness * abs(random.next());
    BeamGraph::Beam beam{{i, i + 1}, {r.x, i % 3 == 0 ? r.x : i % 7 == 0 ? 0 : r.y}};
    if (i % 4 == 0) {
      beam.body = BeamBody::Frustum;
      beam.caps = {BeamCap{static_cast<std::uint8_t>(i / 4 % 3)},
                   BeamCap{static_cast<std::uint8_t>(i / 12 % 3)}};
    }
    graph.beams.push_back(beam);
    if (i % 6 == 0) graph.balls.push_back({i, thickness * (0.2 + std::abs(random.next().x))});
  }
  return graph;
}

bool inBall(const Vec3<double>& p, const Vec3<double>& center, double radius) {
  return length(p - center) < radius;
}

/// By definition: within a ball whose centre and radius run from one end to the other.
bool isInConeSphere(const BeamGraph::Beam& beam, const Vec3<double>& a, const Vec3<double>& b,
                    const Vec3<double>& p) {
  const auto excess = [&](double t) {
    return length(p - a - t * (b - a)) - beam.radii[0] - t * (beam.radii[1] - beam.radii[0]);
  };
  double from = 0;
  double to = 1;
  for (int i = 0; i < 80; ++i) {  // it is convex
    const double third = (to - from) / 3;
    if (excess(from + third) < excess(to - third)) {
      to -= third;
    } else {
      from += third;
    }
  }
  return std::min({excess(from), excess(0), excess(1)}) < 0;
}

/// By definition: within the cone, between its ends, or in a cap.
bool isInFrustum(const BeamGraph::Beam& beam, const Vec3<double>& a, const Vec3<double>& b,
                 const Vec3<double>& p) {
  const double t = dot(p - a, b - a) / dot(b - a, b - a);
  const double radius = beam.radii[0] + t * (beam.radii[1] - beam.radii[0]);
  if (0 <= t && t <= 1 && inBall(p, a + t * (b - a), radius)) return true;
  const auto inCap = [&](std::size_t end, bool isBeyond) {
    const auto cap = beam.caps.at(end);
    return (cap == BeamCap::Sphere || (cap == BeamCap::Hemisphere && isBeyond)) &&
           inBall(p, end == 0 ? a : b, beam.radii.at(end));
  };
  return inCap(0, t < 0) || inCap(1, t > 1);
}

bool isInside(const BeamGraph& graph, const Vec3<double>& p) {
  return std::ranges::any_of(
             graph.balls,
             [&](const auto& ball) { return inBall(p, graph.nodes[ball.node], ball.radius); }) ||
         std::ranges::any_of(graph.beams, [&](const auto& beam) {
           const auto& a = graph.nodes[beam.nodes[0]];
           const auto& b = graph.nodes[beam.nodes[1]];
           return beam.body == BeamBody::ConeSphere ? isInConeSphere(beam, a, b, p)
                                                    : isInFrustum(beam, a, b, p);
         });
}

/// The plain loop over shapes.
template <typename T>
class PlainLoop {
 public:
  explicit PlainLoop(const BeamGraph& graph) {
    for (const auto& beam : graph.beams) {
      const Vec3<T> a(graph.nodes[beam.nodes[0]]);
      const Vec3<T> b(graph.nodes[beam.nodes[1]]);
      const T r = static_cast<T>(beam.radii[0]);
      const T s = static_cast<T>(beam.radii[1]);
      if (beam.body == BeamBody::ConeSphere) {
        beams_.emplace_back(ConeSphere<T>(a, b, r, s));
      } else {
        beams_.emplace_back(CappedBeam<T>(a, b, r, s, beam.caps));
      }
    }
    for (const auto& ball : graph.balls) {
      const Vec3<T> center(graph.nodes[ball.node]);
      const T radius = static_cast<T>(ball.radius);
      beams_.emplace_back(ConeSphere<T>(center, center, radius, radius));
    }
  }
  [[nodiscard]] NearestBeam<T> nearest(const Vec3<T>& p) const {
    NearestBeam<T> best;
    for (std::uint32_t i = 0; i < beams_.size(); ++i) {
      const T value = std::visit(Value{p}, beams_[i]);
      if (value < best.value) best = {i, value};
    }
    return best;
  }

 private:
  struct Value {
    const Vec3<T>& p;
    T operator()(const CappedBeam<T>& beam) const { return beam.distance(p); }
    T operator()(const SignedDistanceFunction<T>& shape) const { return shape.signedDistance(p); }
  };
  std::vector<std::variant<ConeSphere<T>, CappedBeam<T>>> beams_;
};

template <typename T>
void expectSameAsLoop(const PlainLoop<T>& loop, const Vec3<T>& p, const BeamLattice<T>& lattice) {
  const auto wanted = loop.nearest(p);
  const auto found = lattice.nearestBeam(p);
  EXPECT_PRED2(sameBits<T>, found.value, wanted.value) << p;
  EXPECT_EQ(found.beam, wanted.beam) << p;
  EXPECT_PRED2(sameBits<T>, lattice.signedDistance(p), wanted.value) << p;
}

TYPED_TEST(BeamLatticeTest, HasTheBitsOfThePlainLoop) {
  using T = TypeParam;
  for (const int nodes : {2, 40, 3000}) {
    for (const double length : {0.05, 1.0}) {
      const auto graph = randomGraph(nodes, length, 0.2 * length, 5);
      const BeamLattice<T> lattice(graph);
      const PlainLoop<T> loop(graph);
      RandomPoints<T> random(2, 3);
      for (int i = 0; i < scaled(100); ++i) {
        const auto p = random.next();
        expectSameAsLoop(loop, p, lattice);
        expectSameAsLoop(loop, T(1e4) * p, lattice);
        const auto& node = graph.nodes[static_cast<std::size_t>(i) % graph.nodes.size()];
        expectSameAsLoop(loop, Vec3<T>(node), lattice);
        expectSameAsLoop(loop, Vec3<T>(node + 1e-6 * Vec3<double>(p)), lattice);
      }
    }
  }
}

TYPED_TEST(BeamLatticeTest, BatchesOfNeighboursHaveTheSameBits) {
  using T = TypeParam;
  const BeamLattice<T> lattice(beamsOf(UnitCell::octet(), {{0.1, 0.1, 0.1}, {9, 9, 9}}, 0.01));
  std::vector<Vec3<T>> points;
  for (int i = 0; i < 4000; ++i) {  // lines through the array, far away now and then
    const T x = static_cast<T>(i % 200) / 150;
    points.push_back({x, static_cast<T>(i / 200) / 19, i % 50 == 0 ? T(-40) : T(0.45)});
  }
  std::vector<T> values(points.size());
  lattice.signedDistances(points, values, {.threads = 2});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_PRED2(sameBits<T>, values[i], lattice.signedDistance(points[i])) << points[i];
  }
}

TYPED_TEST(BeamLatticeTest, OfOneKindAloneAndFarAwayHasTheBitsOfThePlainLoop) {
  using T = TypeParam;
  for (const auto body : {BeamBody::ConeSphere, BeamBody::Frustum}) {
    auto graph = randomGraph(600, 0.2, 0.05, 6);
    for (auto& beam : graph.beams) beam.body = body;
    graph.balls.clear();
    const BeamLattice<T> lattice(graph);
    const PlainLoop<T> loop(graph);
    RandomPoints<T> random(1, 12);
    for (const T far : {T(1), T(1e3), T(1e6), T(1e9), T(1e15), T(1e18), T(1e30)}) {
      for (int i = 0; i < 10; ++i) expectSameAsLoop(loop, far * random.next(), lattice);
    }
  }
}

TYPED_TEST(BeamLatticeTest, OfEqualBeamsTheFirstIsTheNearest) {
  using T = TypeParam;
  BeamGraph graph{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, {}, {}};
  for (int i = 0; i < 200; ++i) graph.beams.push_back({{0, 1}, {0.125, 0.125}});
  graph.beams[0].nodes = {0, 2};
  graph.beams[77].body = BeamBody::Frustum;
  const BeamLattice<T> lattice(graph);
  const PlainLoop<T> loop(graph);
  for (const Vec3<T> p :
       {Vec3<T>{T(0.3), T(0.2), T(0.7)}, {0, T(-2), T(0.5)}, {T(0.5), 0, T(0.5)}}) {
    expectSameAsLoop(loop, p, lattice);
  }
  EXPECT_EQ(lattice.closestPoint({0, -2, T(0.5)}).owner.face, 1U);
}

TYPED_TEST(BeamLatticeTest, MatchesHandComputedValues) {
  using T = TypeParam;
  const BeamGraph graph{
      {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}},
      {{{0, 1}, {1, 1}}, {{1, 2}, {0.5, 0.5}, BeamBody::Frustum, {BeamCap::Butt, BeamCap::Butt}}},
      {{2, 2.0}}};
  const BeamLattice<T> lattice(graph);
  EXPECT_EQ(lattice.signedDistance({2, 3, 0}), T(2));
  EXPECT_EQ(lattice.signedDistance({-3, 0, 0}), T(2));
  EXPECT_EQ(lattice.signedDistance({8, 3, 0}), T(1));
  EXPECT_EQ(lattice.signedDistance({2, 0, 0}), T(-1));
  const auto c = lattice.closestPoint({2, 3, 0});
  EXPECT_EQ(c.point, (Vec3<T>{2, 1, 0}));
  EXPECT_EQ(c.normal, (Vec3<T>{0, 1, 0}));
  EXPECT_EQ(c.owner.face, 0U);
  EXPECT_TRUE(c.exact);
  EXPECT_EQ(lattice.closestPoint({8, 3, 0}).owner.face, 2U);
  EXPECT_EQ(lattice.owner({8, 2, 0}).face, 2U);
  EXPECT_NEAR(lattice.boundingBox().upper.x, 10, tolerance<T>(10, 64));
  EXPECT_EQ(lattice.guarantee().inside, Quality::LowerBound);
  EXPECT_EQ(lattice.nearestBeam({std::numeric_limits<T>::quiet_NaN(), 0, 0}).beam, kNone);
}

TYPED_TEST(BeamLatticeTest, RandomGraphsKeepTheirGuarantee) {
  using T = TypeParam;
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto graph = randomGraph(seed == 1 ? 8 : 60, 1.5, seed == 3 ? 0.4 : 0.15, seed);
    const GuaranteeOptions options{
        .inside = [&](const Vec3<double>& p) { return isInside(graph, p); },
        .probes = 1500,
        .covering = 6};
    expectGuarantee(BeamLattice<T>(graph), 2.2, options);
  }
}

/// The evaluators against each other: folding or search without memory, and explicit beams.
TYPED_TEST(BeamLatticeTest, BeamsOfCellsAreTheArrayOfCells) {
  using T = TypeParam;
  constexpr T kEps = std::numeric_limits<T>::epsilon();
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const BeamLattice<T> explicitly(beamsOf(cell, {{1, 1, 1}, {3, 2, 4}}, 0.0625));
    const PeriodicLattice<T> array(cell, {{1, 1, 1}, {3, 2, 4}}, T(0.0625));
    RandomPoints<T> random(3, 8);
    for (int i = 0; i < scaled(400); ++i) {
      const Vec3<T> p = random.next() + Vec3<T>{T(1.5), 1, 2};
      EXPECT_NEAR(array.signedDistance(p), explicitly.signedDistance(p), 2 * kEps * (1 + length(p)))
          << p;
    }
  }
}

template <typename T>
std::string latticeRefusal(const BeamGraph& graph) {
  return refusal([&] { return BeamLattice<T>(graph); });
}

TYPED_TEST(BeamLatticeTest, RefusesWhatIsNoGraphAndNamesTheBeam) {
  using T = TypeParam;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const BeamGraph good{{{0, 0, 0}, {1, 0, 0}, {nan, 0, 0}}, {{{0, 1}, {1, 1}}}, {{0, 1}}};
  EXPECT_EQ(latticeRefusal<T>(good), "");
  EXPECT_EQ(latticeRefusal<T>({}), "BeamLattice: need a beam");
  const auto expectRefused = [&](const char* start, auto change) {
    auto graph = good;
    graph.beams.push_back(good.beams[0]);
    change(graph);
    EXPECT_TRUE(latticeRefusal<T>(graph).starts_with(start)) << latticeRefusal<T>(graph);
  };
  const char* const second = "BeamLattice: beam 1: ";
  expectRefused(second, [](auto& g) { g.beams[1].nodes[1] = 3; });
  expectRefused(second, [](auto& g) { g.beams[1].nodes[1] = 2; });
  expectRefused(second, [](auto& g) { g.beams[1].radii = {0, 0}; });
  expectRefused(second, [](auto& g) { g.beams[1].radii = {1, -1}; });
  expectRefused(second, [&](auto& g) { g.beams[1].radii = {nan, 1}; });
  expectRefused(second, [](auto& g) { g.beams[1] = {{0, 0}, {1, 1}, BeamBody::Frustum}; });
  expectRefused("BeamLattice: beam 2: ", [](auto& g) { g.balls[0].radius = 0; });
  expectRefused("BeamLattice: beam 2: ", [](auto& g) { g.balls[0].node = 9; });
}

}  // namespace
}  // namespace cutwater::test
