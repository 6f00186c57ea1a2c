#include <Cutwater/Cutwater.hpp>
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <atomic>
#include <cmath>
#include <numbers>

#include "Support/ClosedSurface.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using std::numbers::pi;

double volumeOf(const PolygonSoup& soup) {
  return measure(soup).volume;
}

template <typename T>
class IsosurfaceTest : public ::testing::Test {};
TYPED_TEST_SUITE(IsosurfaceTest, Precisions);

/// Another sign at every node: whatever marching cubes may meet.
template <typename T>
struct Noise {
  T operator()(const Vec3<T>& p) const {
    const double x = std::sin(17.1 * double(p.x) + 31.7 * double(p.y) + 71.3 * double(p.z)) * 4e4;
    return static_cast<T>(x - std::floor(x) - 0.5);
  }
};

TYPED_TEST(IsosurfaceTest, IsClosedWhateverTheSigns) {
  using T = TypeParam;
  const FunctionSDF noise(Noise<T>{}, Guarantee<T>{});
  for (const T spacing : {T(0.5), T(0.11), T(0.04)}) {
    for (const double angle : {180.0, 20.0}) {
      const auto nodes = nodesAround<T>({{0, 0, 0}, {1, T(0.7), T(0.9)}}, spacing);
      const auto soup = isosurface<T>(noise, nodes, {.featureAngle = angle});
      EXPECT_GT(soup.polygonCount(), 100U);
      expectClosed(soup, std::to_string(spacing));
    }
  }
}

template <typename T>
struct Known {
  std::string name;
  Solid<T> solid;
  double volume;
};

template <typename T>
std::vector<Known<T>> knownSolids() {
  const Sphere<T> ball({T(0.1), T(-0.2), T(0.3)}, 1);
  const Cuboid<T> block({T(-0.7), T(-0.5), T(-0.3)}, {T(0.6), T(0.4), T(0.2)});
  return {{"ball", ball, 4 * pi / 3},
          {"block", block, 1.3 * 0.9 * 0.5},
          {"torus", Torus<T>(T(0.7), T(0.25)), 2 * pi * pi * 0.7 * 0.0625},
          {"cylinder", Cylinder<T>({0, 0, T(-0.5)}, {0, 0, T(0.5)}, T(0.6)), pi * 0.36},
          {"scaled", scaled(ball, T(0.5)), pi / 6},
          {"what is left of a block", block - Cylinder<T>({0, 0, -1}, {0, 0, 1}, T(0.3)),
           1.3 * 0.9 * 0.5 - pi * 0.09 * 0.5}};
}

TYPED_TEST(IsosurfaceTest, HasTheVolumeOfTheSolid) {
  using T = TypeParam;
  for (const auto& [name, solid, volume] : knownSolids<T>()) {
    const auto box = solid.boundingBox();
    std::array<double, 2> errors{};
    for (std::size_t n = 0; n < 2; ++n) {
      const T spacing = n == 0 ? T(0.06) : T(0.02);
      const auto soup = isosurface<T>(solid, nodesAround(box, spacing));
      expectClosed(soup, name);
      errors[n] = std::abs(volumeOf(soup) - volume) / volume;
      for (const auto& point : soup.points) {
        EXPECT_LE(std::abs(solid.signedDistance(Vec3<T>(point))), T(0.0006) * spacing) << name;
      }
    }
    EXPECT_LT(errors[1], 0.004) << name;
    EXPECT_LT(errors[1], errors[0] / 3) << name;
  }
}

TYPED_TEST(IsosurfaceTest, LiesWithinTheCertainVolume) {
  using T = TypeParam;
  for (const auto& cell : UnitCell::all()) {
    const PeriodicLattice<T> array(cell, {.period = {1, 1, 1}, .count = {1, 1, 1}}, T(0.08));
    const auto nodes = nodesAround(array.boundingBox(), T(0.025));
    const auto soup = isosurface<T>(array, nodes);
    expectClosed(soup, cell.name());
    const auto certain = solidVolume(array, array.boundingBox(), {.fraction = 0.08});
    EXPECT_TRUE(certain.volume.contains(volumeOf(soup))) << cell.name();
  }
}

/// All there are; those without end cut off by a block.
std::vector<Solid<double>> allShapes() {
  const Vec3<double> low{-0.9, -0.7, -0.8};
  const Vec3<double> high{0.8, 0.9, 0.7};
  const Vec3<double> from{-0.4, 0.1, -0.5};
  const Vec3<double> to{0.3, -0.2, 0.6};
  const Polygon<double> section({{0.2, -0.6}, {0.9, -0.4}, {0.7, 0.5}, {0.3, 0.8}},
                                {{{0.4, -0.2}, {0.6, -0.2}, {0.5, 0.2}}});
  const Cuboid<double> block(low, high);
  return {
      block,
      RoundedBox<double>(low, high, 0.2),
      BoxFrame<double>({low, high}, 0.25),
      HexagonalPrism<double>(0.6, 1.1),
      Octahedron<double>(0.9),
      Pyramid<double>(1.2, 0.8),
      Sphere<double>(from, 0.7),
      Ellipsoid<double>(from, {0.5, 0.8, 0.3}),
      Torus<double>(0.6, 0.25),
      CappedTorus<double>(0.6, 0.2, 100),
      Link<double>(0.4, 0.5, 0.2),
      Capsule<double>(from, to, 0.3),
      ConeSphere<double>(from, to, 0.4, 0.2),
      Cylinder<double>(from, to, 0.4),
      RoundedCylinder<double>(from, to, 0.4, 0.1),
      Cone<double>(from, to, 0.5),
      CappedCone<double>(from, to, 0.5, 0.2),
      ConvexPolyhedron<double>(
          {{low, {-1, 0, 0}}, {low, {0, -1, 0}}, {low, {0, 0, -1}}, {{0.3, 0.3, 0.3}, {1, 2, 3}}}),
      Extrusion<double>(section, -0.3, 0.6),
      Revolution<double>(section),
      block & Plane<double>(from, {1, 2, 3}),
      block & InfiniteCylinder<double>(from, to, 0.4),
      block & InfiniteCone<double>(from, to, 40)};
}

TEST(IsosurfaceOfShapesTest, AreClosedAndOfTheCertainVolume) {
  for (const auto& solid : allShapes()) {
    const auto text = solid.describe();
    const auto soup = isosurface<double>(solid, nodesAround(solid.boundingBox(), 0.05));
    expectClosed(soup, text);
    const auto certain = solidVolume(solid, solid.boundingBox(), {.fraction = 0.06});
    EXPECT_TRUE(certain.isWithinTolerance) << text;
    EXPECT_GT(certain.volume.lower, 0) << text;
    EXPECT_TRUE(certain.volume.contains(volumeOf(soup))) << volumeOf(soup) << ' ' << text;
  }
}

TYPED_TEST(IsosurfaceTest, EndsWithTheGrid) {
  using T = TypeParam;
  // Half of a ball, and a quarter of all space: cut off where the nodes end.
  const GridPatch<T> nodes{{{0, 0, 0}, {T(0.05), T(0.05), T(0.05)}, Centering::Node},
                           IndexBox::ofSize(21, 31, 27)};
  const auto ball = isosurface<T>(Sphere<T>({0, T(0.7), T(0.6)}, T(0.5)), nodes);
  expectClosed(ball, "ball");
  EXPECT_NEAR(volumeOf(ball), pi / 12, 0.004);
  EXPECT_EQ(ball.patchNames, (std::vector<std::string>{"surface", "end of grid"}));
  double ends = 0;
  for (std::size_t n = 0; n < ball.polygonCount(); ++n) {
    if (ball.patches[n] != 1) continue;
    const auto corner = [&](std::size_t i) { return ball.points[ball.polygon(n)[i]]; };
    ends += 0.5 * length(cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(corner(i).x, 0);
  }
  EXPECT_NEAR(ends, pi / 4, 0.01);

  const auto wedge = isosurface<T>(
      Plane<T>({T(0.33), 0, 0}, {1, 0, 0}) & Plane<T>({0, T(0.44), 0}, {0, 1, 0}), nodes);
  expectClosed(wedge, "wedge");
  EXPECT_NEAR(volumeOf(wedge), 0.33 * 0.44 * 1.3, 1e-3);

  const auto everything = isosurface<T>(Plane<T>({9, 0, 0}, {1, 0, 0}), nodes);
  expectClosed(everything, "everything");
  EXPECT_NEAR(volumeOf(everything), 1 * 1.5 * 1.3, 1e-6);
  EXPECT_EQ(isosurface<T>(Plane<T>({-9, 0, 0}, {1, 0, 0}), nodes).polygonCount(), 0U);
}

template <typename T>
struct CountedBall {
  std::atomic<std::size_t>* calls;
  T operator()(const Vec3<T>& p) const {
    ++*calls;
    return length(p) - T(1);
  }
};

TYPED_TEST(IsosurfaceTest, DoesNotEvaluateWhatIsCertainlyFree) {
  using T = TypeParam;
  std::atomic<std::size_t> calls{0};
  const Guarantee<T> exact{
      .outside = Quality::Exact, .inside = Quality::Exact, .lipschitz = T(1), .continuous = true};
  const FunctionSDF ball(CountedBall<T>{&calls}, exact);
  const auto nodes = nodesAround<T>({{-1, -1, -1}, {1, 1, 1}}, T(0.01));
  const auto soup = isosurface<T>(ball, nodes);
  expectClosed(soup, "ball");
  EXPECT_GT(nodes.indices.count(), 8'000'000U);
  EXPECT_LT(calls, 2'500'000U);
}

TYPED_TEST(IsosurfaceTest, FollowsEdgesAndCorners) {
  using T = TypeParam;
  auto block = Cuboid<T>({T(-0.7), T(-0.5), T(-0.3)}, {T(0.6), T(0.4), T(0.2)});
  block.rotate(30, Vec3<T>{1, 2, 3});
  const auto nodes = nodesAround(block.boundingBox(), T(0.04));
  const auto blunt = isosurface<T>(block, nodes);
  const auto sharp = isosurface<T>(block, nodes, {.featureAngle = 30});
  expectClosed(sharp, "block");
  const double volume = 1.3 * 0.9 * 0.5;
  EXPECT_LT(std::abs(volumeOf(sharp) - volume), 0.4 * std::abs(volumeOf(blunt) - volume));
  for (const auto& point : sharp.points) {
    EXPECT_LE(std::abs(block.signedDistance(Vec3<T>(point))), T(0.0006) * T(0.04));
  }
  int corners = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3<T> local{corner % 2 == 0 ? T(-0.7) : T(0.6), corner / 2 % 2 == 0 ? T(-0.5) : T(0.4),
                        corner / 4 == 0 ? T(-0.3) : T(0.2)};
    const Vec3<double> place(block.placement().toWorld(local));
    for (const auto& point : sharp.points) corners += length(point - place) < 1e-4 ? 1 : 0;
  }
  EXPECT_GE(corners, 6);  // those whose planes a single cell has
}

TYPED_TEST(IsosurfaceTest, CrossesItselfNowhere) {
  using T = TypeParam;
  const Cylinder<T> shaft({0, -2, 0}, {0, 2, 0}, T(0.4));
  const auto solid = (Cuboid<T>({-1, -1, T(-0.7)}, {1, 1, T(0.7)}) - shaft) |
                     Cone<T>({0, 0, T(0.2)}, {0, 0, T(1.9)}, T(0.8));
  for (const double angle : {180.0, 30.0}) {
    const auto soup =
        isosurface<T>(solid, nodesAround(solid.boundingBox(), T(0.06)), {.featureAngle = angle});
    expectClosed(soup, "solid");
    const MeshSDF<double> mesh(soup, {.findSelfIntersections = true});
    EXPECT_EQ(mesh.signReport().selfIntersections, 0U) << angle;
  }
}

TYPED_TEST(IsosurfaceTest, IsTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  const auto solid = Torus<T>(1, T(0.3)) | Sphere<T>({1, 0, 0}, T(0.5));
  const auto nodes = nodesAround(solid.boundingBox(), T(0.07));
  const auto one = isosurface<T>(solid, nodes, {.featureAngle = 30, .threads = 1});
  const auto three = isosurface<T>(solid, nodes, {.featureAngle = 30, .threads = 3});
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.corners, three.corners);
  EXPECT_EQ(one.patches, three.patches);
}

TYPED_TEST(IsosurfaceTest, KeepsPatches) {
  using T = TypeParam;
  const auto solid =
      named(Sphere<T>({0, 0, 0}, 1), "ball") | named(Sphere<T>({3, 0, 0}, 1), "other");
  const auto soup = isosurface<T>(solid, nodesAround(solid.boundingBox(), T(0.2)));
  EXPECT_EQ(soup.patchNames, (std::vector<std::string>{"ball", "other"}));
  for (std::size_t n = 0; n < soup.polygonCount(); ++n) {
    EXPECT_EQ(soup.patches[n], soup.points[soup.polygon(n)[0]].x < 1.5 ? 0U : 1U);
  }
}

TYPED_TEST(IsosurfaceTest, RefusesWhatItCannotDo) {
  using T = TypeParam;
  const Sphere<T> ball({0, 0, 0}, 1);
  const auto nodes = nodesAround(ball.boundingBox(), T(0.5));
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, nodes, {.tolerance = 0})), Error);
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, nodes, {.tolerance = 0.6})), Error);
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, nodes, {.threads = -1})), Error);
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, nodes, {.featureAngle = 0})), Error);
  const GridPatch<T> flat{nodes.level, IndexBox::ofSize(3, 1, 3)};
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, flat)), Error);
  const GridPatch<T> cells{{{0, 0, 0}, {1, 1, 1}}, IndexBox::ofSize(3, 3, 3)};
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, cells)), Error);
  const GridPatch<T> endless{nodes.level,
                             {{std::numeric_limits<std::int32_t>::min(), 0, 0},
                              {std::numeric_limits<std::int32_t>::max(), 1, 1}}};
  EXPECT_THROW(static_cast<void>(isosurface<T>(ball, endless)), Error);
  EXPECT_THROW(static_cast<void>(nodesAround(ball.boundingBox(), T(0))), Error);
  EXPECT_THROW(static_cast<void>(nodesAround(ball.boundingBox(), T(1e-12))), Error);
  EXPECT_THROW(static_cast<void>(nodesAround(Box<T>::everywhere(), T(1))), Error);
  EXPECT_THROW(static_cast<void>(nodesAround(Box<T>{}, T(1))), Error);
}

TYPED_TEST(IsosurfaceTest, SaysThatAGuaranteeDoesNotHold) {
  using T = TypeParam;
  // Said to change by no more than a tenth of what it does.
  const auto steep = [](const Vec3<T>& p) { return T(10) * (length(p) - T(1)); };
  Guarantee<T> wrong{.outside = Quality::LowerBound,
                     .inside = Quality::LowerBound,
                     .lipschitz = T(0.01),
                     .continuous = true};
  const FunctionSDF solid(steep, wrong);
  try {
    static_cast<void>(isosurface<T>(solid, nodesAround<T>({{-1, -1, -1}, {1, 1, 1}}, T(0.03))));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Argument);
  }
}

}  // namespace
}  // namespace cutwater::test
