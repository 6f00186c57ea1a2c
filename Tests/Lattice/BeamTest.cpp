#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>

#include <algorithm>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Refusal.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class BeamTest : public ::testing::Test {
 protected:
  static constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
};
TYPED_TEST_SUITE(BeamTest, Precisions);

/// Makes beams and the shapes that they are to equal.
template <typename T>
struct Capsules {
  using Made = CapsuleBeam<T>;
  static Made beam(const Vec3<T>& a, const Vec3<T>& b, T r, T) { return {a, b, r}; }
  static Capsule<T> shape(const Vec3<T>& a, const Vec3<T>& b, T r, T) { return {a, b, r}; }
};
template <typename T>
struct ConeSpheres {
  using Made = ConeSphereBeam<T>;
  static Made beam(const Vec3<T>& a, const Vec3<T>& b, T r, T s) { return {a, b, r, s}; }
  static ConeSphere<T> shape(const Vec3<T>& a, const Vec3<T>& b, T r, T s) { return {a, b, r, s}; }
};
template <typename T>
struct CappedCones {
  using Made = CappedConeBeam<T>;
  static Made beam(const Vec3<T>& a, const Vec3<T>& b, T r, T s) { return {a, b, r, s}; }
  static CappedCone<T> shape(const Vec3<T>& a, const Vec3<T>& b, T r, T s) { return {a, b, r, s}; }
};

/// Calls visit(a, b, radius at a, radius at b): all lengths against all radii, also beams that are
/// balls, flat discs, or pointed.
template <typename T, typename Visit>
void forBeams(int count, T size, Visit visit) {
  RandomPoints<T> random(1, /*seed=*/11);
  for (int i = 0; i < count; ++i) {
    const Vec3<T> a = random.next();
    const Vec3<T> b = a + std::ldexp(size, -(i % 7)) * random.next();
    const Vec3<T> radii = size * abs(random.next());
    visit(a, b, radii.x, i % 5 == 0 ? T(0) : i % 5 == 1 ? radii.x : radii.y);
  }
}

template <typename Kind, typename T>
void expectValuesOfTheShape() {
  RandomPoints<T> random(2, /*seed=*/3);
  forBeams<T>(300, T(0.5), [&](const auto& a, const auto& b, T r, T s) {
    const auto beam = Kind::beam(a, b, r, s);
    const auto shape = Kind::shape(a, b, r, s);
    EXPECT_EQ(beam.boundingBox(), shape.boundingBox());
    for (int i = 0; i < 30; ++i) {
      const Vec3<T> near = a + T(i % 3) * (b - a) + r * random.next();
      for (const auto& p : {random.next(), near, T(1e6) * random.next()}) {
        EXPECT_PRED2(sameBits<T>, beam.distance(p), shape.signedDistance(p)) << a << b << p;
      }
    }
    EXPECT_PRED2(sameBits<T>, beam.distance(a), shape.signedDistance(a));
    EXPECT_PRED2(sameBits<T>, beam.distance(b), shape.signedDistance(b));
  });
}

TYPED_TEST(BeamTest, HaveTheValuesAndBoxesOfTheShapes) {
  using T = TypeParam;
  expectValuesOfTheShape<Capsules<T>, T>();
  expectValuesOfTheShape<ConeSpheres<T>, T>();
  expectValuesOfTheShape<CappedCones<T>, T>();
  EXPECT_EQ((CapsuleBeam<T>({0, 0, 0}, {0, 0, 4}, 2).distance({5, 0, 2})), T(3));
  EXPECT_EQ((CapsuleBeam<T>({1, 2, 3}, {1, 2, 3}, 5).distance({1, 2, 11})), T(3));
  EXPECT_EQ((ConeSphereBeam<T>({0, 0, 0}, {0, 0, 1}, 3, 1).distance({0, 0, 5})), T(2));
  EXPECT_EQ((CappedConeBeam<T>({0, 0, 0}, {0, 0, 1}, 3, 1).distance({0, 0, 5})), T(4));
}

/// The largest coordinate along each axis of points on the surface, found by their values alone.
template <typename Made, typename T>
Vec3<T> reachOf(const Made& beam, const Box<T>& box) {
  Vec3<T> reach = box.center();
  for (int axis = 0; axis < 3; ++axis) {
    // A plane across the axis meets the solid while the least value in it is negative: the plane is
    // searched by ever finer grids about the least value so far.
    const auto leastIn = [&](T x) {
      Vec3<T> middle = box.center();
      Vec3<T> half = T(0.5) * box.size();
      T least = std::numeric_limits<T>::max();
      for (int level = 0; level < 24; ++level) {
        Vec3<T> best = middle;
        for (int i = -4; i <= 4; ++i) {
          for (int j = -4; j <= 4; ++j) {
            Vec3<T> p = middle;
            p[axis] = x;
            p[(axis + 1) % 3] += T(i) / 4 * half[(axis + 1) % 3];
            p[(axis + 2) % 3] += T(j) / 4 * half[(axis + 2) % 3];
            if (beam.distance(p) < least) least = beam.distance(p), best = p;
          }
        }
        middle = best;
        half *= T(0.5);
      }
      return least;
    };
    T inside = box.center()[axis];
    T outside = box.upper[axis];
    for (int i = 0; i < 30; ++i) {
      const T x = T(0.5) * (inside + outside);
      (leastIn(x) < 0 ? inside : outside) = x;
    }
    reach[axis] = inside;
  }
  return reach;
}

TYPED_TEST(BeamTest, BoxesAreTight) {
  using T = TypeParam;
  const Vec3<T> a{T(-0.3), T(0.2), T(0.1)};
  const Vec3<T> b{T(0.5), T(-0.4), T(0.6)};
  const auto expectTight = [](const auto& beam) {
    const auto box = beam.boundingBox();
    const auto reach = reachOf(beam, box);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(reach[axis], box.upper[axis], 1e-3) << axis;
  };
  expectTight(CapsuleBeam<T>(a, b, T(0.2)));
  expectTight(ConeSphereBeam<T>(a, b, T(0.3), T(0.1)));
  expectTight(CappedConeBeam<T>(a, b, T(0.3), T(0.1)));
}

template <typename Kind, typename T>
void expectSameAsTryingAll(int count, T size) {
  using Made = typename Kind::Made;
  std::vector<Made> beams;
  forBeams<T>(count, size, [&](const auto& a, const auto& b, T r, T s) {
    beams.push_back(Kind::beam(a, b, T(0.1) * r, T(0.1) * s));
  });
  const LinearBVH<T, Made> bvh(beams);
  RandomPoints<T> random(T(1.5), /*seed=*/7);
  std::array<typename LinearBVH<T, Made>::Nearest, 6> nearest;
  for (int query = 0; query < 300; ++query) {
    const auto p = random.next();
    std::vector<std::pair<T, std::uint32_t>> all;
    for (std::uint32_t i = 0; i < beams.size(); ++i) all.emplace_back(beams[i].distance(p), i);
    std::ranges::sort(all);
    EXPECT_EQ(bvh.nearest(p).primitive, all[0].second);
    ASSERT_EQ(bvh.nearest(p, nearest), nearest.size());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      EXPECT_EQ(nearest[i].primitive, all[i].second) << p;
      EXPECT_PRED2(sameBits<T>, nearest[i].distance, all[i].first) << p;
    }
    std::size_t within = 0;
    bvh.within(p, T(0.2), [&](const auto&) { return ++within > 0; });
    EXPECT_EQ(within, std::ranges::count_if(all, [](auto& one) { return one.first <= T(0.2); }));
  }
}

TYPED_TEST(BeamTest, ATreeOfBeamsAnswersAsTryingAll) {
  using T = TypeParam;
  for (const T size : {T(0.1), T(1)}) {  // apart, and a thicket
    expectSameAsTryingAll<Capsules<T>, T>(1500, size);
    expectSameAsTryingAll<ConeSpheres<T>, T>(1500, size);
    expectSameAsTryingAll<CappedCones<T>, T>(1500, size);
  }
}

TYPED_TEST(BeamTest, AreSmall) {
  using T = TypeParam;
  EXPECT_LE(sizeof(CapsuleBeam<T>), 9 * sizeof(T));
  EXPECT_LE(sizeof(ConeSphereBeam<T>), 13 * sizeof(T));
  EXPECT_LE(sizeof(CappedConeBeam<T>), 15 * sizeof(T));
}

TYPED_TEST(BeamTest, RefuseImpossibleArguments) {
  using T = TypeParam;
  const T nan = this->kNaN;
  const Vec3<T> a{0, 0, 0};
  const Vec3<T> b{0, 0, 1};
  EXPECT_TRUE(refusal([&] { CapsuleBeam<T>(a, b, 0); }).starts_with("CapsuleBeam:"));
  EXPECT_TRUE(refusal([&] { ConeSphereBeam<T>(a, b, 0, 0); }).starts_with("ConeSphereBeam:"));
  EXPECT_TRUE(refusal([&] { CappedConeBeam<T>(a, b, -1, 2); }).starts_with("CappedConeBeam:"));
  EXPECT_THROW((CapsuleBeam<T>({0, 0, 0}, {0, 0, 1}, nan)), Error);
  EXPECT_THROW((CapsuleBeam<T>({0, 0, nan}, {0, 0, 1}, 1)), Error);
  EXPECT_THROW((ConeSphereBeam<T>({0, 0, 0}, {0, nan, 1}, 1, 1)), Error);
  EXPECT_THROW((CappedConeBeam<T>({0, 0, 0}, {0, 0, 0}, 1, 1)), Error);
}

}  // namespace
}  // namespace cutwater::test
