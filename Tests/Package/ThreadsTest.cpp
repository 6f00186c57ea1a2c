#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <thread>
#include <vector>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

// Queries from many threads on the same objects: run under ThreadSanitizer by Scripts/test --all.

namespace cutwater::test {
namespace {

constexpr int kThreads = 8;
constexpr std::size_t kQueries = 500;

PolygonSoup tetrahedron() {
  PolygonSoup soup;
  soup.points = {{-2, -2, -2}, {2, -2, -2}, {0, 2, -2}, {0, 0, 2}};
  for (const auto& triangle :
       std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    soup.addPolygon(triangle);
  }
  soup.patchNames = {"all"};
  return soup;
}

/// Everything a caller may ask of a const object, as numbers to compare.
template <typename T>
std::vector<T> answers(const SignedDistanceFunction<T>& solid) {
  RandomPoints<T> points(3);
  std::vector<T> result;
  const auto note = [&](const Vec3<T>& v) { result.insert(result.end(), {v.x, v.y, v.z}); };
  for (std::size_t i = 0; i < kQueries; ++i) {
    const auto p = points.next();
    const auto q = points.next();
    result.push_back(solid.signedDistance(p));
    note(solid.gradient(p));
    note(solid.normal(p, T(1e-3)));
    note(solid.closestPoint(p).point);
    const Box<T> box{min(p, q), max(p, q)};
    BoxHint hint;
    result.push_back(solid.bounds(box, &hint).lower);
    result.push_back(static_cast<T>(solid.classify(box, &hint)));
    solid.crossings({p, q}, [&](const Crossing<T>& crossing) {
      result.push_back(crossing.parameter);
      return true;
    });
    note(solid.boundingBox().lower);
    result.push_back(solid.guarantee().error(1));
  }
  return result;
}

template <typename T>
std::vector<T> batch(const SignedDistanceFunction<T>& solid) {
  RandomPoints<T> random(3);
  std::vector<Vec3<T>> points(kQueries);
  for (auto& p : points) p = random.next();
  std::vector<T> distances(points.size());
  solid.signedDistances(points, distances);
  return distances;
}

template <typename T>
class ThreadsTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThreadsTest, Precisions);

TYPED_TEST(ThreadsTest, ShareObjectsAndAgreeToTheBit) {
  using T = TypeParam;
  Solid<T> solid = (Sphere<T>({T(0.1), T(0.2), T(0.3)}, T(1.7)) | MeshSDF<T>(tetrahedron())) -
                   Cylinder<T>({-2, 0, 0}, {2, 0, 0}, T(0.4));
  solid.rotate(T(33), {1, 2, 3});
  const auto expected = answers<T>(solid);
  const auto expectedBatch = batch<T>(solid);

  std::vector<std::vector<T>> found(kThreads);
  std::vector<std::vector<T>> foundBatch(kThreads);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < kThreads; ++i) {
      threads.emplace_back([&, i] {
        const Solid<T> copy = solid;  // copies share the expression; making them must be safe too
        found[i] = answers<T>(i % 2 == 0 ? solid : copy);
        foundBatch[i] = batch<T>(copy);
      });
    }
  }
  for (std::size_t i = 0; i < kThreads; ++i) {
    EXPECT_EQ(found[i], expected) << "thread " << i;
    EXPECT_EQ(foundBatch[i], expectedBatch) << "thread " << i;
  }
}

}  // namespace
}  // namespace cutwater::test
