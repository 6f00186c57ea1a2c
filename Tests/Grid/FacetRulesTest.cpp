#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/FacetRules.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <numbers>
#include <random>

#include "Support/Precisions.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FacetRulesTest : public ::testing::Test {
 protected:
  static Solid<T> boxMesh(const Vec3<double>& lower, const Vec3<double>& upper) {
    return MeshSDF<T>(tessellation::box(lower, upper));
  }
  [[nodiscard]] Octree<T> meshOf(const Solid<T>& solid, const Refinement<T>& rules) const {
    return {solid, domain, rules, {.balance = Balance::None}};
  }
  /// Whether the box contains all of a coordinate's value on two axes and meets it on the third: an
  /// edge of the box of corners lower and upper.
  static bool meetsEdge(const Box<T>& cell, const Vec3<T>& lower, const Vec3<T>& upper) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int n = 0; n < 4; ++n) {
        Box<T> edge{lower, upper};
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        edge.lower[second] = edge.upper[second] = (n & 1) != 0 ? upper[second] : lower[second];
        edge.lower[third] = edge.upper[third] = (n & 2) != 0 ? upper[third] : lower[third];
        if (edge.overlaps(cell)) return true;
      }
    }
    return false;
  }

  // No face of a cell lies in one of the solids'.
  const OctreeDomain<T> domain{{T(-1.01), T(-1.03), T(-1.02)}, T(0.5), {4, 4, 4}};
};
TYPED_TEST_SUITE(FacetRulesTest, Precisions);

TYPED_TEST(FacetRulesTest, RefineEdges) {
  using T = TypeParam;
  const Vec3<T> lower{T(-0.6), T(-0.5), T(-0.4)};
  const Vec3<T> upper{T(0.6), T(0.5), T(0.4)};
  const auto solid = this->boxMesh(Vec3<double>(lower), Vec3<double>(upper));
  const auto mesh = this->meshOf(solid, {.cut = 1, .edges = typename Refinement<T>::Angle{60, 4}});
  std::size_t fine = 0;
  for (const auto& cell : mesh.cells()) {
    if (this->meetsEdge(mesh.box(cell), lower, upper)) {
      EXPECT_EQ(cell.level, 4);
    }
    if (cell.level < 2) continue;
    const Index3 parent{cell.index.i / 2, cell.index.j / 2, cell.index.k / 2};
    const auto around = this->domain.level(cell.level - 1).cell(parent);
    EXPECT_TRUE(this->meetsEdge(around, lower, upper));
    fine += cell.level == 4 ? 1 : 0;
  }
  EXPECT_GT(fine, 200U);
  // No edge bends by more than 90 degrees.
  const auto coarse =
      this->meshOf(solid, {.cut = 1, .edges = typename Refinement<T>::Angle{91, 4}});
  EXPECT_TRUE(std::ranges::all_of(coarse.cells(), [](const auto& c) { return c.level <= 1; }));
}

TYPED_TEST(FacetRulesTest, SeeNoEdgeInATriangleWithoutArea) {
  using T = TypeParam;
  using Angle = typename Refinement<T>::Angle;
  // A cube whose upper side is divided along a diagonal with a point in the middle of one half's
  // side of it, and whose front has one in the middle of one face's side of an edge.
  auto soup = cube();
  for (auto& p : soup.points) p = {p.x - 0.51, p.y - 0.52, p.z - 0.53};
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    soup.points.push_back(0.5 * (soup.points[a] + soup.points[b]));
  };
  PolygonSoup divided;
  middle(4, 7);
  middle(0, 1);
  divided.points = soup.points;
  divided.patchNames = soup.patchNames;
  using Corners = std::vector<std::uint32_t>;
  for (const auto& corners :
       {Corners{0, 4, 6, 2}, Corners{1, 3, 7, 5}, Corners{2, 6, 7, 3}, Corners{0, 2, 3, 1},
        Corners{4, 5, 7}, Corners{4, 8, 6}, Corners{8, 7, 6}, Corners{4, 7, 8},  //
        Corners{9, 1, 5}, Corners{9, 5, 4}, Corners{9, 4, 0}, Corners{0, 1, 9}}) {
    divided.addPolygon(corners);
  }
  const Solid<T> solid = MeshSDF<T>(divided);
  ASSERT_EQ(solid.guarantee().outside, Quality::Exact);
  const auto mesh = this->meshOf(solid, {.cut = 1, .edges = Angle{60, 4}});
  const auto without = this->boxMesh(soup.points[0], soup.points[7]);
  const auto expected = this->meshOf(without, {.cut = 1, .edges = Angle{60, 4}});
  const auto levelOf = [](const OctreeCell& c) { return std::pair(c.level, c.index.i); };
  EXPECT_TRUE(std::ranges::equal(mesh.cells(), expected.cells(), {}, levelOf, levelOf));
  EXPECT_GT(mesh.cells().size(), 1000U);
}

TYPED_TEST(FacetRulesTest, RefineWhereNormalsTurn) {
  using T = TypeParam;
  // A small ball and a large one: cells of the same width see normals turn differently.
  const auto solid = Solid<T>(MeshSDF<T>(tessellation::icosphere(0.8, 5)));
  const auto small =
      translated(Solid<T>(MeshSDF<T>(tessellation::icosphere(0.1, 4))), {T(0.8), T(0.8), T(0.8)});
  const auto mesh =
      this->meshOf(solid | small, {.cut = 1, .curvature = typename Refinement<T>::Angle{20, 5}});
  for (const auto& cell : mesh.cells()) {
    if (cell.kind != BoxClass::Cut && cell.kind != BoxClass::Unknown) continue;
    T turn = 0;
    std::vector<Vec3<T>> normals;
    (solid | small).facetsIn(mesh.box(cell), [&](const SurfaceFacet<T>& facet) {
      for (const auto& n : normals) turn = std::max(turn, length(n - facet.normal));
      normals.push_back(facet.normal);
      return true;
    });
    const T most = 2 * std::sin(T(10) * std::numbers::pi_v<T> / 180);
    if (cell.level < 5) {
      EXPECT_LE(turn, most);
    }
  }
  std::size_t finest = 0;
  for (const auto& cell : mesh.cells()) finest += cell.level == 5 ? 1 : 0;
  EXPECT_GT(finest, 0U);
  EXPECT_LT(finest, mesh.cells().size() / 2);
}

TYPED_TEST(FacetRulesTest, RefineGapsOrWalls) {
  using T = TypeParam;
  using Width = typename Refinement<T>::Width;
  // Two thick plates with a gap of 0.05; cells of level 0 are 0.5 wide.
  const auto two = this->boxMesh({-0.7, -0.7, -0.7}, {0.7, 0.7, -0.25}) |
                   this->boxMesh({-0.7, -0.7, -0.2}, {0.7, 0.7, 0.5});
  const auto finestOf = [&](const Octree<T>& mesh, T z) {
    return mesh.cells()[*mesh.find({T(0.02), T(0.03), z})].level;
  };
  // The first level on which three cells above the cell at `from` do not reach to `to`.
  const auto expected = [&](T from, T to) {
    for (int level = 1;; ++level) {
      const auto cells = this->domain.level(level);
      const auto w = cells.spacing().z;
      const auto k = static_cast<std::int32_t>(std::floor((from - cells.origin().z) / w));
      const auto cell = cells.cell({0, 0, k});
      const bool isNear = cell.lower.z - 3 * w <= to && to <= cell.upper.z + 3 * w;
      if (!isNear) return level;
    }
  };
  const auto gaps = this->meshOf(two, {.cut = 1, .gaps = Width{3, 7}});
  EXPECT_EQ(finestOf(gaps, T(-0.25)), expected(T(-0.25), T(-0.2)));
  EXPECT_EQ(finestOf(gaps, T(-0.2)), expected(T(-0.2), T(-0.25)));
  EXPECT_GE(expected(T(-0.2), T(-0.25)), 5);
  EXPECT_EQ(finestOf(gaps, T(0.5)), 1);  // the far side of a plate
  EXPECT_EQ(finestOf(gaps, T(-0.7)), 1);
  const auto walls = this->meshOf(two, {.cut = 1, .walls = Width{3, 7}});
  EXPECT_EQ(finestOf(walls, T(-0.25)), expected(T(-0.25), T(-0.7)));
  EXPECT_EQ(finestOf(walls, T(-0.7)), expected(T(-0.7), T(-0.25)));
  EXPECT_EQ(finestOf(walls, T(0.5)), expected(T(0.5), T(-0.2)));
  EXPECT_LT(expected(T(0.5), T(-0.2)), 3);
  // The complement has walls where this has gaps.
  const auto turned = this->meshOf(~two, {.cut = 1, .walls = Width{3, 7}});
  EXPECT_TRUE(std::ranges::equal(
      turned.cells(), gaps.cells(), {},
      [](const OctreeCell& c) { return std::pair(c.level, c.index.i); },
      [](const OctreeCell& c) { return std::pair(c.level, c.index.i); }));
}

TYPED_TEST(FacetRulesTest, TagCellsByThemselvesAsTogether) {
  using T = TypeParam;
  using Width = typename Refinement<T>::Width;
  using Facet = SurfaceFacet<T>;
  // A turned slab in a shell: gaps and walls of many widths; and a sphere, of which samples are
  // seen.
  const auto slab = rotated(this->boxMesh({-0.6, -0.5, -0.05}, {0.6, 0.5, 0.05}), T(30), {1, 2, 3});
  const auto inner = Solid<T>(MeshSDF<T>(tessellation::icosphere(0.75, 2)));
  const auto outer = Solid<T>(MeshSDF<T>(tessellation::icosphere(0.9, 2)));
  const auto isFacing = [](const Facet& a, const Facet& b, T least) {
    const auto isBehind = [&](const Facet& from, const Facet& of) {
      return std::ranges::any_of(from.corners, [&](const Vec3<T>& corner) {
        return dot(of.normal, corner - of.corners[0]) < -least;
      });
    };
    return dot(a.normal, b.normal) < T(-0.5) && isBehind(a, b) && isBehind(b, a);
  };
  const Refinement<T> rules{.walls = Width{T(1.5), 9}};
  for (const auto& solid : {(outer - inner) | slab, slab | Sphere<T>({0, 0, T(0.5)}, T(0.3))}) {
    const detail::CellTagger<T> tagger(solid, rules);
    constexpr int kFine = 3;
    const auto level = this->domain.level(kFine);
    std::vector<Box<T>> cells;
    for (std::int32_t n = 0; n < 32 * 32 * 32; n += 3) {
      cells.push_back(level.cell({n % 32, n / 32 % 32, n / 1024}));
    }
    std::vector<detail::CellTag> together(cells.size());
    std::size_t refined = 0;
    std::size_t kept = 0;
    for (std::size_t begin = 0; begin < cells.size(); begin += 200) {
      const auto count = std::min<std::size_t>(200, cells.size() - begin);
      std::vector<BoxHint> hints(count);
      tagger.tag(kFine, std::span(cells).subspan(begin, count), hints,
                 std::span(together).subspan(begin, count));
    }
    for (std::size_t n = 0; n < cells.size(); ++n) {
      BoxHint hint;
      detail::CellTag alone;
      tagger.tag(kFine, std::span(cells).subspan(n, 1), std::span(&hint, 1), std::span(&alone, 1));
      EXPECT_EQ(together[n].isRefined, alone.isRefined) << n;
      if (!mayBeCut(alone.kind)) continue;
      const T width = maxComponent(cells[n].size());
      std::vector<Facet> own;
      solid.facetsIn(cells[n], [&](const Facet& facet) {
        own.push_back(facet);
        return true;
      });
      bool expected = false;
      solid.facetsIn(cells[n].grown(T(1.5) * width), [&](const Facet& other) {
        for (const auto& facet : own) {
          expected = expected || isFacing(facet, other, T(0x1p-20) * width);
        }
        return true;
      });
      EXPECT_EQ(alone.isRefined, expected) << n;
      ++(expected ? refined : kept);
    }
    EXPECT_GT(refined, 100U);
    EXPECT_GT(kept, 50U);
  }
}

TYPED_TEST(FacetRulesTest, RefinePatches) {
  const auto left = named(this->boxMesh({-0.7, -0.7, -0.7}, {-0.2, 0.7, 0.7}), "left");
  const auto right = named(this->boxMesh({0.2, -0.7, -0.7}, {0.7, 0.7, 0.7}), "right");
  const auto solid = left | right;
  ASSERT_EQ(solid.patchNames()[1], "right");
  const auto mesh = this->meshOf(solid, {.cut = 2, .patches = {{1, 4}}});
  for (const auto& cell : mesh.cells()) {
    const bool meetsRight = right.classify(mesh.box(cell)) == BoxClass::Cut;
    const bool meetsLeft = left.classify(mesh.box(cell)) == BoxClass::Cut;
    if (meetsRight) {
      EXPECT_EQ(cell.level, 4);
    }
    if (meetsLeft && !meetsRight) {
      EXPECT_EQ(cell.level, 2);
    }
  }
}

TYPED_TEST(FacetRulesTest, RefuseWhatCannotBe) {
  using T = TypeParam;
  using Angle = typename Refinement<T>::Angle;
  using Width = typename Refinement<T>::Width;
  EXPECT_THROW((Refinement<T>{.patches = {{0, -1}}}.check()), Error);
  for (const T degrees : {T(0), T(180), std::numeric_limits<T>::quiet_NaN()}) {
    EXPECT_THROW((Refinement<T>{.curvature = Angle{degrees, 1}}.check()), Error);
    EXPECT_THROW((Refinement<T>{.edges = Angle{degrees, 1}}.check()), Error);
  }
  EXPECT_THROW((Refinement<T>{.gaps = Width{-1, 1}}.check()), Error);
  EXPECT_THROW((Refinement<T>{.walls = Width{1, -1}}.check()), Error);
  EXPECT_EQ((Refinement<T>{.cut = 2, .walls = Width{1, 5}}.deepest()), 5);
}

TYPED_TEST(FacetRulesTest, BoundHowFarDirectionsDiffer) {
  using T = TypeParam;
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  for (int n = 0; n < 500; ++n) {
    detail::DirectionSpread<T> spread;
    std::vector<Vec3<T>> directions;
    T most = 0;
    const Vec3<double> middle{normal(engine), normal(engine), normal(engine)};
    for (int i = 0; i < 2 + n % 5; ++i) {
      const Vec3<double> other{normal(engine), normal(engine), normal(engine)};
      const Vec3<T> direction(normalized(middle + 0.3 * other));
      for (const auto& d : directions) most = std::max(most, length(d - direction));
      directions.push_back(direction);
      spread.add(direction);
    }
    EXPECT_GE(spread.bound(), most * (1 - tolerance<T>(4)));
    EXPECT_LE(spread.bound(), T(1.13) * most);
  }
}

}  // namespace
}  // namespace cutwater::test
