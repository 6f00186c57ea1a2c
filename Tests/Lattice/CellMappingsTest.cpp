#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/HexahedralCells.hpp>

#include <numbers>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

/// The determinant of the Jacobian by centred differences.
template <typename Mapping>
double determinantAt(const Mapping& mapping, const Vec3<double>& u) {
  constexpr double kStep = 1e-5;
  std::array<Vec3<double>, 3> columns;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<double> step;
    step[axis] = kStep;
    columns[static_cast<std::size_t>(axis)] = (mapping(u + step) - mapping(u - step)) / (2 * kStep);
  }
  return dot(columns[0], cross(columns[1], columns[2]));
}

/// Mean determinant: the volume; and no cell is refused, fine or coarse.
template <typename Mapping>
double volumeOf(const Mapping& mapping) {
  for (const std::uint32_t n : {4U, 9U, 30U}) {
    EXPECT_NO_THROW(HexahedralCells({n, n, n}, mapping)) << n;
  }
  constexpr int kSteps = 40;
  double sum = 0;
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const Vec3<double> cell{0.5 + i % kSteps, 0.5 + i / kSteps % kSteps, 0.5 + i / kSteps / kSteps};
    const double volume = determinantAt(mapping, cell / kSteps);
    EXPECT_GT(volume, 0);
    sum += volume;
  }
  return sum / (kSteps * kSteps * kSteps);
}

constexpr double kPi = std::numbers::pi;

TEST(CellMappingsTest, BoxIsRegular) {
  const BoxMapping box({{-1, 2, 3}, {1, 3, 7}});
  EXPECT_EQ(box({0, 0, 0}), (Vec3<double>{-1, 2, 3}));
  EXPECT_EQ(box({1, 0.5, 0.25}), (Vec3<double>{1, 2.5, 4}));
  EXPECT_NEAR(volumeOf(box), 8, 1e-6);
}

TEST(CellMappingsTest, PipeIsCylindricalCoordinates) {
  const PipeMapping pipe({.innerRadius = 1, .outerRadius = 2, .length = 3});
  EXPECT_EQ(pipe({0, 0, 0}), (Vec3<double>{1, 0, 0}));
  EXPECT_EQ(pipe({1, 0.25, 0.5}), (Vec3<double>{0, 2, 1.5}));
  EXPECT_EQ(pipe({0.5, 0.5, 1}), (Vec3<double>{-1.5, 0, 3}));
  EXPECT_EQ(pipe({0, 0, 0}), pipe({0, 1, 0}));
  EXPECT_EQ(pipe.closedAxes(), (std::array<bool, 3>{false, true, false}));
  EXPECT_NEAR(volumeOf(pipe), 9 * kPi, 0.01);
  const PipeMapping part({1, 2, 3, 30, 120});
  EXPECT_EQ(part.closedAxes(), (std::array<bool, 3>{}));
  RandomPoints<double> random(0.5);
  for (int i = 0; i < 200; ++i) {
    const auto u = random.next() + Vec3<double>{0.5, 0.5, 0.5};
    const auto p = part(u);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1 + u.x, 1e-14);
    EXPECT_NEAR(std::atan2(p.y, p.x), (30 + 90 * u.y) * kPi / 180, 1e-14);
    EXPECT_DOUBLE_EQ(p.z, 3 * u.z);
  }
  EXPECT_NEAR(volumeOf(part), 9 * kPi / 4, 0.01);
}

TEST(CellMappingsTest, CylinderHasTheSidesOfTheSquareOnItsMantle) {
  const CylinderMapping cylinder(2, 5);
  EXPECT_EQ(cylinder({0.5, 0.5, 0}), (Vec3<double>{0, 0, 0}));
  EXPECT_EQ(cylinder({1, 0.5, 1}), (Vec3<double>{2, 0, 5}));
  for (int i = 0; i <= 20; ++i) {
    for (const auto& u :
         {Vec3<double>{0, i / 20.0, 0.5}, {1, i / 20.0, 0}, {i / 20.0, 0, 1}, {i / 20.0, 1, 0}}) {
      const auto p = cylinder(u);
      EXPECT_NEAR(std::hypot(p.x, p.y), 2, 1e-14);
      EXPECT_EQ(p.z, 5 * u.z);
    }
  }
  EXPECT_NEAR(volumeOf(cylinder), 20 * kPi, 0.05);
}

TEST(CellMappingsTest, LensHasItsFacesOnSpheres) {
  const Lens lens{.diameter = 4, .centerThickness = 1.5, .frontRadius = 5, .backRadius = -8};
  const LensMapping mapping(lens);
  const Vec3<double> front{0, 0, -0.75 + 5};
  const Vec3<double> back{0, 0, 0.75 + 8};
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      EXPECT_NEAR(length(mapping({i / 10.0, j / 10.0, 0}) - front), 5, 1e-14);
      EXPECT_NEAR(length(mapping({i / 10.0, j / 10.0, 1}) - back), 8, 1e-14);
    }
  }
  EXPECT_EQ(mapping({0.5, 0.5, 0}), (Vec3<double>{0, 0, -0.75}));
  // A cylinder of 1.5, less a cap of the front's sphere, and what the hollow of the back adds.
  const auto cap = [](double radius) {
    const double height = radius - std::sqrt(radius * radius - 4);
    return 4 * kPi * height - kPi * height * height * (radius - height / 3);
  };
  EXPECT_NEAR(volumeOf(mapping), 4 * kPi * 1.5 - cap(5) + cap(8), 0.05);
  const double flat = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(volumeOf(LensMapping({4, 1.5, flat, flat})), 6 * kPi, 0.02);
}

TEST(CellMappingsTest, AlongAnArcAPipeIsPartOfATorus) {
  std::vector<Vec3<double>> arc;
  constexpr int kPoints = 24;
  for (int i = 0; i <= kPoints; ++i) {
    const double angle = kPi / 2 * i / kPoints;
    arc.push_back({4 * std::cos(angle), 4 * std::sin(angle), 0});
  }
  const Spine spine(arc, {0, 0, 1});
  const AlongSpine pipe(spine, PipeMapping({0.5, 1, spine.length()}));
  EXPECT_EQ(pipe.closedAxes(), (std::array<bool, 3>{false, true, false}));
  RandomPoints<double> random(0.5);
  for (int i = 0; i < 200; ++i) {
    const auto u = random.next() + Vec3<double>{0.5, 0.5, 0.5};
    const auto p = pipe(u);
    const double ring = std::hypot(p.x, p.y) - 4;
    // The spline is straight at its ends, and so off the arc.
    EXPECT_NEAR(std::hypot(ring, p.z), 0.5 + 0.5 * u.x, 2e-3) << u;
    EXPECT_NEAR(std::atan2(p.y, p.x), u.z * kPi / 2, 2e-3);
  }
  EXPECT_NEAR(volumeOf(pipe), 0.75 * kPi * 2 * kPi, 0.02);
  // Wider than the arc's radius it would turn inside out on the inner side.
  EXPECT_THROW(
      HexahedralCells({2, 12, 12}, AlongSpine(spine, PipeMapping({0.5, 5, spine.length()}))),
      Error);
}

template <typename Make>
void expectRefused(const char* start, Make make) {
  try {
    (void)make();
    ADD_FAILURE() << start;
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(start)) << error.what();
  }
}

TEST(CellMappingsTest, RefuseImpossibleShapes) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, inf, std::numeric_limits<double>::quiet_NaN()}) {
    expectRefused("BoxMapping: need a finite box", [&] {
      return BoxMapping({{0, 0, 0}, {1, bad, 1}});
    });
    expectRefused("PipeMapping: need 0 < inner", [&] { return PipeMapping({bad, 1, 1}); });
    expectRefused("PipeMapping: need 0 < inner", [&] { return PipeMapping({1, bad, 1}); });
    expectRefused("PipeMapping: need a length", [&] { return PipeMapping({1, 2, bad}); });
    expectRefused("PipeMapping: need angles", [&] { return PipeMapping({1, 2, 1, 0, bad}); });
    expectRefused("CylinderMapping: need a radius", [&] { return CylinderMapping(bad, 1); });
    expectRefused("CylinderMapping: need a radius", [&] { return CylinderMapping(1, bad); });
    expectRefused("LensMapping: need a diameter", [&] { return LensMapping({bad, 1, 9, 9}); });
    expectRefused("LensMapping: need a diameter", [&] { return LensMapping({1, bad, 9, 9}); });
    if (bad == inf) continue;
    expectRefused("LensMapping: need radii", [&] { return LensMapping({4, 1, bad, 9}); });
    expectRefused("LensMapping: need radii", [&] { return LensMapping({4, 1, 9, bad}); });
  }
  expectRefused("PipeMapping: need angles", [] { return PipeMapping({1, 2, 1, 0, 361}); });
  expectRefused("LensMapping: need faces", [] { return LensMapping({4, 0.5, 4, 4}); });
}

}  // namespace
}  // namespace cutwater::test
