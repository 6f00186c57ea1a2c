// Prints the answers to a few hundred queries, every number to the bit. The same source is built
// inside this repository and by projects that only use the library, with flags of their own; all
// must print the same. Its own arithmetic is therefore exact: no flag can change the questions.

#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/BoxFrame.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cone.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/InfiniteCone.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Polygon.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>
#include <Cutwater/Shapes/Revolution.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

namespace {

using namespace cutwater;  // NOLINT(google-build-using-namespace): as users may

/// Multiples of 1/64 between -4 and 4, the same ones on every machine (Knuth's MMIX generator).
template <typename T>
class Questions {
 public:
  T next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<T>(static_cast<int>(state_ >> 55U) - 256) * T(0.015625);
  }
  Vec3<T> point() {
    const T x = next();
    const T y = next();
    const T z = next();
    return {x, y, z};
  }
  Box<T> box() {
    const auto corner = point();
    Box<T> box{corner, corner};
    return box.extend(point());
  }

 private:
  std::uint64_t state_ = 1;
};

template <typename T>
void print(T value) {
  std::printf(" %a", static_cast<double>(value));
}

template <typename T>
void print(const Vec3<T>& v) {
  print(v.x);
  print(v.y);
  print(v.z);
}

template <typename T>
void printPoints(const SignedDistanceFunction<T>& solid, const std::vector<Vec3<T>>& points) {
  std::vector<T> batch(points.size());
  solid.signedDistances(points, batch);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& p = points[i];
    const auto hit = solid.closestPoint(p);
    std::printf("point");
    print(solid.signedDistance(p));
    print(batch[i]);
    print(solid.gradient(p));
    print(solid.normal(p, T(0.0078125)));
    print(hit.point);
    print(hit.normal);
    print(hit.tolerance);
    std::printf(" %d %u %u\n", static_cast<int>(hit.exact), hit.owner.object, hit.owner.face);
  }
}

template <typename T>
void printBoxesAndSegments(const SignedDistanceFunction<T>& solid, Questions<T>& questions) {
  for (int i = 0; i < 20; ++i) {
    const auto box = questions.box();
    const auto bounds = solid.bounds(box);
    std::printf("box %d", static_cast<int>(solid.classify(box)));
    print(bounds.lower);
    print(bounds.upper);
    std::printf("\nsegment");
    solid.crossings({box.lower, box.upper}, [](const Crossing<T>& crossing) {
      print(crossing.parameter);
      print(crossing.point);
      return true;
    });
    std::printf("\n");
  }
}

template <typename T>
void printAnswers(const char* name, const SignedDistanceFunction<T>& solid) {
  std::printf("%s in %zu bytes\n", name, sizeof(T));
  Questions<T> questions;
  std::vector<Vec3<T>> points(40);
  for (auto& p : points) p = questions.point();
  printPoints(solid, points);
  printBoxesAndSegments(solid, questions);
  print(solid.boundingBox().lower);
  print(solid.boundingBox().upper);
  std::printf("\n");
}

template <typename T>
void printLevel() {
  const Level<T> level({T(0.1), T(0.2), T(0.3)}, {T(0.1), T(0.01), T(0.7)});
  for (int i = -3; i < 4; ++i) print(level.position({i, 3 * i, 7 * i}));
  std::printf("\n");
}

/// A user's primitive, with a distance that no flag can change: sums of multiples of 1/64.
template <typename T>
struct Site {
  Vec3<T> position;

  Box<T> boundingBox() const { return {position, position}; }
  T distance(const Vec3<T>& p) const {
    const auto gap = abs(p - position);
    return gap.x + gap.y + gap.z;  // never less than the Euclidean distance
  }
};

template <typename T>
void printTree() {
  Questions<T> questions;
  std::vector<Site<T>> sites(500);
  for (auto& site : sites) site.position = questions.point();
  const LinearBVH<T, Site<T>> tree(std::move(sites));
  for (int i = 0; i < 50; ++i) {
    const auto nearest = tree.nearest(questions.point());
    std::printf("site %u", nearest.primitive);
    print(nearest.distance);
    std::array<typename LinearBVH<T, Site<T>>::Nearest, 5> five;
    const auto found = tree.nearest(questions.point(), five, T(0.75));
    for (const auto& one : std::span(five).first(found)) std::printf(" %u", one.primitive);
    std::printf("\n");
  }
}

template <typename T>
void printBeams() {
  Questions<T> questions;
  std::vector<CapsuleBeam<T>> beams;
  std::vector<Solid<T>> solids;
  for (int i = 0; i < 60; ++i) {
    const auto a = questions.point();
    const auto b = questions.point();
    beams.push_back({a, b, T(0.1)});
    solids.push_back(Capsule<T>(a, b, T(0.1)));
  }
  const LinearBVH<T, CapsuleBeam<T>> tree(std::move(beams));
  for (int i = 0; i < 50; ++i) {
    std::array<NearestPrimitive<T>, 5> five;
    for (const auto& one : std::span(five).first(tree.nearest(questions.point(), five))) {
      std::printf("beam %u", one.primitive);
      print(one.distance);
    }
    std::printf("\n");
  }
  printAnswers<T>("capsules", unionOf(solids));
}

template <typename T>
void printShapes() {
  const Vec3<T> a{T(0.1), T(-0.7), T(0.2)};
  const Vec3<T> b{T(1.3), T(0.9), T(-0.4)};
  const T r = T(0.6);
  printAnswers<T>("box frame", BoxFrame<T>({{-1, -1, -1}, {T(1.7), 1, 1}}, T(0.3)));
  printAnswers<T>("capped cone", CappedCone<T>(a, b, r, T(0.3)));
  printAnswers<T>("capped torus", CappedTorus<T>(T(1.1), r, T(120)));
  printAnswers<T>("capsule", Capsule<T>(a, b, r));
  printAnswers<T>("cone", Cone<T>(a, b, r));
  printAnswers<T>("cone-sphere", ConeSphere<T>(a, b, r, T(0.3)));
  printAnswers<T>("convex polyhedron", ConvexPolyhedron<T>({{a, {1, T(0.1), T(-0.2)}},
                                                            {-a, {-1, T(0.3), T(0.1)}},
                                                            {b, {T(0.1), 1, T(0.3)}},
                                                            {-b, {T(0.2), -1, T(0.1)}},
                                                            {{0, 0, 1}, {T(-0.1), T(0.2), 1}},
                                                            {{0, 0, -1}, {T(0.1), T(0.4), -1}}}));
  printAnswers<T>("cuboid", Cuboid<T>({T(-0.3), T(-0.7), T(-1.1)}, {T(0.9), T(1.3), T(0.1)}));
  printAnswers<T>("cylinder", Cylinder<T>(a, b, r));
  printAnswers<T>("ellipsoid", Ellipsoid<T>(a, {r, T(1.1), T(0.3)}));
  const Polygon<T> section({{T(0.1), -1}, {1, T(-0.9)}, {T(0.7), 1}, {T(0.3), T(0.2)}},
                           {{{T(0.3), T(-0.7)}, {T(0.6), T(-0.7)}, {T(0.5), T(-0.2)}}});
  printAnswers<T>("extrusion", Extrusion<T>(section, T(-0.3), T(1.1)));
  printAnswers<T>("hexagonal prism", HexagonalPrism<T>(T(1.1), r));
  printAnswers<T>("infinite cylinder", InfiniteCylinder<T>(a, b, r));
  printAnswers<T>("infinite cone", InfiniteCone<T>(a, b, T(33)));
  printAnswers<T>("link", Link<T>(T(1.1), r, T(0.3)));
  printAnswers<T>("octahedron", Octahedron<T>(r));
  printAnswers<T>("plane", Plane<T>(a, b));
  printAnswers<T>("pyramid", Pyramid<T>(T(1.1), r));
  printAnswers<T>("revolution", Revolution<T>(section, a, b));
  printAnswers<T>("rounded box", RoundedBox<T>({-1, -1, -1}, {T(1.7), 1, 1}, T(0.3)));
  printAnswers<T>("rounded cylinder", RoundedCylinder<T>(a, b, r, T(0.1)));
  printAnswers<T>("torus", Torus<T>(a, b, T(1.1), T(0.3)));
}

template <typename T>
void printComposites() {
  const Sphere<T> ball({0, 0, 0}, T(1.1));
  const Torus<T> ring({0, 0, 0}, {1, 2, 3}, T(1.7), T(0.3));
  const Cylinder<T> bore({T(-2.1), 0, 0}, {T(2.1), T(0.2), 0}, T(0.4));
  const Solid<T> body = (ball | ring) - bore;
  printAnswers<T>("body", body);
  printAnswers<T>("body and box", body & Cuboid<T>({-1, -1, -1}, {1, 2, 1}));
  printAnswers<T>("complement", ~scaled(offset(body, T(0.1)), T(0.7)));
}

/// A tetrahedron with a slanted needle of a face.
PolygonSoup tetrahedron() {
  PolygonSoup soup;
  soup.points = {{-1.1, -1, -0.9}, {1.3, -0.7, -1}, {0.1, 1.2, -1}, {-1, -0.9, 1.4}};
  using Triangle = std::array<std::uint32_t, 3>;
  for (const auto& triangle :
       {Triangle{0, 2, 1}, Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3}}) {
    soup.addPolygon(triangle);
  }
  soup.patchNames = {"all"};
  return soup;
}

template <typename T>
void printMeshes() {
  MeshSDF<T> mesh(tetrahedron());
  printAnswers<T>("mesh", mesh);
  mesh.rotate(T(33), {1, 2, 3}, {T(0.3), 0, 1});
  printAnswers<T>("turned mesh", mesh);
  printAnswers<T>("mesh without a tree", DcelSDF<T>(DcelMesh<T>(tetrahedron())));
}

template <typename T>
void printAll() {
  printLevel<T>();
  printTree<T>();
  printBeams<T>();
  printShapes<T>();
  printComposites<T>();
  printMeshes<T>();
  Sphere<T> sphere({T(0.1), T(0.2), T(0.3)}, T(1.7));
  printAnswers<T>("sphere", sphere);
  sphere.rotate(T(33), {1, 2, 3}, {T(0.3), 0, 1});
  printAnswers<T>("turned sphere", sphere);
  Solid<T> solid = sphere;
  solid.translate({1, T(-0.3), 0});
  solid.rotate(T(-71), 1);
  printAnswers<T>("moved solid", solid);
}

}  // namespace

int main() {
  printAll<float>();
  printAll<double>();
}
