#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/OctreeSigns.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <atomic>
#include <set>

#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class UnresolvedFeaturesTest : public ::testing::Test {
 protected:
  using Features = std::vector<UnresolvedFeature<T>>;

  [[nodiscard]] Features featuresOf(const Solid<T>& solid, int level) const {
    const Refinement<T> rules{.cut = level};
    return unresolvedFeatures(solid, Octree<T>(solid, domain, rules));
  }
  /// The cell of level 2 at (1, 1, 1) of the roots' ... is [0, 0.25]^3.
  const OctreeDomain<T> domain{{-1, -1, -1}, 1, {2, 2, 2}};
};
TYPED_TEST_SUITE(UnresolvedFeaturesTest, Precisions);

TYPED_TEST(UnresolvedFeaturesTest, ListEveryCellOfAPlateBetweenTheCorners) {
  using T = TypeParam;
  // A hundredth of a cell of level 4, which are 1/16 wide.
  const T thickness = T(0.01) / 16;
  const Solid<T> plate =
      Cuboid<T>({T(-0.8), T(-0.8), T(0.02)}, {T(0.8), T(0.8), T(0.02) + thickness});
  for (const bool isSlit : {false, true}) {
    const Solid<T> solid = isSlit ? ~plate : plate;
    const Octree<T> mesh(solid, this->domain, {.cut = 4});
    const auto features = unresolvedFeatures(solid, mesh);
    std::size_t met = 0;
    for (const auto& cell : mesh.cells()) met += mesh.box(cell).overlaps(plate.boundingBox());
    EXPECT_EQ(features.size(), met);
    EXPECT_GT(met, 500U);
    for (const auto& feature : features) {
      EXPECT_EQ(feature.kind, UnresolvedKind::Thin);
      EXPECT_EQ(feature.isSolid, !isSlit);
      EXPECT_NEAR(feature.depth, 0.01, 1e-3);  // at the rim across a corner
      EXPECT_EQ(feature.level, 11);            // 2^7 times finer
      EXPECT_NEAR(feature.point.z, T(0.02) + thickness / 2, thickness);
    }
  }
}

TYPED_TEST(UnresolvedFeaturesTest, TellABulgeFromAPlate) {
  using T = TypeParam;
  // The ball's cap reaches 0.03 into the cells above z = 0, around the middle of one's face.
  const auto features = this->featuresOf(Sphere<T>({T(0.125), T(0.125), T(-0.07)}, T(0.1)), 2);
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[1].kind, UnresolvedKind::Grazing);
  EXPECT_TRUE(features[1].isSolid);
  EXPECT_NEAR(features[1].depth, 0.03 / 0.25, 0.01);
  EXPECT_EQ(features[1].level, 2 + 4);
  // Most of it is below: no corner there sees it either.
  EXPECT_EQ(features[0].kind, UnresolvedKind::Grazing);
  EXPECT_GT(features[0].depth, 0.5);
}

TYPED_TEST(UnresolvedFeaturesTest, FindWhatLiesWithinACell) {
  using T = TypeParam;
  const auto features = this->featuresOf(Sphere<T>({T(0.11), T(0.13), T(0.12)}, T(0.01)), 2);
  ASSERT_EQ(features.size(), 1U);
  EXPECT_EQ(features[0].kind, UnresolvedKind::Thin);
  EXPECT_TRUE(features[0].isSolid);
  EXPECT_NEAR(features[0].depth, 0.02 / 0.25, 0.002);
}

TYPED_TEST(UnresolvedFeaturesTest, FindSeveralSheetsInACell) {
  using T = TypeParam;
  // Two walls with a narrow slit between: corners of cells are on both sides below the walls' end.
  const Solid<T> walls = Cuboid<T>({T(-0.6), T(-0.6), T(-0.6)}, {T(0.1), T(0.6), T(0.1)}) |
                         Cuboid<T>({T(0.11), T(-0.6), T(-0.6)}, {T(0.6), T(0.6), T(0.1)});
  const auto features = this->featuresOf(walls, 2);
  std::size_t multiCut = 0;
  for (const auto& feature : features) {
    EXPECT_FALSE(feature.isSolid);
    EXPECT_NEAR(feature.point.x, 0.105, 0.0051);
    multiCut += feature.kind == UnresolvedKind::MultiCut ? 1 : 0;
    EXPECT_NEAR(feature.depth, 0.01 / 0.25, 0.001);
  }
  EXPECT_GE(multiCut, 4U);
  EXPECT_GT(features.size(), multiCut);
}

/// Counts the segments that are searched.
template <typename T>
class CountedSegments final : public SignedDistanceFunction<T> {
 public:
  explicit CountedSegments(Solid<T> solid) : solid_(std::move(solid)) {}

  mutable std::atomic<std::size_t> segments{0};

 private:
  T localSignedDistance(const Vec3<T>& p) const override { return solid_.signedDistance(p); }
  Guarantee<T> localGuarantee() const override { return solid_.guarantee(); }
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override {
    ++segments;
    return solid_.crossings(segment, visit);
  }

  Solid<T> solid_;
};

TYPED_TEST(UnresolvedFeaturesTest, SearchEdgesBetweenSheetsOnce) {
  using T = TypeParam;
  // Between the nodes at 0 and 1/16: the top of a block, and a plate above it.
  const CountedSegments<T> solid(Cuboid<T>({-2, -2, -2}, {2, 2, T(0.01)}) |
                                 Cuboid<T>({-2, -2, T(0.03)}, {2, 2, T(0.045)}));
  const Octree<T> mesh(solid, this->domain, {.cut = 4});
  solid.segments = 0;
  detail::OctreeSigns<T>(solid, mesh, {}).countCrossings(4, {});
  const std::size_t edges = solid.segments;
  EXPECT_GT(edges, 1000U);
  solid.segments = 0;
  const auto features = unresolvedFeatures(solid, mesh);
  EXPECT_EQ(solid.segments, edges);
  EXPECT_EQ(features.size(), 32U * 32);
  for (const auto& feature : features) {
    EXPECT_EQ(feature.kind, UnresolvedKind::MultiCut);
    EXPECT_NEAR(feature.depth, 0.02 * 16, 1e-3);
    EXPECT_FALSE(feature.isSolid);
  }
}

TYPED_TEST(UnresolvedFeaturesTest, TellWhetherTheWidestStretchIsSolid) {
  using T = TypeParam;
  // Edges along x of the cells from x = 0 to 0.25 begin in a block and end in the fluid; between
  // are a slit and a wall, one of them wider than the other.
  for (const bool isWallWider : {false, true}) {
    const T wall = isWallWider ? T(0.05) : T(0.13);
    const Solid<T> solid = Cuboid<T>({T(-0.6), T(-0.6), T(-0.6)}, {T(0.03), T(0.6), T(0.6)}) |
                           Cuboid<T>({wall, T(-0.6), T(-0.6)}, {T(0.15), T(0.6), T(0.6)});
    for (const bool isTurned : {false, true}) {
      const auto features = this->featuresOf(isTurned ? ~solid : solid, 2);
      EXPECT_EQ(features.size(), 36U);  // from -0.75 to 0.75 along y and z
      for (const auto& feature : features) {
        EXPECT_EQ(feature.kind, UnresolvedKind::MultiCut);
        EXPECT_EQ(feature.isSolid, isWallWider != isTurned);
        EXPECT_NEAR(feature.depth, 0.1 / 0.25, 1e-5);
        EXPECT_NEAR(feature.point.x, isWallWider ? 0.1 : 0.08, 1e-5);
      }
    }
  }
}

TYPED_TEST(UnresolvedFeaturesTest, HaveNothingToSayOfWhatIsSmooth) {
  using T = TypeParam;
  EXPECT_TRUE(this->featuresOf(Cuboid<T>({T(-0.6), T(-0.6), T(-0.6)}, {T(0.6), T(0.6), T(0.6)}), 3)
                  .empty());
}

/// How often the sign changes along a box's edge from corner i, as far as samples tell.
template <typename T>
int changesAlong(const Solid<T>& solid, const Box<T>& box, int i, int axis) {
  int changes = 0;
  bool last = solid.signedDistance(box.corner(i)) < 0;
  for (int part = 1; part <= 24; ++part) {
    auto p = box.corner(i);
    p[axis] = box.lower[axis] + (box.upper[axis] - box.lower[axis]) * T(part) / 24;
    if (part == 24) p = box.corner(i | 1 << axis);
    const bool here = solid.signedDistance(p) < 0;
    changes += here != last ? 1 : 0;
    last = here;
  }
  return changes;
}

/// Whether corners do not tell what there is: an edge is crossed twice, or all of them agree and
/// the middle does not.
template <typename T>
bool isLostInCorners(const Solid<T>& solid, const Box<T>& box) {
  int inside = 0;
  for (int i = 0; i < 8; ++i) {
    inside += solid.signedDistance(box.corner(i)) < 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1) == 0 && changesAlong(solid, box, i, axis) > 1) return true;
    }
  }
  const bool agree = inside == 0 || inside == 8;
  return agree && (solid.signedDistance(box.center()) < 0) != (inside == 8);
}

TYPED_TEST(UnresolvedFeaturesTest, AreCompleteAgainstSamplesOfACell) {
  using T = TypeParam;
  Solid<T> solid = MeshSDF<T>(star(40));
  const auto size = solid.boundingBox().size();
  solid = scaled(solid, T(1.5) / maxComponent(size));
  solid.translate(T(-1) * solid.boundingBox().center());
  solid.rotate(20, {1, 2, 3});
  const Octree<T> mesh(solid, this->domain, {.cut = 4});
  const auto features = unresolvedFeatures(solid, mesh);
  std::set<std::size_t> listed;
  for (const auto& feature : features) listed.insert(feature.cell);
  EXPECT_EQ(listed.size(), features.size());
  std::size_t found = 0;
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto& cell = mesh.cells()[n];
    if (cell.level < 4 || !isLostInCorners(solid, mesh.box(cell))) continue;
    EXPECT_TRUE(listed.contains(n));
    ++found;
  }
  EXPECT_GT(found, 20U);
}

TYPED_TEST(UnresolvedFeaturesTest, AreTheSameForAnyNumberOfThreads) {
  using T = TypeParam;
  const Solid<T> solid = Cuboid<T>({T(-0.8), T(-0.8), T(0.02)}, {T(0.8), T(0.8), T(0.03)});
  const Octree<T> mesh(solid, this->domain, {.cut = 4});
  const auto one = unresolvedFeatures(solid, mesh, {.threads = 1});
  const auto many = unresolvedFeatures(solid, mesh, {.threads = 3});
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].cell, many[i].cell);
    EXPECT_EQ(one[i].depth, many[i].depth);
  }
  EXPECT_THROW((void)unresolvedFeatures(solid, mesh, {.threads = -1}), Error);
}

}  // namespace
}  // namespace cutwater::test
