#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// Two thousandths thick, and turned against the axes.
PolygonSoup thinPlate() {
  return withPoints(cube(), [](const Vec3<double>& p) {
    const Vec3<double> q{p.x - 0.5, p.y - 0.5, 0.002 * (p.z - 0.5)};
    return Vec3<double>{0.8 * q.x - 0.6 * q.z, q.y, 0.6 * q.x + 0.8 * q.z};
  });
}
PolygonSoup needle() {
  return withPoints(tetrahedron(), [](const Vec3<double>& p) {
    return Vec3<double>{1e-4 * p.x, 1e-4 * p.y, 0.9 * p.z - 0.45} +
           0.1 * p.z * Vec3<double>{1, 2, 0};
  });
}

template <typename T>
class MeshBoxesTest : public ::testing::Test {
 protected:
  static std::vector<PolygonSoup> surfaces() {
    return {cube(), thinPlate(), needle(), lPrism(), star(40)};
  }
  /// And those that are open, or cut through themselves.
  static std::vector<PolygonSoup> surfacesAndDamaged() {
    auto result = surfaces();
    auto lid = cube();
    lid.offsets.pop_back();
    lid.patches.pop_back();
    lid.corners.resize(lid.offsets.back());
    result.push_back(lid);
    const auto shifted = [](const Vec3<double>& p) { return p + Vec3<double>{0.4, 0.3, 0.2}; };
    result.push_back(together(cube(), withPoints(tetrahedron(), shifted)));
    return result;
  }
  static std::array<Box<T>, 8> octants(const Box<T>& box) {
    std::array<Box<T>, 8> result;
    const auto middle = box.center();
    for (int i = 0; i < 8; ++i) {
      result[static_cast<std::size_t>(i)] = Box<T>{middle, middle}.extend(box.corner(i));
    }
    return result;
  }
  static Box<T> around(const Box<T>& box) {
    const auto margin = T(0.2) * maxComponent(box.size());
    return box.grown(margin);
  }
};
TYPED_TEST_SUITE(MeshBoxesTest, Precisions);

TYPED_TEST(MeshBoxesTest, AreThoseOfTryingAllTriangles) {
  using T = TypeParam;
  for (const auto& soup : this->surfaces()) {
    MeshSDF<T> mesh(soup);
    DcelSDF<T> plain{DcelMesh<T>(soup)};
    for (const bool isMoved : {false, true}) {
      if (isMoved) {
        mesh.rotate(25, {1, 2, 3});
        mesh.translate({1, T(-0.5), 2});
        plain.setPlacement(mesh.placement());
      }
      const auto box = this->around(mesh.boundingBox());
      constexpr int kCells = 12;
      const auto h = box.size() / T(kCells);
      int cut = 0;
      for (int i = 0; i < kCells * kCells * kCells; ++i) {
        const Vec3<T> lower = box.lower + Vec3<T>{h.x * T(i % kCells), h.y * T(i / kCells % kCells),
                                                  h.z * T(i / kCells / kCells)};
        const Box<T> cell{lower, lower + h};
        const auto kind = mesh.classify(cell);
        ASSERT_EQ(kind, plain.classify(cell));
        // Triangles are left out whose bounds are a thousandth below the distance.
        const auto bounds = mesh.bounds(cell);
        const auto others = plain.bounds(cell);
        ASSERT_NEAR(bounds.lower, others.lower, 1e-3 * std::abs(others.lower));
        ASSERT_NEAR(bounds.upper, others.upper, 1e-3 * std::abs(others.upper));
        cut += kind == BoxClass::Cut;
      }
      EXPECT_GT(cut, kCells);
    }
  }
}

TYPED_TEST(MeshBoxesTest, LeaveNothingOpenButWhatTouches) {
  using T = TypeParam;
  for (const auto& soup : this->surfaces()) {
    MeshSDF<T> mesh(soup);
    mesh.rotate(25, {1, 2, 3});
    RandomPoints<T> points(1, 3);
    int open = 0;
    for (int i = 0; i < 5000; ++i) {
      const auto middle = points.next();
      const auto half = T(0.1) * abs(points.next());
      open += mesh.classify({middle - half, middle + half}) == BoxClass::Unknown ? 1 : 0;
    }
    EXPECT_EQ(open, 0);
  }
}

TYPED_TEST(MeshBoxesTest, DoNotLoseWhatNodesDoNotSee) {
  using T = TypeParam;
  for (const auto& soup : {thinPlate(), needle()}) {
    const MeshSDF<T> mesh(soup);
    const auto box = this->around(mesh.boundingBox());
    constexpr int kCells = 9;
    const auto h = box.size() / T(kCells);
    // Points of the surface, and the cells that they are in.
    RandomPoints<double> weights(1, 7);
    int unseen = 0;
    for (int i = 0; i < 3000; ++i) {
      const auto corners = mesh.triangle(static_cast<std::uint32_t>(i) %
                                         static_cast<std::uint32_t>(mesh.triangleCount()));
      const auto w = abs(weights.next());
      const double sum = w.x + w.y + w.z;
      const Vec3<T> p = static_cast<T>(w.x / sum) * corners[0] +
                        static_cast<T>(w.y / sum) * corners[1] +
                        static_cast<T>(w.z / sum) * corners[2];
      Vec3<T> lower;
      for (int axis = 0; axis < 3; ++axis) {
        lower[axis] = box.lower[axis] + h[axis] * std::floor((p[axis] - box.lower[axis]) / h[axis]);
      }
      const Box<T> cell = Box<T>{lower, lower + h}.extend(p);
      const auto kind = mesh.classify(cell);
      ASSERT_TRUE(kind == BoxClass::Cut || kind == BoxClass::Unknown);
      bool isSeen = false;
      for (int k = 0; k < 8; ++k) isSeen = isSeen || mesh.signedDistance(cell.corner(k)) < 0;
      unseen += isSeen ? 0 : 1;
    }
    EXPECT_GT(unseen, 2000);  // the control: sampling at nodes misses nearly all of it
  }
}

TYPED_TEST(MeshBoxesTest, AreTheSameWithHints) {
  using T = TypeParam;
  for (const auto& soup : this->surfacesAndDamaged()) {
    MeshSDF<T> mesh(soup);
    mesh.rotate(25, {1, 2, 3});
    int known = 0;
    const auto descend = [&](const auto& self, const Box<T>& box, BoxHint hint, int level) -> void {
      const auto kind = mesh.classify(box, &hint);
      ASSERT_EQ(kind, mesh.classify(box));
      known += hint.words[0] != 0 ? 1 : 0;
      if (level == 5) return;
      for (const auto& octant : this->octants(box)) self(self, octant, hint, level + 1);
    };
    descend(descend, this->around(mesh.boundingBox()), {}, 0);
    if (mesh.signReport().isClosed()) {
      EXPECT_GT(known, 1000);
    }
  }
}

TYPED_TEST(MeshBoxesTest, AreTheSameTogether) {
  using T = TypeParam;
  for (const auto& soup : this->surfacesAndDamaged()) {
    MeshSDF<T> mesh(soup);
    for (const bool isMoved : {false, true}) {
      if (isMoved) mesh.rotate(25, {1, 2, 3});
      std::vector<Box<T>> boxes{this->around(mesh.boundingBox())};
      std::vector<BoxHint> hints(1);
      for (int level = 0; level < 6; ++level) {
        std::vector<BoxClass> expected(boxes.size());
        std::vector<BoxClass> found(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) expected[i] = mesh.classify(boxes[i]);
        mesh.classify(std::span<const Box<T>>(boxes), std::span(found));
        ASSERT_EQ(found, expected);
        std::ranges::fill(found, BoxClass::Unknown);
        mesh.classify(std::span<const Box<T>>(boxes), std::span(found), std::span(hints));
        ASSERT_EQ(found, expected);
        std::vector<Box<T>> next;
        std::vector<BoxHint> above;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          // Most of those that are decided stay behind; that they are is learned with the others.
          if ((found[i] == BoxClass::Inside || found[i] == BoxClass::Outside) && i % 8 != 0)
            continue;
          for (const auto& octant : this->octants(boxes[i])) next.push_back(octant);
          above.insert(above.end(), 8, hints[i]);
        }
        boxes = std::move(next);
        hints = std::move(above);
      }
    }
  }
}

TYPED_TEST(MeshBoxesTest, BoundsAreTighterThanOneValueAllows) {
  using T = TypeParam;
  const MeshSDF<T> mesh(cube());
  // Above the middle of the top: what is known at the centre would leave 0 to 2 h (1 +- sqrt(3) /
  // 2).
  const T h = T(0.125);
  const Box<T> box{{T(0.5) - h, T(0.5) - h, 1 + h}, {T(0.5) + h, T(0.5) + h, 1 + 3 * h}};
  const auto range = mesh.bounds(box);
  EXPECT_NEAR(range.lower, h, 1e-4);
  EXPECT_GT(range.upper, 3 * h);
  EXPECT_LT(range.upper, T(3.4) * h);
  const auto inside = mesh.bounds({{T(0.4), T(0.4), T(0.7)}, {T(0.6), T(0.6), T(0.9)}});
  EXPECT_NEAR(inside.upper, -0.1, 1e-4);
}

TYPED_TEST(MeshBoxesTest, OfAllSizesAndFlatOnes) {
  using T = TypeParam;
  const MeshSDF<T> mesh(cube());
  const auto at = [](double x, double y, double z) { return Vec3<T>(Vec3<double>{x, y, z}); };
  EXPECT_EQ(mesh.classify({at(-1e6, -1e6, -1e6), at(1e6, 1e6, 1e6)}), BoxClass::Cut);
  // Squares of these overflow in single precision: nothing false is said.
  EXPECT_NE(mesh.classify({at(-1e30, -1e30, -1e30), at(1e30, 1e30, 1e30)}), BoxClass::Outside);
  EXPECT_NE(mesh.classify({at(-1e30, -1e30, -1e30), at(1e30, 1e30, 1e30)}), BoxClass::Inside);
  EXPECT_EQ(mesh.classify({at(1e6, 1e6, 1e6), at(2e6, 2e6, 2e6)}), BoxClass::Outside);
  EXPECT_NE(mesh.classify({at(1e30, 1e30, 1e30), at(2e30, 2e30, 2e30)}), BoxClass::Cut);
  EXPECT_NE(mesh.classify({at(1e30, 1e30, 1e30), at(2e30, 2e30, 2e30)}), BoxClass::Inside);
  // Flat ones cannot be met by an inward margin, but by points on both sides.
  EXPECT_EQ(mesh.classify({at(-1, -1, 0.5), at(0.5, 0.5, 0.5)}), BoxClass::Cut);
  EXPECT_EQ(mesh.classify({at(0.25, 0.25, 0.5), at(0.75, 0.75, 0.5)}), BoxClass::Inside);
  EXPECT_EQ(mesh.classify({at(0.5, 0.5, 0.5), at(0.5, 0.5, 0.5)}), BoxClass::Inside);
  EXPECT_EQ(mesh.classify({at(2, 2, 2), at(2, 2, 2)}), BoxClass::Outside);
  // In the surface.
  EXPECT_EQ(mesh.classify({at(0.25, 0.25, 1), at(0.75, 0.75, 1)}), BoxClass::Unknown);
}

}  // namespace
}  // namespace cutwater::test
