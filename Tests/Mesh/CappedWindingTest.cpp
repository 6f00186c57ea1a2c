#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/SolidAngle.hpp>

#include <random>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Triangles as they are, not oriented, within [-1, 1]^3; and the sum of all their solid angles.
template <typename T>
class Pieces {
 public:
  explicit Pieces(const PolygonSoup& soup) {
    for (const auto& p : soup.points) positions_.emplace_back(p);
    const auto triangulatedSoup = triangulated(soup);
    std::vector<Box<double>> boxes;
    for (std::size_t i = 0; i < triangulatedSoup.polygonCount(); ++i) {
      const auto c = triangulatedSoup.polygon(i);
      triangles_.push_back({c[0], c[1], c[2]});
      Box<double> box;
      for (const auto v : c) box.extend(Vec3<double>(positions_[v]));
      surface_.box.extend(box);
      boxes.push_back(box);
    }
    surface_.positions = positions_;
    surface_.triangles = triangles_;
    tree_ = buildBvh<16, 4>(boxes);
    BlockWriter writer;
    const auto edges = findOpenEdges(triangles_, positions_.size());
    const CappedWindingArrays data(std::span<const Vec3<T>>(positions_), edges);
    reach_ = data.reach();
    const auto sections = data.addTo(writer);
    block_ = writer.finish();
    winding_ = sections.view(block_);
  }

  double plainSum(const Vec3<double>& p) const {
    SolidAngleSum sum(p);
    for (std::uint32_t id = 0; id < triangles_.size(); ++id) sum.add(surface_.corners(id));
    return sum.turns();
  }
  auto estimate(const Vec3<double>& p, double tolerance) const {
    return winding_.estimate(surface_, along(), p, tolerance);
  }
  double reach() const { return reach_; }
  bool isInside(const Vec3<double>& p) const { return winding_.isInside(surface_, along(), p); }

 private:
  auto along() const {
    return [tree = tree_.tree()](const Segment<double>& segment, TriangleVisitor visit) {
      tree.along(segment, visit);
    };
  }

  std::vector<Vec3<T>> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  TriangleSurface<T> surface_;
  BvhArrays<16, 4> tree_;
  Block block_;
  CappedWinding winding_;
  double reach_ = 0;
};

template <typename T>
class CappedWindingTest : public ::testing::Test {};
TYPED_TEST_SUITE(CappedWindingTest, Precisions);

PolygonSoup without(PolygonSoup soup, std::size_t polygons) {
  soup.offsets.resize(soup.offsets.size() - polygons);
  soup.corners.resize(soup.offsets.back());
  soup.patches.resize(soup.patches.size() - polygons);
  return soup;
}

PolygonSoup randomTriangles(std::size_t count, unsigned seed) {
  RandomPoints<double> random(1, seed);
  PolygonSoup soup;
  soup.patchNames = {"all"};
  for (std::uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) soup.points.push_back(random.next());
    soup.addPolygon(std::array{3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

TYPED_TEST(CappedWindingTest, IsTheSumOfAllSolidAngles) {
  const PolygonSoup soups[] = {
      without(tessellation::icosphere(1, 3), 1),
      without(tessellation::icosphere(1, 3), 300),
      without(tessellation::torus(0.7, 0.3, 40, 20), 5),
      randomTriangles(60, 4),
      randomTriangles(2, 5),
      together(without(tessellation::icosphere(0.5, 2), 7), randomTriangles(20, 6)),
  };
  for (const auto& soup : soups) {
    const Pieces<TypeParam> pieces(soup);
    RandomPoints<double> random(1.2, 9);
    for (int i = 0; i < scaled(500); ++i) {
      const auto p = random.next();
      const double expected = pieces.plainSum(p);
      for (const double tolerance : {0.1, 1e-3, 1e-9}) {
        const auto found = pieces.estimate(p, tolerance);
        ASSERT_LE(std::abs(found.value - expected), found.error + 1e-11) << p;
        ASSERT_LE(found.error, tolerance);
      }
      if (std::abs(expected - CappedWinding::kThreshold) > 1e-9) {
        ASSERT_EQ(pieces.isInside(p), expected > CappedWinding::kThreshold) << p;
      }
    }
  }
}

TYPED_TEST(CappedWindingTest, NothingIsInsideBeyondItsReach) {
  // Bowls one in the other: their winding numbers add up to more than a half outside of their box.
  auto bowls = without(tessellation::box({-1, -1, -1}, {1, 1, 0}), 1);
  for (int i = 1; i < 8; ++i)
    bowls = together(bowls, without(tessellation::box({-1, -1, -1}, {1, 1, 0}), 1));
  const Pieces<TypeParam> pieces(bowls);
  EXPECT_TRUE(pieces.isInside({0, 0, 0.5}));
  const double reach = pieces.reach();
  EXPECT_FALSE(pieces.isInside({0, 0, reach}));
  EXPECT_GT(reach, 1);
}

TYPED_TEST(CappedWindingTest, HoldsInThePlanesOfCaps) {
  // A box without lid: the plane of its hole, its walls' planes, and the edges themselves.
  const Pieces<TypeParam> tray(without(tessellation::box({-1, -1, -1}, {1, 1, 0.5}, 4), 16));
  for (int i = -10; i <= 10; ++i) {
    for (int j = -10; j <= 10; ++j) {
      for (const double z : {-0.5, 0.5, 0.75}) {
        const Vec3<double> p{0.125 * i, 0.125 * j, z};
        if ((std::abs(i) == 8 || std::abs(j) == 8) && z <= 0.5) continue;  // on a wall
        EXPECT_NEAR(tray.estimate(p, 1e-9).value, tray.plainSum(p), 1e-9) << p;
        // Exactly half where the lid would be, which counts as outside.
        EXPECT_EQ(tray.isInside(p), std::abs(i) < 8 && std::abs(j) < 8 && z < 0.5) << p;
      }
    }
  }
}

}  // namespace
}  // namespace cutwater::test
