#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

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
    result.push_back(solid.distanceBounds(box, &hint).lower);
    solid.facetsIn(box, [&](const SurfaceFacet<T>&) {
      result.push_back(1);
      return result.size() % 16 != 0;
    });
    result.push_back(static_cast<T>(solid.owner(p).object));
    note(solid.boundingBox().lower);
    result.push_back(solid.guarantee().error(1));
  }
  return result;
}

template <typename T>
std::vector<T> batch(const SignedDistanceFunction<T>& solid) {
  RandomPoints<T> random(3);
  std::vector<Vec3<T>> points(kQueries);
  std::vector<Box<T>> boxes;
  for (auto& p : points) {
    p = random.next();
    boxes.push_back({p, p + Vec3<T>{T(0.1), T(0.2), T(0.3)}});
  }
  std::vector<T> result(points.size());
  solid.signedDistances(points, result);
  std::vector<SurfacePoint<T>> nearest(points.size());
  solid.closestPoints(points, nearest);
  std::vector<BoxClass> classes(points.size());
  std::vector<BoxHint> hints(points.size());
  solid.classify(boxes, classes, hints);
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back(nearest[i].point.x);
    result.push_back(static_cast<T>(classes[i]));
  }
  return result;
}

/// A mesh of each scheme of signs, with a tree and without, one seen in foreign memory, and what is
/// made of them, with a tree of operands too.
template <typename T>
std::vector<Solid<T>> solids() {
  const auto sphere = tessellation::icosphere(1.5, 2);
  auto open = sphere;
  open.patches.pop_back();
  open.offsets.pop_back();
  open.corners.resize(open.offsets.back());
  const MeshSDF<T> mesh(sphere);
  std::vector<Solid<T>> spheres;
  for (int i = 0; i < 40; ++i) {
    spheres.push_back(Sphere<T>({T(i % 4) - 2, T(i / 4 % 4) - 2, T(i / 16)}, T(0.3)));
  }
  return {(Sphere<T>({T(0.1), T(0.2), T(0.3)}, T(1.7)) | MeshSDF<T>(tetrahedron())) -
              Cylinder<T>({-2, 0, 0}, {2, 0, 0}, T(0.4)),
          MeshSDF<T>(open),
          DcelSDF<T>(DcelMesh<T>(sphere)),
          MeshSDF<T>::view(mesh.toBytes()),
          unionOf<T>(spheres) & mesh,
          smoothUnion(mesh, Torus<T>(2, T(0.5)), {.reach = T(0.3)})};
}

template <typename T>
class ThreadsTest : public ::testing::Test {};
TYPED_TEST_SUITE(ThreadsTest, Precisions);

template <typename T>
void expectSameFromAllThreads(const Solid<T>& solid) {
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

TYPED_TEST(ThreadsTest, ShareObjectsAndAgreeToTheBit) {
  using T = TypeParam;
  for (auto& solid : solids<T>()) {
    SCOPED_TRACE(solid.describe());
    solid.rotate(T(33), {1, 2, 3});
    expectSameFromAllThreads(solid);
  }
}

}  // namespace
}  // namespace cutwater::test
