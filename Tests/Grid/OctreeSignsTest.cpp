#include <Cutwater/Grid/Detail/OctreeSigns.hpp>

#include <mutex>
#include <set>
#include <tuple>

#include "Support/OctreeMeshes.hpp"
#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// A ball that remembers what it was asked.
template <typename T>
class Witness final : public SignedDistanceFunction<T> {
 public:
  using Place = std::tuple<T, T, T>;
  static Place placeOf(const Vec3<T>& p) { return {p.x, p.y, p.z}; }

  mutable std::mutex mutex;
  mutable std::multiset<Place> points;
  mutable std::multiset<std::pair<Place, Place>> edges;

 private:
  T localSignedDistance(const Vec3<T>& p) const override { return ball_.signedDistance(p); }
  void localSignedDistances(std::span<const Vec3<T>> p, std::span<T> distances) const override {
    const std::lock_guard lock(mutex);
    for (const auto& each : p) points.insert(placeOf(each));
    ball_.signedDistances(p, distances, {.threads = 1});
  }
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override {
    const std::lock_guard lock(mutex);
    edges.insert({placeOf(segment.start), placeOf(segment.end)});
    return ball_.crossings(segment, visit);
  }
  Guarantee<T> localGuarantee() const override { return ball_.guarantee(); }

  Sphere<T> ball_{{}, T(0.8)};
};

template <typename T>
class OctreeSignsTest : public ::testing::Test {
 protected:
  /// Against each cell by itself. Returns how many edges are crossed, and how many more than once.
  static std::pair<std::size_t, std::size_t> compare(const Solid<T>& solid, const Octree<T>& mesh) {
    detail::OctreeSigns<T> all(solid, mesh, {});
    std::pair<std::size_t, std::size_t> crossed{};
    for (int level = 0; level <= mesh.deepest(); ++level) {
      all.countCrossings(level, {});
      for (const auto n : all.cells(level)) {
        const auto box = mesh.box(mesh.cells()[n]);
        detail::CellSigns<T> signs;
        all.signs(std::span(&n, 1), std::span(&signs, 1));
        for (int i = 0; i < 8; ++i) {
          EXPECT_EQ(signs.isInside(i), solid.signedDistance(box.corner(i)) < 0);
        }
        for (std::size_t e = 0; e < 12; ++e) {
          const auto& edge = detail::kCellEdges[e];
          EXPECT_EQ(edge.to() - edge.from, 1 << edge.axis);
          const Segment<T> segment{box.corner(edge.from), box.corner(edge.to())};
          const auto found = solid.crossings(segment, [](const auto&) { return true; }).found;
          EXPECT_EQ(signs.crossings[e], std::min<std::size_t>(found, 2));
          crossed.first += found > 0 ? 1 : 0;
          crossed.second += found > 1 ? 1 : 0;
        }
      }
    }
    return crossed;
  }
};
TYPED_TEST_SUITE(OctreeSignsTest, Precisions);

TYPED_TEST(OctreeSignsTest, AreThoseOfEachCellByItself) {
  using T = TypeParam;
  const auto [crossed, twice] = this->compare(ballAndPlate<T>(), ballAndPlateMesh<T>(2));
  EXPECT_GT(crossed, 500U);
  EXPECT_GT(twice, 100U);
}

TYPED_TEST(OctreeSignsTest, OnSeveralLevelsThatTheSurfaceMeets) {
  using T = TypeParam;
  const auto solid = ballAndPlate<T>();
  const OctreeDomain<T> domain({T(-1.3), T(-1.2), T(-1.25)}, T(0.6), {4, 4, 5});
  const Octree<T> mesh(solid, domain, {.cut = 1, .patches = {{1, 3}}}, {.balance = Balance::None});
  std::set<int> levels;
  for (const auto& cell : mesh.cells()) {
    if (mayBeCut(cell.kind)) levels.insert(cell.level);
  }
  EXPECT_GT(levels.size(), 2U);
  EXPECT_GT(this->compare(solid, mesh).second, 100U);
}

TYPED_TEST(OctreeSignsTest, AskAboutEachCornerAndEdgeOnce) {
  using T = TypeParam;
  const Witness<T> ball;
  const Octree<T> mesh(ball, {{-1, -1, -1}, T(0.5), {4, 4, 4}}, {.cut = 3});
  ball.points.clear();
  ball.edges.clear();
  detail::OctreeSigns<T> signs(ball, mesh, {.threads = 3});
  std::set<typename Witness<T>::Place> corners;
  for (const auto n : signs.cells(3)) {
    for (int i = 0; i < 8; ++i) corners.insert(ball.placeOf(mesh.box(mesh.cells()[n]).corner(i)));
  }
  EXPECT_TRUE(std::ranges::equal(ball.points, corners));
  signs.countCrossings(3, {.threads = 3});
  EXPECT_GT(ball.edges.size(), 500U);
  const std::set<std::pair<typename Witness<T>::Place, typename Witness<T>::Place>> once(
      ball.edges.begin(), ball.edges.end());
  EXPECT_EQ(ball.edges.size(), once.size());
  // Most others are known to be free from the values at their ends.
  EXPECT_LT(ball.edges.size(), 2 * corners.size());
}

}  // namespace
}  // namespace cutwater::test
