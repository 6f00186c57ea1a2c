#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class OctreeTest : public ::testing::Test {
 protected:
  static Solid<T> ball() {
    Solid<T> solid = MeshSDF<T>(tessellation::icosphere(0.8, 3));
    solid.rotate(20, {1, 2, 3});
    return solid;
  }
  /// Less than a hundredth of the finest cell, between its faces.
  /// Two of its sides are planes of the grid, or within rounding of them.
  static Box<T> plateBox() { return {{-1, -1, T(0.0401)}, {T(0.5), 1, T(0.0402)}}; }
  static Solid<T> plate() { return Cuboid<T>(plateBox()); }

  /// Checks that the cells fill the domain without overlap, in order.
  static void expectTiling(const Octree<T>& mesh) {
    const int deepest = mesh.deepest();
    std::vector<bool> covered(mesh.domain().indices(deepest).count());
    detail::MortonCode last = 0;
    for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
      const auto& [index, level, kind] = mesh.cells()[n];
      const auto code = detail::mortonCode(index) << 3 * (deepest - level);
      ASSERT_TRUE(n == 0 || last < code);
      last = code;
      forEachFine(mesh, mesh.cells()[n], [&](std::size_t place) {
        ASSERT_FALSE(covered[place]);
        covered[place] = true;
      });
    }
    EXPECT_TRUE(std::ranges::all_of(covered, std::identity{}));
  }
  /// Calls visit(place) for the finest level's cells within one.
  template <typename Visit>
  static void forEachFine(const Octree<T>& mesh, const OctreeCell& cell, const Visit& visit) {
    const auto all = mesh.domain().indices(mesh.deepest());
    const int shift = mesh.deepest() - cell.level;
    const std::int32_t width = 1 << shift;
    const Index3 lo{cell.index.i << shift, cell.index.j << shift, cell.index.k << shift};
    forEachIndex({lo, {lo.i + width - 1, lo.j + width - 1, lo.k + width - 1}},
                 [&](const Index3& i) {
                   visit(static_cast<std::size_t>(i.i) +
                         all.length(0) * (static_cast<std::size_t>(i.j) +
                                          all.length(1) * static_cast<std::size_t>(i.k)));
                 });
  }

  const OctreeDomain<T> domain{{T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5}};
};
TYPED_TEST_SUITE(OctreeTest, Precisions);

TYPED_TEST(OctreeTest, CoversTheDomainOnceInOrder) {
  for (const auto balance : {Balance::None, Balance::Corner}) {
    this->expectTiling({this->ball(), this->domain, {.cut = 3}, {.balance = balance}});
  }
}

TYPED_TEST(OctreeTest, HasCellsOfTheKindThatClassifyTells) {
  using T = TypeParam;
  const auto solid = this->ball() | this->plate();
  const Octree<T> mesh(solid, this->domain, {.cut = 4});
  std::array<std::size_t, 4> counts{};
  for (const auto& cell : mesh.cells()) {
    EXPECT_EQ(cell.kind, solid.classify(mesh.box(cell)));
    ++counts[static_cast<std::size_t>(cell.kind)];
  }
  for (const auto kind : {BoxClass::Inside, BoxClass::Outside, BoxClass::Cut, BoxClass::Unknown}) {
    EXPECT_EQ(mesh.count(kind), counts[static_cast<std::size_t>(kind)]);
  }
}

TYPED_TEST(OctreeTest, DividesWhatMayBeCutAndNothingElseUnlessBalanced) {
  using T = TypeParam;
  const auto solid = this->ball() | this->plate();
  const Octree<T> mesh(solid, this->domain, {.cut = 4}, {.balance = Balance::None});
  std::size_t cut = 0;
  for (const auto& cell : mesh.cells()) {
    cut += mayBeCut(cell.kind) ? 1 : 0;
    EXPECT_TRUE(!mayBeCut(cell.kind) || cell.level == 4);
    if (cell.level == 0) continue;
    const Index3 parent{cell.index.i / 2, cell.index.j / 2, cell.index.k / 2};
    const auto around = solid.classify(this->domain.level(cell.level - 1).cell(parent));
    EXPECT_TRUE(around == BoxClass::Cut || around == BoxClass::Unknown);
  }
  EXPECT_GT(cut, 1000U);
}

TYPED_TEST(OctreeTest, LosesNoPartOfAPlateThatCornersDoNotSee) {
  using T = TypeParam;
  const auto plate = this->plate();
  const Octree<T> mesh(plate, this->domain, {.cut = 4});
  const auto extent = this->plateBox();
  std::size_t crossed = 0;
  std::size_t seenByCorners = 0;
  for (const auto& cell : mesh.cells()) {
    const auto box = mesh.box(cell);
    if (!box.overlaps(extent)) continue;
    EXPECT_EQ(cell.level, 4);
    EXPECT_TRUE(cell.kind == BoxClass::Cut || cell.kind == BoxClass::Unknown);
    ++crossed;
    int inside = 0;
    for (int i = 0; i < 8; ++i) inside += plate.signedDistance(box.corner(i)) < 0 ? 1 : 0;
    seenByCorners += inside != 0 && inside != 8 ? 1 : 0;
  }
  EXPECT_EQ(crossed, mesh.count(BoxClass::Cut) + mesh.count(BoxClass::Unknown));
  EXPECT_GT(crossed, 2000U);
  EXPECT_EQ(seenByCorners, 0U);  // the control
}

TYPED_TEST(OctreeTest, FindsTheCellThatHoldsAPoint) {
  using T = TypeParam;
  const Octree<T> mesh(this->ball(), this->domain, {.cut = 5});
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto box = mesh.box(mesh.cells()[n]);
    EXPECT_EQ(mesh.find(box.lower), n);
    // The last point before the upper corner.
    auto last = box.upper;
    for (int axis = 0; axis < 3; ++axis) {
      last[axis] = std::nextafter(last[axis], -std::numeric_limits<T>::infinity());
    }
    EXPECT_EQ(mesh.find(last), n);
  }
  const auto whole = mesh.domain().box();
  EXPECT_FALSE(mesh.find(whole.upper));
  for (int axis = 0; axis < 3; ++axis) {
    for (const T wrong : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(),
                          std::numeric_limits<T>::max(), T(-1e6)}) {
      auto point = whole.center();
      point[axis] = wrong;
      EXPECT_FALSE(mesh.find(point));
    }
  }
}

TYPED_TEST(OctreeTest, RefinesABandAroundTheSurface) {
  using T = TypeParam;
  const Vec3<T> center{T(0.1), 0, T(0.2)};
  const Solid<T> solid = Sphere<T>(center, T(0.7));
  const Refinement<T> rules{.cut = 2, .bands = {{T(0.2), 4}, {T(0.45), 3}}};
  const Octree<T> mesh(solid, this->domain, rules, {.balance = Balance::None});
  // The least distance between a cell and the sphere, from the corners and the nearest point.
  const auto gap = [&](const Box<T>& box) {
    T most = 0;
    for (int i = 0; i < 8; ++i) most = std::max(most, length(box.corner(i) - center));
    const T least = length(max(box.lower - center, max(center - box.upper, Vec3<T>{})));
    return std::max({least - T(0.7), T(0.7) - most, T(0)});
  };
  const T error = 32 * std::numeric_limits<T>::epsilon();
  std::array<std::size_t, 5> counts{};
  for (const auto& cell : mesh.cells()) {
    ++counts[cell.level];
    const T distance = gap(mesh.box(cell));
    if (cell.level < 4) {
      EXPECT_GT(distance, T(0.2) - error);
    }
    if (cell.level < 3) {
      EXPECT_GT(distance, T(0.45) - error);
    }
    if (cell.level == 0) continue;
    const Index3 parent{cell.index.i / 2, cell.index.j / 2, cell.index.k / 2};
    const T reach = cell.level == 4 ? T(0.2) : T(0.45);
    EXPECT_LE(gap(this->domain.level(cell.level - 1).cell(parent)), reach + error);
  }
  EXPECT_GT(counts[2], 0U);
  EXPECT_GT(counts[3], 0U);
  EXPECT_GT(counts[4], 10 * counts[3] / 8);
}

TYPED_TEST(OctreeTest, IsTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  const auto solid = this->ball() | this->plate();
  const Refinement<T> rules{.cut = 5, .bands = {{T(0.2), 3}}};
  const Octree<T> one(solid, this->domain, rules, {.threads = 1});
  for (const int threads : {2, 5}) {
    const Octree<T> mesh(solid, this->domain, rules, {.threads = threads});
    EXPECT_TRUE(std::ranges::equal(one.cells(), mesh.cells()));
  }
}

TYPED_TEST(OctreeTest, FindsCellsByIndexAndByPoint) {
  using T = TypeParam;
  const Octree<T> mesh(this->ball(), this->domain, {.cut = 3});
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto& cell = mesh.cells()[n];
    EXPECT_EQ(mesh.find(cell.index, cell.level), n);
    EXPECT_EQ(mesh.find(mesh.center(cell)), n);
    const Index3 finer{8 * cell.index.i + 5, 8 * cell.index.j, 8 * cell.index.k + 7};
    EXPECT_EQ(mesh.find(finer, cell.level + 3), n);
  }
  EXPECT_EQ(mesh.find({0, 0, 0}, 0), 0U);
  const auto all = this->domain.indices(2);
  EXPECT_FALSE(mesh.find({-1, 0, 0}, 2));
  EXPECT_FALSE(mesh.find({0, all.hi.j + 1, 0}, 2));
  EXPECT_FALSE(mesh.find(this->domain.box().upper + Vec3<T>{0, 0, T(0.1)}));
  EXPECT_FALSE(mesh.find({0, std::numeric_limits<T>::quiet_NaN(), 0}));
  EXPECT_FALSE(mesh.find({0, 0, -std::numeric_limits<T>::infinity()}));
}

TYPED_TEST(OctreeTest, TellsItsProgress) {
  using T = TypeParam;
  double last = 0;
  const Octree<T> mesh(this->ball(), this->domain, {.cut = 4}, {.progress = [&](double fraction) {
                         EXPECT_GE(fraction, last);
                         EXPECT_LE(fraction, 1);
                         last = fraction;
                       }});
  EXPECT_GT(last, 0.9);
}

TYPED_TEST(OctreeTest, RefusesWhatCannotBe) {
  using T = TypeParam;
  const auto make = [this](const Refinement<T>& rules) {
    return Octree<T>(this->plate(), this->domain, rules);
  };
  EXPECT_THROW(make({.cut = -1}), Error);
  EXPECT_THROW(make({.cut = 19}), Error);
  EXPECT_THROW(make({.bands = {{T(-1), 1}}}), Error);
  EXPECT_THROW(make({.bands = {{T(1), -1}}}), Error);
  EXPECT_THROW(make({.bands = {{std::numeric_limits<T>::infinity(), 1}}}), Error);
}

}  // namespace
}  // namespace cutwater::test
