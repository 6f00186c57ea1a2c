#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "ExplicitLattice.hpp"
#include "Support/AllocationCount.hpp"
#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class PeriodicLatticeTest : public ::testing::Test {};
TYPED_TEST_SUITE(PeriodicLatticeTest, Precisions);

TYPED_TEST(PeriodicLatticeTest, MatchesHandComputedDistances) {
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

  const PeriodicLattice<T> two(UnitCell::simpleCubic(), {{1, 1, 1}, {2, 1, 1}}, T(0.125));
  EXPECT_EQ(two.signedDistance({4, 0, 0}), T(1.875));
  EXPECT_EQ(two.signedDistance({1, T(0.5), T(0.5)}), T(0.375));
  EXPECT_EQ(two.closestPoint({4, 1, 1}).point, (Vec3<T>{T(2.125), 1, 1}));
  EXPECT_NEAR(two.boundingBox().upper.x, T(2.125), tolerance<T>(2, 64));
  EXPECT_NEAR(two.boundingBox().lower.z, T(-0.125), tolerance<T>(2, 64));
}

TYPED_TEST(PeriodicLatticeTest, EveryCellKeepsItsGuarantee) {
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

TYPED_TEST(PeriodicLatticeTest, BoxCellsAndArraysKeepTheirGuarantee) {
  using T = TypeParam;
  const GuaranteeOptions options{.probes = 2000, .lines = 24};
  expectGuarantee(PeriodicLattice<T>(UnitCell::octet(), {1, T(1.5), T(0.75)}, T(0.1)), 1, options);
  expectGuarantee(PeriodicLattice<T>(UnitCell::diamond(), {1, 1, 2}, T(0.1)), 1, options);
  for (const auto& cell : {UnitCell::octet(), UnitCell::reentrant(0.8), UnitCell::srs()}) {
    SCOPED_TRACE(cell.name());
    PeriodicLattice<T> array(cell, {{1, T(0.75), 1}, {2, 1, 1}}, T(0.0625));
    array.translate({-1, T(-0.5), T(-0.5)});
    expectGuarantee(array, 1.3, options);
  }
  expectGuarantee(PeriodicLattice<T>(UnitCell::bcc(), {{1, 1, 1}, {0, 0, 1}}, T(0.1)), 1.2,
                  options);
}

TYPED_TEST(PeriodicLatticeTest, TheRadiusIsTakenOffTheSkeletonsDistance) {
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

TYPED_TEST(PeriodicLatticeTest, ThickStrutsLeaveNothingFree) {
  using T = TypeParam;
  const PeriodicLattice<T> full(UnitCell::octet(), {1, 1, 1}, T(0.5));
  RandomPoints<T> points(3);
  for (int i = 0; i < 300; ++i) EXPECT_LT(full.signedDistance(points.next()), 0);
  EXPECT_EQ(full.classify({{-9, -9, -9}, {9, 9, 9}}), BoxClass::Unknown);
  EXPECT_EQ(full.classify({{T(0.1), 0, 0}, {T(0.2), T(0.1), T(0.1)}}), BoxClass::Inside);
}

/// Twice as thick where x < 0 than far beyond, at a slope of 0.05.
template <typename T>
struct ThinnerAlongX {
  T operator()(const Vec3<T>& p) const { return T(0.08) - T(0.05) * p.x; }
};

template <typename T>
std::vector<Thickness<T>> gradedThicknesses() {
  return {Thickness<T>::byDistanceToCellCenter(T(0.05), T(0.12)),
          Thickness<T>::byDistanceTo(Sphere<T>({0, 0, 0}, T(0.8)), {T(0.15), T(0.05), T(0.5)}),
          Thickness<T>::by(ThinnerAlongX<T>(),
                           {.lipschitz = T(0.05), .least = T(0.05), .most = T(0.1)})};
}

TYPED_TEST(PeriodicLatticeTest, GradedLatticesAreTheirFormula) {
  using T = TypeParam;
  const Vec3<double> size{1, 0.75, 1.25};
  const T slopes[] = {T(0.07) / (std::sqrt(T(0.75)) * T(0.75)), T(0.2), T(0.05)};
  for (const auto& cell : {UnitCell::octet(), UnitCell::srs(), UnitCell::diamond()}) {
    const auto around = explicitStruts(cell.struts(), -4, 3);
    for (std::size_t kind = 0; kind < 3; ++kind) {
      const auto thickness = gradedThicknesses<T>()[kind];
      const PeriodicLattice<T> lattice(cell, Vec3<T>(size), thickness);
      RandomPoints<T> points(1);
      for (int i = 0; i < 200; ++i) {
        const auto p = points.next();
        const Vec3<T> inCells{p.x / T(size.x), p.y / T(size.y), p.z / T(size.z)};
        const T nearest = distanceTo(std::span<const CellStrut>(around), size, p);
        const T wanted = (nearest - thickness.at(p, inCells)) / (1 + slopes[kind]);
        EXPECT_NEAR(lattice.signedDistance(p), wanted, tolerance<T>(1)) << cell.name() << p;
        T batch = 0;
        lattice.signedDistances({&p, 1}, {&batch, 1});
        EXPECT_EQ(batch, lattice.signedDistance(p));
      }
    }
  }
}

TYPED_TEST(PeriodicLatticeTest, GradedLatticesKeepTheirGuarantee) {
  using T = TypeParam;
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto around = explicitStruts(cell.struts(), -4, 3);
    std::size_t kind = 0;
    for (const auto& thickness : gradedThicknesses<T>()) {
      SCOPED_TRACE(kind++);
      const GuaranteeOptions options{.inside =
                                         [&](const Vec3<double>& p) {
                                           return distanceTo(std::span<const CellStrut>(around),
                                                             {1, 1, 1}, p) <
                                                  double{thickness.at(Vec3<T>(p), Vec3<T>(p))};
                                         },
                                     .probes = 600,
                                     .lines = 16};
      expectGuarantee(PeriodicLattice<T>(cell, {1, 1, 1}, thickness), 0.7, options);
    }
  }
}

TYPED_TEST(PeriodicLatticeTest, GradedArraysKeepTheirGuaranteeWhereTheyStand) {
  using T = TypeParam;
  const GuaranteeOptions options{.probes = 1500, .lines = 24};
  for (const auto& thickness : gradedThicknesses<T>()) {
    PeriodicLattice<T> array(UnitCell::octet(), {{1, T(0.75), 1}, {2, 1, 1}}, thickness);
    EXPECT_TRUE(array.describe().starts_with("Graded lattice of cells: octet: lower bound"))
        << array.describe();
    array.translate({-1, T(-0.5), T(-0.5)});
    array.rotate(30, 2);
    EXPECT_EQ(array.guarantee().outside, Quality::LowerBound);
    EXPECT_EQ(array.guarantee().inside, Quality::LowerBound);
    EXPECT_EQ(array.guarantee().lipschitz, T(1));
    expectGuarantee(array, 1.3, options);
  }
}

TEST(PeriodicLatticeTest, GradedArraysKeepToTheirRounding) {
  const auto single = gradedThicknesses<float>();
  const auto twice = gradedThicknesses<double>();
  for (std::size_t kind = 0; kind < single.size(); ++kind) {
    expectRounding(PeriodicLattice<float>(UnitCell::octet(), {{1, 1, 1}, {2, 2, 2}}, single[kind]),
                   PeriodicLattice<double>(UnitCell::octet(), {{1, 1, 1}, {2, 2, 2}}, twice[kind]),
                   3);
  }
}

TYPED_TEST(PeriodicLatticeTest, GradedQueriesDoNotAllocate) {
  using T = TypeParam;
  for (const auto& thickness : gradedThicknesses<T>()) {
    const PeriodicLattice<T> array(UnitCell::srs(), {{1, 1, 1}, {2, 2, 2}}, thickness);
    const AllocationCount allocations;
    RandomPoints<T> points(2);
    T sum = 0;
    for (int i = 0; i < 100; ++i) {
      const auto p = points.next();
      sum += array.signedDistance(p) + array.gradient(p).x + array.closestPoint(p).distance;
      sum += array.classify(Box<T>{p, p}.grown(T(0.1))) == BoxClass::Cut ? T(1) : T(0);
    }
    EXPECT_EQ(allocations.count(), 0) << sum;
  }
}

TYPED_TEST(PeriodicLatticeTest, GradedLatticesHoldWhereTheirThicknessDoes) {
  using T = TypeParam;
  const Box<T> domain{{0, 0, 0}, {2, 2, 2}};
  const Guarantee<T> promise{.lipschitz = T(0.05), .continuous = true, .domain = domain};
  const FunctionSDF<T, ThinnerAlongX<T>> field({}, promise);
  const auto thickness = Thickness<T>::byDistanceTo(field, {T(0.1), T(0.2), 1});
  const PeriodicLattice<T> lattice(UnitCell::octet(), {1, 1, 1}, thickness);
  EXPECT_EQ(lattice.guarantee().domain, domain);
  EXPECT_EQ(lattice.classify({{3, 3, 3}, {4, 4, 4}}), BoxClass::Unknown);
}

TYPED_TEST(PeriodicLatticeTest, BlocksClippedByOtherSolidsKeepTheirGuarantee) {
  using T = TypeParam;
  PeriodicLattice<T> block(UnitCell::octet(), {{T(0.5), T(0.5), T(0.5)}, {4, 4, 4}}, T(0.06));
  block.translate({-1, -1, -1});
  const auto isInBlock = [&](const Vec3<double>& p) {
    return block.signedDistance(Vec3<T>(p)) < 0;
  };
  const Solid<T> ball = Sphere<T>({0, 0, 0}, T(0.7));
  expectGuarantee(ball & block, 0.8,
                  {.inside = [&](auto& p) { return isInBlock(p) && length(p) < 0.7; },
                   .probes = 1500,
                   .lines = 24});
  const auto isInCube = [](const Vec3<double>& p) { return maxComponent(abs(p)) < 0.6; };
  const auto mesh = translated(MeshSDF<T>(cube()), {T(-0.5), T(-0.5), T(-0.5)});
  expectGuarantee(cutwater::scaled(mesh, T(1.2)) & block, 0.8,
                  {.inside = [&](auto& p) { return isInBlock(p) && isInCube(p); },
                   .probes = 1500,
                   .lines = 24});
}

TYPED_TEST(PeriodicLatticeTest, SaysWhatItIs) {
  using T = TypeParam;
  const auto text = PeriodicLattice<T>(UnitCell::octet(), {1, 1, 1}, T(0.1)).describe();
  EXPECT_TRUE(text.starts_with("Lattice of cells: octet: outside exact, inside lower bound"))
      << text;
}

TYPED_TEST(PeriodicLatticeTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const auto octet = UnitCell::octet();
  for (const T bad :
       {T(0), T(-1), std::numeric_limits<T>::infinity(), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW(PeriodicLattice<T>(octet, {1, 1, 1}, bad), Error) << bad;
    EXPECT_THROW(PeriodicLattice<T>(octet, {1, bad, 1}, T(0.1)), Error) << bad;
    EXPECT_THROW(PeriodicLattice<T>(octet, {{1, 1, bad}, {1, 1, 1}}, T(0.1)), Error) << bad;
  }
  try {
    const PeriodicLattice<T> lattice(octet, {{1, 1, 1}, {1, 1, 1}}, 0);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("Thickness: need 0 < radius"));
  }
}

}  // namespace
}  // namespace cutwater::test
