// Two classes that users of EBGeometry write, ported: a mesh searched face by face, and the same
// mesh with a bounding volume hierarchy. The README beside this file says what changes and why.

#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <utility>

using cutwater::Box;
using cutwater::DcelMesh;
using cutwater::DcelSDF;
using cutwater::Guarantee;
using cutwater::MeshSDF;
using cutwater::PolygonSoup;
using cutwater::SignedDistanceFunction;
using cutwater::Vec3;

namespace {

// [DOCS
/// Without a tree: every query tries every face of the half-edge mesh.
class FaceByFace : public SignedDistanceFunction<double> {
 public:
  explicit FaceByFace(DcelMesh<double> mesh) : faces_(std::move(mesh)) {}

 private:
  double localSignedDistance(const Vec3<double>& p) const override {
    return faces_.signedDistance(p);  // p is in this shape's own frame already
  }
  Guarantee<double> localGuarantee() const override { return faces_.guarantee(); }
  Box<double> localBoundingBox() const override { return faces_.boundingBox(); }

  DcelSDF<double> faces_;
};
// DOCS]

/// With a tree: every query tries the few faces that can be nearest.
class WithTree : public SignedDistanceFunction<double> {
 public:
  explicit WithTree(const PolygonSoup& soup) : tree_(soup) {}

 private:
  double localSignedDistance(const Vec3<double>& p) const override {
    return tree_.signedDistance(p);
  }
  Guarantee<double> localGuarantee() const override { return tree_.guarantee(); }
  Box<double> localBoundingBox() const override { return tree_.boundingBox(); }

  MeshSDF<double> tree_;
};

/// The cube [0, 1]^3 as six squares, counter-clockwise seen from outside.
PolygonSoup unitCube() {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i) {
    soup.points.push_back(Box<double>{{0, 0, 0}, {1, 1, 1}}.corner(i));
  }
  using Square = std::array<std::uint32_t, 4>;
  for (const Square& square : {Square{0, 4, 6, 2}, Square{1, 3, 7, 5}, Square{0, 1, 5, 4},
                               Square{2, 6, 7, 3}, Square{0, 2, 3, 1}, Square{4, 5, 7, 6}}) {
    soup.addPolygon(square);
  }
  soup.patchNames = {"cube"};
  return soup;
}

void expect(bool ok, const char* what) {
  if (ok) return;
  std::printf("wrong: %s\n", what);
  std::exit(1);
}

}  // namespace

int main() {
  const auto soup = unitCube();
  FaceByFace plain{DcelMesh<double>(soup)};
  WithTree fast{soup};

  expect(plain.signedDistance({3, 0.5, 0.5}) == 2, "distance to a face");
  expect(plain.signedDistance({0.5, 0.5, 0.75}) == -0.25, "distance inside");

  // Motions act in call order: to [1, 2] along x, then about the z axis to [1, 2] along y.
  for (SignedDistanceFunction<double>* shape :
       {static_cast<SignedDistanceFunction<double>*>(&plain),
        static_cast<SignedDistanceFunction<double>*>(&fast)}) {
    shape->translate({1, 0, 0});
    shape->rotate(90, 2);
    expect(shape->signedDistance({-0.5, 1.5, 0.5}) == -0.5, "the moved cube's centre");
    expect(shape->signedDistance({-0.5, 4, 0.5}) == 2, "above the moved cube");
    expect(shape->signedDistance({0.5, 0.5, 0.5}) > 0, "the place it left");
  }

  const int n = 12;
  for (int i = 0; i < n * n * n; ++i) {
    const std::array<int, 3> step{i % n, i / n % n, i / (n * n)};
    const Vec3<double> p{-2 + 0.3 * step[0], -1 + 0.3 * step[1], -1 + 0.3 * step[2]};
    expect(plain.signedDistance(p) == fast.signedDistance(p), "with and without a tree");
  }
  std::printf("%d points: the same distances with and without a tree, to the bit\n", n * n * n);
}
