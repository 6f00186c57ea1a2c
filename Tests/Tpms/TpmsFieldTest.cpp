#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/CellQuadrature.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {
namespace {

constexpr std::size_t kGyroid = 0;
constexpr std::size_t kSchwarzP = 1;

template <typename T>
class TpmsFieldTest : public ::testing::Test {};
TYPED_TEST_SUITE(TpmsFieldTest, Precisions);

double plainAt(std::size_t pattern, const Vec3<double>& cells) {
  static const auto plain = plainPatterns();
  return plain[pattern].value(kTurn * cells.x, kTurn * cells.y, kTurn * cells.z);
}

Vec3<double> cylindrical(const Vec3<double>& p, double radialSize, int n, double c,
                         double axialSize) {
  const double phi = std::atan2(p.y, p.x);
  return {std::hypot(p.x, p.y) / radialSize, n * (phi / kTurn + c * p.z), p.z / axialSize};
}

TYPED_TEST(TpmsFieldTest, CylindricalCellsKeepTheirGuarantee) {
  using T = TypeParam;
  const auto map = TpmsMap<T>::cylindrical(
      {.radialSize = T(0.5), .cellsPerTurn = 7, .axialSize = T(0.75), .turnsPerLength = T(0.125)});
  const TpmsField<T> field(TpmsPattern::gyroid(), map);
  EXPECT_FALSE(field.isUniform());
  const auto inside = [](const Vec3<double>& p) {
    return std::abs(plainAt(kGyroid, cylindrical(p, 0.5, 7, 0.125, 0.75))) < static_cast<T>(0.3);
  };
  expectGuarantee(TpmsSolid<T>(field, TpmsPart::Wall, T(0.3)), 1.5,
                  {.inside = inside, .probes = 2000, .lines = 24, .covering = 4, .polish = false});
  const auto straight = TpmsMap<T>::cylindrical({T(0.5), 3, 1});
  expectGuarantee(TpmsSolid<T>({TpmsPattern::schwarzD(), straight}, TpmsPart::ChannelA, T(0)), 1.2,
                  {.probes = 1000, .lines = 24, .polish = false});
}

TYPED_TEST(TpmsFieldTest, ATurnJoins) {
  using T = TypeParam;
  for (const int n : {1, 5, 12}) {
    const TpmsField<T> field(TpmsPattern::lidinoid(), TpmsMap<T>::cylindrical({1, n, 1, T(0.3)}));
    const TpmsSolid<T> solid(field, TpmsPart::WallInA, T(0.4));
    RandomPoints<T> random(3);
    for (int i = 0; i < 300; ++i) {
      auto p = random.next();
      p.x = -std::abs(p.x);
      p.y = T(1e-3) * std::numeric_limits<T>::epsilon();
      const Vec3<T> across{p.x, -p.y, p.z};
      EXPECT_NEAR(field.value(p), field.value(across), tolerance<T>(T(n), 64)) << p;
      EXPECT_NEAR(solid.signedDistance(p), solid.signedDistance(across), tolerance<T>(1, 64)) << p;
    }
  }
}

TYPED_TEST(TpmsFieldTest, ValuesVanishAtTheAxisOfCylindricalCells) {
  using T = TypeParam;
  const TpmsSolid<T> solid({TpmsPattern::gyroid(), TpmsMap<T>::cylindrical({1, 5, 1})},
                           TpmsPart::ChannelA, T(0));
  EXPECT_EQ(solid.signedDistance({0, 0, T(0.3)}), 0);
  EXPECT_EQ(solid.classify({{T(-0.1), T(-0.1), 0}, {T(0.1), T(0.1), T(0.1)}}), BoxClass::Cut);
  for (const T rho : {T(1e-6), T(1e-3), T(0.1)}) {
    const T value = std::abs(solid.signedDistance({rho, 0, T(0.3)}));
    EXPECT_LE(value, rho);
    EXPECT_GT(value, 0);
  }
}

TYPED_TEST(TpmsFieldTest, GradedCellsKeepTheirGuarantee) {
  using T = TypeParam;
  const CellSizes<T> along(std::vector<CellSizeAt<T>>{{-1, T(0.5)}, {T(0.25), 1}, {1, T(0.75)}});
  const TpmsMap<T> map(std::array<CellSizes<T>, 3>{T(1), along, T(0.75)});
  const auto inside = [](const Vec3<double>& p) {
    const double y = cellsByQuadrature({{-1, 0.5}, {0.25, 1}, {1, 0.75}}, p.y);
    return plainAt(kGyroid, {p.x, y, p.z / 0.75}) > static_cast<T>(0.1);
  };
  const TpmsSolid<T> solid({TpmsPattern::gyroid(), map}, TpmsPart::ChannelA, T(0.1));
  expectGuarantee(solid, 1.2, {.inside = inside, .probes = 1000, .lines = 24});
  // Where cells are large, what small ones elsewhere change does not count.
  const TpmsSolid<T> uniform({TpmsPattern::gyroid(), T(1)}, TpmsPart::ChannelA, T(0.1));
  const TpmsMap<T> far(std::array<CellSizes<T>, 3>{
      T(1), T(1), CellSizes<T>(std::vector<CellSizeAt<T>>{{2, 1}, {3, T(0.01)}})});
  const TpmsSolid<T> graded({TpmsPattern::gyroid(), far}, TpmsPart::ChannelA, T(0.1));
  EXPECT_GT(std::abs(graded.signedDistance({T(0.2), T(0.1), -1})),
            T(0.5) * std::abs(uniform.signedDistance({T(0.2), T(0.1), -3})));
}

TYPED_TEST(TpmsFieldTest, DeformedCellsKeepTheirGuarantee) {
  using T = TypeParam;
  const DeformationField<T> shifts{
      .amplitude = T(0.15), .spacing = {1, T(1.5), T(0.75)}, .seed = 7};
  const TpmsField<T> field(TpmsPattern::schwarzP(), TpmsMap<T>(1).deformed(shifts));
  const DeformationField<double> same{
      .amplitude = shifts.amplitude, .spacing = {1, 1.5, 0.75}, .seed = 7};
  const auto inside = [&](const Vec3<double>& p) {
    return std::abs(plainAt(kSchwarzP, p + same.shiftAt(p))) < static_cast<T>(0.4);
  };
  expectGuarantee(TpmsSolid<T>(field, TpmsPart::Wall, T(0.4)), 1.2,
                  {.inside = inside, .probes = 2000, .lines = 24});
}

TYPED_TEST(TpmsFieldTest, TransitionsKeepTheirGuarantee) {
  using T = TypeParam;
  const auto weight =
      GradedValue<T>::byValueOf(Plane<T>({0, 0, T(-0.3)}, {0, 0, 1}), {0, 1, T(0.6)});
  const TpmsTransition<T> transition{TpmsPattern::gyroid(), TpmsPattern::schwarzP(), weight};
  const TpmsField<T> field(transition, T(0.8));
  EXPECT_EQ(field.pinch(TpmsChannel::B), 1);
  const auto inside = [](const Vec3<double>& p) {
    const double w = std::clamp((p.z + 0.3) / 0.6, 0.0, 1.0);
    const auto cells = 1 / static_cast<double>(T(0.8)) * p;
    return std::abs((1 - w) * plainAt(kGyroid, cells) + w * plainAt(kSchwarzP, cells)) <
           static_cast<T>(0.35);
  };
  expectGuarantee(TpmsSolid<T>(field, TpmsPart::Wall, T(0.35)), 1.2,
                  {.inside = inside, .probes = 2000, .lines = 24});
  // Beyond the transition it is the one pattern, and the other.
  const TpmsField<T> alone(TpmsPattern::schwarzP(), T(0.8));
  EXPECT_EQ(field.value({T(0.1), T(0.3), 1}), alone.value({T(0.1), T(0.3), 1}));
  EXPECT_NE(field.value({T(0.1), T(0.3), T(0.2)}), alone.value({T(0.1), T(0.3), T(0.2)}));
}

/// From the gyroid to Schwarz P around an axis, in cells that grow along it, deformed at random, as
/// a wall that thickens outwards.
TYPED_TEST(TpmsFieldTest, AllOfItTogetherKeepsItsGuarantee) {
  using T = TypeParam;
  const auto weight = GradedValue<T>::byValueOf(Plane<T>({0, 0, -1}, {0, 0, 1}), {0, 1, 2});
  const auto level = GradedValue<T>::by([](const Vec3<T>& p) { return T(0.1) + T(0.3) * p.x; },
                                        {.lipschitz = T(0.3), .least = T(0.2), .most = T(0.6)});
  const DeformationField<T> shifts{.amplitude = T(0.05), .spacing = {1, 1, 1}};
  const auto map = TpmsMap<T>::cylindrical({T(0.7), 5, T(0.9), T(0.1)}).deformed(shifts);
  const TpmsTransition<T> transition{TpmsPattern::gyroid(), TpmsPattern::schwarzP(), weight};
  for (const auto part : {TpmsPart::Wall, TpmsPart::WallInB}) {
    expectGuarantee(TpmsSolid<T>({transition, map}, part, level), 1.5,
                    {.probes = 1500, .lines = 24, .covering = 5, .polish = false});
  }
}

TEST(TpmsFieldsTest, GradientsAreThoseOfTheValue) {
  const TpmsField<double> uniform(TpmsPattern::gyroid(), TpmsMap<double>(Vec3<double>{2, 3, 1.5}));
  const TpmsField<double> cylindrical(TpmsPattern::gyroid(),
                                      TpmsMap<double>::cylindrical({1, 12, 1}));
  EXPECT_TRUE(uniform.isUniform());
  EXPECT_EQ(cylindrical.steepness(), Box<double>::kInf);
  double most = 0;
  for (const auto& field : {uniform, cylindrical}) {
    for (const auto& p : {Vec3<double>{3.1, 0.7, -0.4}, Vec3<double>{1.3, 2.2, 5.6},
                          Vec3<double>{-2.4, 1.9, 0.3}}) {
      constexpr double kStep = 1e-5;
      const auto gradient = field.gradient(p);
      most = std::max(most, field.isUniform() ? length(gradient) : 0);
      for (int axis = 0; axis < 3; ++axis) {
        Vec3<double> step;
        step[axis] = kStep;
        const double slope = (field.value(p + step) - field.value(p - step)) / (2 * kStep);
        EXPECT_NEAR(gradient[axis], slope, 1e-6);
      }
    }
  }
  EXPECT_LT(most, uniform.steepness());
  EXPECT_GT(most, 0.1 * uniform.steepness());
}

TEST(TpmsFieldsTest, RefuseWeightsBeyondBothPatterns) {
  const Plane<double> plane({0, 0, 0}, {0, 0, 1});
  const auto weight = GradedValue<double>::byValueOf(plane, {0, 1.5, 1});
  EXPECT_THROW(TpmsField<double>(
                   TpmsTransition<double>{TpmsPattern::gyroid(), TpmsPattern::iwp(), weight}, 1.0),
               Error);
}

}  // namespace
}  // namespace cutwater::test
