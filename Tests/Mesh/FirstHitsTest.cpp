#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <optional>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/SameCrossings.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FirstHitsTest : public ::testing::Test {
 protected:
  static std::vector<Segment<T>> segments(int count, T extent) {
    RandomPoints<T> random(extent, /*seed=*/7);
    std::vector<Segment<T>> result;
    for (int i = 0; i < scaled(count); ++i) result.push_back({random.next(), random.next()});
    return result;
  }
};
TYPED_TEST_SUITE(FirstHitsTest, Precisions);

/// The first parameter at which a segment meets a triangle, by one determinant after the other
/// (Moeller and Trumbore, "Fast, minimum storage ray-triangle intersection", 1997).
template <typename T>
std::optional<double> bruteForce(const PolygonSoup& soup, const Segment<T>& segment) {
  std::optional<double> first;
  const Vec3<double> start(segment.start);
  const Vec3<double> along = Vec3<double>(segment.end) - start;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    const auto a = soup.points[corners[0]];
    const auto ab = soup.points[corners[1]] - a;
    const auto ac = soup.points[corners[2]] - a;
    const auto p = cross(along, ac);
    const double determinant = dot(ab, p);
    const double u = dot(start - a, p) / determinant;
    const auto q = cross(start - a, ab);
    const double v = dot(along, q) / determinant;
    const double t = dot(ac, q) / determinant;
    if (u >= 0 && v >= 0 && u + v <= 1 && 0 <= t && t <= 1 && (!first || t < *first)) first = t;
  }
  return first;
}

TYPED_TEST(FirstHitsTest, AreThoseOfAllTriangles) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 3);
  const auto moved = withPoints(ball, [](const Vec3<double>& p) {
    return p + Vec3<double>{2.1, 0.2, 0.1};
  });
  const auto soup = together(ball, moved);
  const MeshSDF<T> mesh(soup);
  const auto segments = this->segments(400, T(3));
  std::vector<FirstHit<T>> hits(segments.size());
  mesh.firstHits(std::span<const Segment<T>>(segments), std::span(hits));
  int some = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto expected = bruteForce(soup, segments[i]);
    ASSERT_EQ(hits[i].found, expected.has_value()) << i;
    if (!expected) continue;
    ++some;
    ASSERT_NEAR(double{hits[i].crossing.parameter}, *expected, 1e-5) << i;
  }
  EXPECT_GT(some, 100);
}

TYPED_TEST(FirstHitsTest, AreTheFirstCrossings) {
  using T = TypeParam;
  const auto ball = tessellation::icosphere(1, 3);
  auto open = ball;
  open.offsets.resize(open.offsets.size() - 100);
  open.patches.resize(open.patches.size() - 100);
  open.corners.resize(open.offsets.back());
  const auto overlapping = together(ball, tessellation::box({0, 0, 0}, {1.2, 0.4, 0.4}));
  const auto segments = this->segments(150, T(1.5));
  const DcelSDF<T> plain{DcelMesh<T>(ball)};
  EXPECT_GT(expectSameCrossings<T>(plain, segments), 50U);
  for (const auto& soup : {ball, open, overlapping}) {
    MeshSDF<T> mesh(soup);
    EXPECT_GT(expectSameCrossings<T>(mesh, segments), 50U);
    mesh.rotate(T(12), {1, 2, 3});
    expectSameCrossings<T>(Solid<T>(mesh), segments, {.threads = 2});
  }
}

/// Along edges, through vertices, in faces.
TYPED_TEST(FirstHitsTest, OfALatticeAreTheFirstCrossings) {
  using T = TypeParam;
  const MeshSDF<T> boxes(together(tessellation::box({0, 0, 0}, {3, 3, 3}, 3),
                                  tessellation::box({4, 0, 0}, {6, 2, 4}, 2)));
  std::mt19937 engine(2);
  const auto lattice = [&] {
    return Vec3<T>{T(int(engine() % 9) - 1), T(int(engine() % 6) - 1), T(int(engine() % 6) - 1)};
  };
  std::vector<Segment<T>> segments;
  for (int i = 0; i < scaled(2000); ++i) segments.push_back({lattice(), lattice()});
  EXPECT_GT(expectSameCrossings<T>(boxes, segments), 500U);
}

}  // namespace
}  // namespace cutwater::test
