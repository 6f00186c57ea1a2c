#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/CellArray.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include "ExplicitLattice.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class StrutLatticeTest : public ::testing::Test {};
TYPED_TEST_SUITE(StrutLatticeTest, Precisions);

TYPED_TEST(StrutLatticeTest, MatchesHandComputedDistances) {
  using T = TypeParam;
  const PeriodicLattice<T> cubic(UnitCell::simpleCubic(), {2, 2, 2}, T(0.25));
  EXPECT_EQ(cubic.signedDistance({0, 0, 1}), T(-0.25));  // on an edge
  EXPECT_EQ(cubic.signedDistance({1, 1, 0}), T(0.75));   // middle of a face
  EXPECT_NEAR(cubic.signedDistance({1, 1, 1}), std::sqrt(T(2)) - T(0.25), tolerance<T>(1));
  EXPECT_EQ(cubic.signedDistance({-40, 80, 61}), T(-0.25));
  EXPECT_EQ(cubic.gradient({T(0.5), 0, 1}), (Vec3<T>{1, 0, 0}));
  EXPECT_EQ(cubic.gradient({T(1.5), 0, 1}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(cubic.closestPoint({T(0.5), 0, 1}).point, (Vec3<T>{T(0.25), 0, 1}));
  EXPECT_TRUE(cubic.closestPoint({T(0.5), 0, 1}).exact);
  EXPECT_EQ(cubic.boundingBox(), Box<T>::everywhere());

  const CellArray<T> two(UnitCell::simpleCubic(), {{1, 1, 1}, {2, 1, 1}}, T(0.125));
  EXPECT_EQ(two.signedDistance({4, 0, 0}), T(1.875));
  EXPECT_EQ(two.signedDistance({1, T(0.5), T(0.5)}), T(0.375));
  EXPECT_EQ(two.closestPoint({4, 1, 1}).point, (Vec3<T>{T(2.125), 1, 1}));
  EXPECT_NEAR(two.boundingBox().upper.x, T(2.125), tolerance<T>(2, 64));
  EXPECT_NEAR(two.boundingBox().lower.z, T(-0.125), tolerance<T>(2, 64));
}

TYPED_TEST(StrutLatticeTest, EveryCellKeepsItsGuarantee) {
  using T = TypeParam;
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto around = explicitStruts(cell.struts(), -4, 3);
    const GuaranteeOptions options{
        .inside =
            [&](const Vec3<double>& p) {
              return distanceTo(std::span<const CellStrut>(around), {1, 1, 1}, p) < 0.0625;
            },
        .probes = 1500,
        .lines = 24};
    expectGuarantee(PeriodicLattice<T>(cell, {1, 1, 1}, T(0.0625)), 0.7, options);
  }
}

TYPED_TEST(StrutLatticeTest, BoxCellsAndArraysKeepTheirGuarantee) {
  using T = TypeParam;
  const GuaranteeOptions options{.probes = 2000, .lines = 24};
  expectGuarantee(PeriodicLattice<T>(UnitCell::octet(), {1, T(1.5), T(0.75)}, T(0.1)), 1, options);
  expectGuarantee(PeriodicLattice<T>(UnitCell::diamond(), {1, 1, 2}, T(0.1)), 1, options);
  for (const auto& cell : {UnitCell::octet(), UnitCell::reentrant(0.8), UnitCell::srs()}) {
    SCOPED_TRACE(cell.name());
    CellArray<T> array(cell, {{1, T(0.75), 1}, {2, 1, 1}}, T(0.0625));
    array.translate({-1, T(-0.5), T(-0.5)});
    expectGuarantee(array, 1.3, options);
  }
  expectGuarantee(CellArray<T>(UnitCell::bcc(), {{1, 1, 1}, {0, 0, 1}}, T(0.1)), 1.2, options);
}

TYPED_TEST(StrutLatticeTest, TheRadiusIsTakenOffTheSkeletonsDistance) {
  using T = TypeParam;
  PeriodicLattice<T> lattice(UnitCell::weairePhelan(), {1, 1, 1}, T(0.03));
  lattice.rotate(90, 2);
  lattice.translate({T(0.25), T(-0.5), 3});
  RandomPoints<T> points(2);
  for (int i = 0; i < 300; ++i) {
    const auto p = points.next();
    const auto nearest = lattice.skeletonPoint(p);
    EXPECT_EQ(nearest.distance - T(0.03), lattice.signedDistance(p));
    EXPECT_NEAR(lattice.signedDistance(p - nearest.away), T(-0.03), tolerance<T>(8));
  }
  EXPECT_EQ(lattice.skeletonPoint({std::numeric_limits<T>::quiet_NaN(), 0, 0}).strut, kNone);
  EXPECT_NE(lattice.signedDistance({0, 0, 0}), T(-0.03));
}

TYPED_TEST(StrutLatticeTest, ThickStrutsLeaveNothingFree) {
  using T = TypeParam;
  const PeriodicLattice<T> full(UnitCell::octet(), {1, 1, 1}, T(0.5));
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) EXPECT_LT(full.signedDistance(points.next()), 0);
  EXPECT_EQ(full.classify({{-9, -9, -9}, {9, 9, 9}}), BoxClass::Unknown);
  EXPECT_EQ(full.classify({{T(0.1), 0, 0}, {T(0.2), T(0.1), T(0.1)}}), BoxClass::Inside);
}

TYPED_TEST(StrutLatticeTest, SaysWhatItIs) {
  using T = TypeParam;
  const auto text = PeriodicLattice<T>(UnitCell::octet(), {1, 1, 1}, T(0.1)).describe();
  EXPECT_TRUE(text.starts_with("Lattice of cells: octet: outside exact, inside lower bound"))
      << text;
}

TYPED_TEST(StrutLatticeTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const auto octet = UnitCell::octet();
  for (const T bad :
       {T(0), T(-1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW(PeriodicLattice<T>(octet, {1, 1, 1}, bad), Error) << bad;
    EXPECT_THROW(PeriodicLattice<T>(octet, {1, bad, 1}, T(0.1)), Error) << bad;
    EXPECT_THROW(CellArray<T>(octet, {{1, 1, bad}, {1, 1, 1}}, T(0.1)), Error) << bad;
  }
  try {
    CellArray<T>(octet, {{1, 1, 1}, {1, 1, 1}}, 0);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("CellArray: need 0 < radius"));
  }
}

}  // namespace
}  // namespace cutwater::test
