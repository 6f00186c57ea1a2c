#include <Cutwater/Sdf/Solid.hpp>

#include "DamageChecks.hpp"
#include "Support/GuaranteeCheck.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DamagedBoxesTest : public ::testing::Test {};
TYPED_TEST_SUITE(DamagedBoxesTest, Precisions);

/// Asks about many boxes, and about many points in each.
template <typename T>
class BoxCheck {
 public:
  BoxCheck(const MeshSDF<T>& mesh, bool isMoved) : oracle_(mesh), solid_(mesh) {
    if (isMoved) {
      solid_.rotate(31, {1, 2, -1});
      solid_.translate({T(0.5), -2, T(0.25)});
    }
    around_ = solid_.boundingBox();
    extent_ = double{maxComponent(around_.size())};
  }

  /// Half of the boxes anywhere, half at surface or at a sheet that closes a hole.
  void run(int count) {
    for (int i = 0; i < count; ++i) {
      const auto center = i % 2 == 0 ? anywhere() : whereTheSignChanges();
      const double size = extent_ * std::pow(10.0, uniform(-4.5, 0));
      Vec3<double> half{uniform(0, size), uniform(0, size), uniform(0, size)};
      if (i % 5 == 1) half[i % 3] = 0;
      if (i % 15 == 7) half = half[i % 3] * Vec3<double>{1, 0, 0};
      const Vec3<double> shift{uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
      const auto middle =
          center + Vec3<T>{static_cast<T>(shift.x * half.x), static_cast<T>(shift.y * half.y),
                           static_cast<T>(shift.z * half.z)};
      check({middle - Vec3<T>(half), middle + Vec3<T>(half)});
    }
    EXPECT_GT(cut_, count / 20);
    EXPECT_GT(decided_, count / 20);
  }

  /// The share of cubes of a 50th of the size that get an answer, of those `gap` sizes away from
  /// all triangles and from the sheets that close holes.
  [[nodiscard]] double decidedAwayFrom(double gap, int count) {
    int all = 0;
    int decided = 0;
    while (all < count) {
      const auto p = anywhere();
      if (std::abs(double{solid_.signedDistance(p)}) < gap * extent_ || isNearJump(p, gap))
        continue;
      const auto half = static_cast<T>(extent_ / 100);
      const Box<T> box{p - Vec3<T>{half, half, half}, p + Vec3<T>{half, half, half}};
      ++all;
      const auto kind = solid_.classify(box);
      if (kind == BoxClass::Inside || kind == BoxClass::Outside) ++decided;
      check(box);
    }
    return static_cast<double>(decided) / all;
  }

  /// Whether there is a point on the other side in the box, just behind a surface point that is
  /// nearest to one of its points: for boxes that the surface enters by little.
  [[nodiscard]] bool leadsAcross(const Box<T>& box, bool fromInside) {
    for (int i = 0; i < 2000; ++i) {
      const auto hit = solid_.closestPoint(within(box));
      for (const double step : {1e-6, 1e-5, 1e-4, 1e-3}) {
        const auto behind = static_cast<T>((fromInside ? step : -step) * extent_);
        const auto q = max(box.lower, min(box.upper, hit.point + behind * hit.normal));
        if ((solid_.signedDistance(q) < 0) != fromInside) return true;
      }
    }
    return false;
  }

  BoxClass check(const Box<T>& box) {
    const auto range = solid_.bounds(box);
    const auto kind = solid_.classify(box);
    int inside = 0;
    constexpr int kSamples = 200;
    for (int i = 0; i < kSamples; ++i) {
      const auto p = i == 8 ? box.center() : i < 8 ? box.corner(i) : within(box);
      const T value = solid_.signedDistance(p);
      if (value < 0) ++inside;
      bounds_.expect(range.contains(value), "value", value, "at", p, "not in", range.lower,
                     range.upper, "box", box.lower, box.upper);
      const bool isOpposite =
          (kind == BoxClass::Inside && !(value < 0)) || (kind == BoxClass::Outside && value < 0);
      classes_.expect(!isOpposite, "class", static_cast<int>(kind), "value", value, "at", p);
      if (i < 20) checkWinding(p, kind);
    }
    if (kind == BoxClass::Cut) {
      ++cut_;
      const bool hasBoth = (inside > 0 && inside < kSamples) || leadsAcross(box, inside > 0);
      classes_.expect(hasBoth, "cut, but", inside, "samples inside", "box", box.lower, box.upper);
    }
    if (kind == BoxClass::Inside || kind == BoxClass::Outside) ++decided_;
    return kind;
  }

 private:
  void checkWinding(const Vec3<T>& p, BoxClass kind) {
    if (kind != BoxClass::Inside && kind != BoxClass::Outside) return;
    const double winding = oracle_.at(solid_.placement().toLocal(p));
    // Rounded motions aside: to a threshold between 1/2 and a little more.
    const bool agrees = kind == BoxClass::Inside ? winding > 0.5 : winding < 0.5 + 1e-3;
    windings_.expect(agrees, "class", static_cast<int>(kind), "winding", winding, "at", p);
  }

  [[nodiscard]] bool isNearJump(const Vec3<T>& p, double gap) {
    for (int i = 0; i < 64; ++i) {
      const auto reach = static_cast<T>(gap * extent_);
      const Vec3<T> step{static_cast<T>(uniform(-1, 1)), static_cast<T>(uniform(-1, 1)),
                         static_cast<T>(uniform(-1, 1))};
      const auto q = p + reach * step;
      if ((solid_.signedDistance(p) < 0) != (solid_.signedDistance(q) < 0)) return true;
    }
    return false;
  }

  [[nodiscard]] double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine_);
  }
  [[nodiscard]] Vec3<T> within(const Box<T>& box) {
    Vec3<T> p;
    for (int axis = 0; axis < 3; ++axis) {
      const double t = uniform(0, 1);
      p[axis] = static_cast<T>((1 - t) * double{box.lower[axis]} + t * double{box.upper[axis]});
      p[axis] = std::clamp(p[axis], box.lower[axis], box.upper[axis]);
    }
    return p;
  }
  [[nodiscard]] Vec3<T> anywhere() { return within(around_.grown(static_cast<T>(0.1 * extent_))); }
  [[nodiscard]] Vec3<T> whereTheSignChanges() {
    auto p = anywhere();
    auto q = anywhere();
    const auto isInside = [this](const Vec3<T>& at) { return solid_.signedDistance(at) < 0; };
    for (int i = 0; i < 1000 && isInside(p) == isInside(q); ++i) q = anywhere();
    const bool wasInside = isInside(p);
    for (int i = 0; i < 24; ++i) {
      const auto middle = T(0.5) * (p + q);
      (isInside(middle) == wasInside ? p : q) = middle;
    }
    return p;
  }

  WindingOracle oracle_;
  Solid<T> solid_;
  Box<T> around_;
  double extent_;
  std::mt19937 engine_{5};
  int cut_ = 0;
  int decided_ = 0;
  Tally bounds_{"bounds of a box"};
  Tally classes_{"class of a box"};
  Tally windings_{"class of a box, by the winding number"};
};

template <typename T>
void expectBoxes(const PolygonSoup& soup) {
  const MeshSDF<T> mesh(soup);
  for (const bool isMoved : {false, true}) BoxCheck<T>(mesh, isMoved).run(scaled(100));
}

PolygonSoup sphereWithAHole() {
  return onlyFaces(sphere(), [](std::size_t i) { return i != 100; });
}

TYPED_TEST(DamagedBoxesTest, OfOpenMeshesAreRight) {
  using T = TypeParam;
  expectBoxes<T>(sphereWithAHole());
  expectBoxes<T>(bowl(16));
  expectBoxes<T>(jittered(unwelded(sphere(1)), 1e-5));
}

TYPED_TEST(DamagedBoxesTest, OfOverlappingAndNestedMeshesAreRight) {
  using T = TypeParam;
  expectBoxes<T>(together(sphere(), moved(sphere(), {0.9, 0.2, 0.1})));
  expectBoxes<T>(together(sphere(), withPoints(sphere(), [](const auto& p) { return 0.5 * p; })));
  expectBoxes<T>(together(plainBox({0, 0, 0}, {1, 1, 1}), plainBox({1, 0, 0}, {2, 1, 1})));
}

// Within an overlap the sign changes where another sheet becomes the nearest one.
TYPED_TEST(DamagedBoxesTest, OfOverlappingMeshesByTheNearestSheetAreRight) {
  using T = TypeParam;
  const auto soup =
      together(plainBox({0, 0, 0}, {1, 1, 1}), plainBox({0.5, 0.25, 0.25}, {2, 0.75, 0.75}));
  const MeshSDF<T> mesh(soup, {.signs = SignScheme::NearestFeature});
  EXPECT_FALSE(mesh.guarantee().continuous);
  EXPECT_FALSE(mesh.guarantee().lipschitz);
  EXPECT_EQ(mesh.guarantee().inside, Quality::SignOnly);
  BoxCheck<T> check(mesh, false);
  RandomPoints<T> random(T(0.3));
  for (int i = 0; i < scaled(100); ++i) {
    const auto p = Vec3<T>{T(0.75), T(0.5), T(0.5)} + random.next();
    const auto half = static_cast<T>(std::pow(0.5, 4 + i % 8));
    check.check({p - Vec3<T>{half, half, half}, p + Vec3<T>{half, half, half}});
  }
}

TYPED_TEST(DamagedBoxesTest, AwayFromOpenMeshesMostAreDecided) {
  using T = TypeParam;
  for (const auto& soup : {sphereWithAHole(), bowl(16)}) {
    const MeshSDF<T> mesh(soup);
    EXPECT_GT(BoxCheck<T>(mesh, false).decidedAwayFrom(0.1, scaled(200)), 0.8);
    EXPECT_GT(BoxCheck<T>(mesh, true).decidedAwayFrom(0.1, scaled(200)), 0.8);
  }
  const MeshSDF<T> cracked(jittered(unwelded(sphere()), 1e-6));
  EXPECT_GT(BoxCheck<T>(cracked, false).decidedAwayFrom(0.1, scaled(200)), 0.8);
}

TYPED_TEST(DamagedBoxesTest, TrianglesWithinAnOverlapAreNoSurface) {
  using T = TypeParam;
  // The overlap is [1, 2]^3; each cube below holds a piece of a face in it.
  const MeshSDF<T> mesh(together(plainBox({0, 0, 0}, {2, 2, 2}), plainBox({1, 1, 1}, {3, 3, 3})));
  BoxCheck<T> check(mesh, false);
  RandomPoints<T> random(T(0.25));
  for (int i = 0; i < scaled(100); ++i) {
    auto p = Vec3<T>{T(1.5), T(1.5), T(1.5)} + random.next();
    p[i % 3] = i % 2 == 0 ? T(1) : T(2);
    const auto half = static_cast<T>(std::pow(0.5, 3 + i % 17));
    const Box<T> box{p - Vec3<T>{half, half, half}, p + Vec3<T>{half, half, half}};
    // On those triangles the value is 0, which counts as outside: nothing can be proven.
    EXPECT_EQ(check.check(box), BoxClass::Unknown);
  }
}

/// A tetrahedron without a face.
template <typename T>
PolygonSoup tent(const std::array<Vec3<double>, 4>& corners) {
  PolygonSoup soup;
  soup.patchNames = {"tent"};
  for (const auto& p : corners) soup.points.emplace_back(Vec3<T>(p));
  for (const auto& face : {std::array{0U, 1U, 2U}, {2U, 1U, 3U}, {0U, 3U, 1U}}) {
    soup.addPolygon(face);
  }
  return soup;
}

// In both, an edge of the hole passes through the origin, where numbers are far closer to each
// other than the surface is large.

TYPED_TEST(DamagedBoxesTest, OfNeighbouringNumbersOnBothSidesOfASheetStayOpen) {
  using T = TypeParam;
  const MeshSDF<T> mesh(
      tent<T>({{{-0.072, 0, 0}, {0.553, -0.505, 0.128}, {0.432, 0, 0}, {0.306, 0.607, -0.463}}}));
  const auto isInside = [&](const Vec3<T>& p) { return mesh.signedDistance(p) < 0; };
  RandomPoints<T> random(T(0.01));
  int found = 0;
  for (int i = 0; i < scaled(2000); ++i) {
    auto p = random.next();
    auto q = random.next();
    const bool wasInside = isInside(p);
    if (wasInside == isInside(q)) continue;
    for (int k = 0; k < 100; ++k) {
      const auto middle = T(0.5) * p + T(0.5) * q;
      (isInside(middle) == wasInside ? p : q) = middle;
    }
    const Box<T> box{min(p, q), max(p, q)};
    const auto kind = mesh.classify(box);
    ASSERT_TRUE(kind == BoxClass::Cut || kind == BoxClass::Unknown) << p << q;
    const auto range = mesh.bounds(box);
    ASSERT_TRUE(range.contains(mesh.signedDistance(p)) && range.contains(mesh.signedDistance(q)));
    ++found;
  }
  EXPECT_GT(found, scaled(200));
}

TYPED_TEST(DamagedBoxesTest, BesideATriangleAreNotTakenToBeOnIt) {
  using T = TypeParam;
  // Distances are rounded relative to the surface: to 0 for many points here.
  const auto soup =
      tent<T>({{{0.596, 0, 0}, {0.0415, 0.154, 0.404}, {-0.589, 0, 0}, {0.414, 0.106, -0.228}}});
  const MeshSDF<T> mesh(soup);
  const MeshSDF<double> exact(soup);
  RandomPoints<double> random(1);
  int decided = 0;
  for (int i = 0; i < scaled(20000); ++i) {
    const auto u = random.next();
    const auto along =
        std::pow(10, -1 - 7 * std::abs(u.x)) * soup.points[1] + 0.05 * u.y * Vec3<double>{1, 0, 0};
    const Vec3<T> p(along + u.z * std::pow(10, -6 - 5 * std::abs(u.y)) * Vec3<double>{0, 1, -1});
    const auto kind = mesh.classify(Box<T>{p, p});
    const T value = mesh.signedDistance(p);
    if (kind == BoxClass::Inside || kind == BoxClass::Outside) {
      ++decided;
      ASSERT_EQ(kind == BoxClass::Inside, value < 0) << p;
      ASSERT_EQ(value < 0, exact.signedDistance(Vec3<double>(p)) < 0) << p;
    }
  }
  EXPECT_GT(decided, scaled(1000));
}

}  // namespace
}  // namespace cutwater::test
