#include <Cutwater/P4est/DistributedOctree.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include <p8est_algorithms.h>

#include "Ranks.hpp"
#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
struct Values {
  explicit Values(std::size_t count) : distance(count), normal(count), patch(count) {}
  [[nodiscard]] OctreeTargets<T> targets() { return {distance, normal, patch}; }

  std::vector<T> distance;
  std::vector<Vec3<T>> normal;
  std::vector<std::uint32_t> patch;
};

template <typename T>
class DistributedOctreeTest : public ::testing::Test {
 protected:
  using Mesh = DistributedOctree<T>;

  /// That the mesh on all ranks is the one of one process: cells, order, values, sums.
  static void expectSame(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                         const Refinement<T>& rules, const DistributedOctreeOptions& options = {}) {
    const Mesh mesh(solid, domain, rules, MPI_COMM_WORLD, options);
    expectForest(mesh);
    Values<T> own(mesh.local().cells().size());
    fill(solid, mesh.local(), own.targets(), {.threads = 1});
    const auto cells = gathered(mesh.local().cells());
    const auto distance = gathered(std::span<const T>(own.distance));
    const auto patch = gathered(std::span<const std::uint32_t>(own.patch));
    const auto sum = mesh.checksum(own.targets());
    const auto sumOfCells = mesh.checksum({});
    const auto forestSum = mesh.forestChecksum();
    if (ownRank() != 0) return;

    const Octree<T> expected(solid, domain, rules, {.balance = options.balance});
    EXPECT_EQ(mesh.cellCount(), expected.cells().size());
    EXPECT_TRUE(std::ranges::equal(cells, expected.cells()));
    Values<T> all(expected.cells().size());
    fill(solid, expected, all.targets());
    EXPECT_EQ(distance, all.distance);
    EXPECT_EQ(patch, all.patch);
    EXPECT_EQ(sum, cutwater::checksum(expected, all.targets()));
    EXPECT_EQ(sumOfCells, cutwater::checksum(expected, OctreeTargets<T>{}));
    EXPECT_EQ(forestSum, Mesh(solid, domain, rules, MPI_COMM_SELF, options).forestChecksum());
  }

  /// p4est's view of it.
  static void expectForest(const Mesh& mesh) {
    EXPECT_EQ(p8est_is_valid(mesh.forest()), 1);
    EXPECT_EQ(mesh.forest()->data_size, 0U);
    EXPECT_EQ(static_cast<std::size_t>(mesh.forest()->local_num_quadrants),
              mesh.local().cells().size());
    std::uint64_t before = 0;
    const std::uint64_t own = mesh.local().cells().size();
    MPI_Exscan(&own, &before, 1, MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_EQ(mesh.firstNumber(), ownRank() == 0 ? 0 : before);
  }

  const OctreeDomain<T> domain{{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}};
};
TYPED_TEST_SUITE(DistributedOctreeTest, Precisions);

TYPED_TEST(DistributedOctreeTest, IsTheOctreeOfASphereWithBands) {
  using T = TypeParam;
  this->expectSame(Sphere<T>({T(0.1), 0, T(0.2)}, T(0.7)), this->domain,
                   {.cut = 4, .bands = {{T(0.1), 3}, {T(0.4), 2}}});
}

TYPED_TEST(DistributedOctreeTest, IsTheOctreeOfMeshAndPlateWithEveryRule) {
  using T = TypeParam;
  this->expectSame(ballAndPlate<T>(), this->domain,
                   {.cut = 2,
                    .bands = {{T(0.2), 2}},
                    .patches = {{1, 3}},
                    .curvature = typename Refinement<T>::Angle{20, 3},
                    .edges = typename Refinement<T>::Angle{60, 4},
                    .walls = typename Refinement<T>::Width{1, 3}});
}

TYPED_TEST(DistributedOctreeTest, BalancesAsTheOctreeDoes) {
  using T = TypeParam;
  // A speck in a corner of a root, off centre: much finer cells across faces, edges and corners of
  // several trees.
  const Sphere<T> speck({T(0.51), T(0.013), T(0.57)}, T(0.02));
  for (const auto balance : {Balance::None, Balance::Face, Balance::Edge, Balance::Corner}) {
    this->expectSame(speck, this->domain, {.cut = 7}, {.balance = balance});
  }
}

TYPED_TEST(DistributedOctreeTest, HasAnyNumberOfRoots) {
  using T = TypeParam;
  const Solid<T> ball = Sphere<T>({T(0.9), T(0.8), T(0.7)}, T(0.6));
  for (const Index3 roots :
       {Index3{1, 1, 1}, Index3{3, 5, 2}, Index3{1, 7, 1}, Index3{2, 1, 9}, Index3{6, 3, 3}}) {
    this->expectSame(ball, OctreeDomain<T>({0, 0, 0}, T(0.7), roots), {.cut = 3});
  }
}

TYPED_TEST(DistributedOctreeTest, MayHaveFewerCellsThanRanks) {
  using T = TypeParam;
  const Sphere<T> far({100, 0, 0}, 1);
  this->expectSame(far, OctreeDomain<T>({0, 0, 0}, 1, {1, 1, 1}), {.cut = 3});
  this->expectSame(far, OctreeDomain<T>({0, 0, 0}, 1, {2, 1, 1}), {.cut = 3});
}

TYPED_TEST(DistributedOctreeTest, IsTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  this->expectSame(ballAndPlate<T>(), this->domain, {.cut = 3}, {.threads = 3});
}

TYPED_TEST(DistributedOctreeTest, ReachesTheDeepestLevel) {
  using T = TypeParam;
  const T tiny = std::ldexp(T(1), -18);
  this->expectSame(Sphere<T>({1, 1, 0}, tiny), OctreeDomain<T>({0, 0, 0}, 1, {1, 1, 1}),
                   {.cut = 18});
}

TYPED_TEST(DistributedOctreeTest, SharesOutByWeight) {
  using T = TypeParam;
  for (const int cutWeight : {1, 20}) {
    const DistributedOctree<T> mesh(ballAndPlate<T>(), this->domain, {.cut = 4}, MPI_COMM_WORLD,
                                    {.cutWeight = cutWeight});
    double own = 0;
    for (const auto& cell : mesh.local().cells()) own += mayBeCut(cell.kind) ? cutWeight : 1;
    double all = 0;
    MPI_Allreduce(&own, &all, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    EXPECT_NEAR(own, all / rankCount(), cutWeight + 1);
  }
}

TYPED_TEST(DistributedOctreeTest, SumsTellMeshesAndValuesApart) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  const DistributedOctree<T> mesh(solid, this->domain, {.cut = 2}, MPI_COMM_WORLD);
  Values<T> values(mesh.local().cells().size());
  fill(solid, mesh.local(), values.targets());
  const auto sum = mesh.checksum(values.targets());
  EXPECT_NE(sum, mesh.checksum({}));
  if (ownRank() == 0) values.distance[0] = std::nextafter(values.distance[0], T(10));
  EXPECT_NE(sum, mesh.checksum(values.targets()));
  expectAgreedError(ErrorKind::Argument, [&] {  // of one rank, too few
    if (ownRank() == 0) values.distance.pop_back();
    static_cast<void>(mesh.checksum(values.targets()));
  });
}

TYPED_TEST(DistributedOctreeTest, RefusesWhatCannotBe) {
  using T = TypeParam;
  const auto refused = [&](const OctreeDomain<T>& where, const Refinement<T>& rules,
                           const DistributedOctreeOptions& options = {}) {
    expectAgreedError(ErrorKind::Argument, [&] {
      const DistributedOctree<T> mesh(ballAndPlate<T>(), where, rules, MPI_COMM_WORLD, options);
    });
  };
  refused(this->domain, {.cut = -1});
  refused(this->domain, {.bands = {{T(-1), 2}}});
  refused(this->domain, {.cut = 19});                              // beyond the octree's own
  refused(OctreeDomain<T>({0, 0, 0}, 1, {1, 1, 1}), {.cut = 19});  // beyond p4est's
  refused(OctreeDomain<T>({0, 0, 0}, 1, {1024, 1024, 17}), {.cut = 1});
  refused(this->domain, {.cut = 1}, {.cutWeight = 0});
  refused(this->domain, {.cut = 1}, {.cutWeight = 1001});
  refused(this->domain, {.cut = 1}, {.threads = -1});
}

TYPED_TEST(DistributedOctreeTest, EndsAtItsLimit) {
  using T = TypeParam;
  const auto ball = ballAndPlate<T>();
  const auto meshed = [&](std::size_t most) {
    return DistributedOctree<T>(ball, this->domain, {.cut = 3}, MPI_COMM_WORLD, {.maxCells = most});
  };
  const std::size_t count = meshed(std::numeric_limits<std::size_t>::max()).cellCount();
  EXPECT_EQ(meshed(count).cellCount(), count);
  for (const std::size_t most : {count - 1, count / 2, std::size_t{1}}) {
    expectAgreedError(ErrorKind::Limit, [&] { static_cast<void>(meshed(most)); });
  }
}

TYPED_TEST(DistributedOctreeTest, RefusesRanksThatDiffer) {
  using T = TypeParam;
  if (rankCount() == 1) GTEST_SKIP() << "needs two ranks";
  using Rules = Refinement<T>;
  struct Arguments {
    OctreeDomain<T> domain;
    Rules rules = {.cut = 3};
    DistributedOctreeOptions options = {};
    T radius = 1;
  };
  const auto expectRefused = [&](const std::string& what, const auto& change) {
    Arguments arguments{this->domain};
    if (ownRank() == rankCount() - 1) change(arguments);
    try {
      const DistributedOctree<T> mesh(Sphere<T>({0, 0, 0}, arguments.radius), arguments.domain,
                                      arguments.rules, MPI_COMM_WORLD, arguments.options);
      ADD_FAILURE() << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.what(), "DistributedOctree: the ranks have different " + what);
    }
  };
  expectRefused("refinements", [](Arguments& a) { a.rules.cut = 4; });
  expectRefused("refinements", [](Arguments& a) { a.rules.bands = {{T(0.1), 2}}; });
  expectRefused("refinements", [](Arguments& a) { a.rules.patches = {{0, 2}}; });
  for (auto Rules::*angle : {&Rules::curvature, &Rules::edges}) {
    expectRefused("refinements", [=](Arguments& a) { a.rules.*angle = {T(20), 4}; });
  }
  for (auto Rules::*width : {&Rules::gaps, &Rules::walls}) {
    expectRefused("refinements", [=](Arguments& a) { a.rules.*width = {T(3), 4}; });
  }
  expectRefused("options", [](Arguments& a) { a.options.balance = Balance::Face; });
  expectRefused("options", [](Arguments& a) { a.options.cutWeight = 2; });
  expectRefused("solids", [](Arguments& a) { a.radius = T(0.9); });
  expectRefused("domains", [](Arguments& a) {
    a.domain = OctreeDomain<T>(a.domain.origin(), a.domain.spacing() / 2, a.domain.roots());
  });
}

/// Fails for points on one side on the last rank only, as if it ran out of memory.
template <typename T>
class Failing final : public SignedDistanceFunction<T> {
 private:
  T localSignedDistance(const Vec3<T>& p) const override {
    if (p.x > T(0.4) && ownRank() == rankCount() - 1) throw std::bad_alloc();
    return length(p) - T(0.7);
  }
};

TYPED_TEST(DistributedOctreeTest, FailureOfOneRankReachesAll) {
  using T = TypeParam;
  // Enough roots for the last rank to have some on that side at once, or after some levels.
  for (const Index3 roots : {Index3{4, 4, 5}, Index3{1, 1, 1}}) {
    const OctreeDomain<T> cubes({T(-1), T(-1), T(-1)}, roots.i == 1 ? T(2) : T(0.5), roots);
    expectAgreedError(ErrorKind::Limit, [&] {
      const DistributedOctree<T> mesh(Failing<T>(), cubes, {.cut = 4}, MPI_COMM_WORLD);
    });
  }
}

#ifdef CUTWATER_HULL
TEST(DistributedHullTest, IsTheOctreeAroundARealSurface) {
  const SharedGeometry<double> hull(CUTWATER_HULL, MPI_COMM_WORLD);
  const auto box = hull.mesh().boundingBox();
  const double width = maxComponent(box.size()) / 5;
  const OctreeDomain<double> domain(box.center() - Vec3<double>{3.3, 1.4, 1.2} * width, width,
                                    {7, 3, 3});
  const Refinement<double> rules{.cut = 4,
                                 .bands = {{width / 10, 3}},
                                 .edges = Refinement<double>::Angle{.degrees = 40, .level = 5}};
  const DistributedOctree<double> mesh(hull.mesh(), domain, rules, MPI_COMM_WORLD,
                                       {.cutWeight = 4, .threads = 1});
  Values<double> values(mesh.local().cells().size());
  fill(hull.mesh(), mesh.local(), values.targets(), {.threads = 1});
  const auto cells = gathered(mesh.local().cells());
  const auto sum = mesh.checksum(values.targets());
  const auto forest = mesh.forestChecksum();
  if (ownRank() != 0) return;
  const Octree<double> expected(hull.mesh(), domain, rules);
  EXPECT_TRUE(std::ranges::equal(cells, expected.cells()));
  Values<double> all(cells.size());
  fill(hull.mesh(), expected, all.targets());
  EXPECT_EQ(sum, checksum(expected, all.targets()));
  EXPECT_GT(expected.count(BoxClass::Cut), 2000U);
  std::printf("%zu cells, checksums: forest %08x, cells and values %016llx\n", cells.size(), forest,
              static_cast<unsigned long long>(sum));
}
#endif

}  // namespace
}  // namespace cutwater::test
