#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/CappedCone.hpp>
#include <Cutwater/Shapes/CappedTorus.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Ellipsoid.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/Link.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Shapes/RoundedCylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <vector>

#include "Support/Precisions.hpp"

// How many boxes of a grid stay undecided.

namespace cutwater::test {
namespace {

/// Cells of [-1, 1]^3, 32 along each axis, that are Cut and Unknown.
struct Shares {
  int cut = 0;
  int unknown = 0;
};
template <std::floating_point T>
Shares sharesOf(const SignedDistanceFunction<T>& solid) {
  Shares found;
  for (int n = 0; n < 32 * 32 * 32; ++n) {
    const Vec3<T> lower{T(n % 32) / 16 - 1, T(n / 32 % 32) / 16 - 1, T(n / 1024) / 16 - 1};
    const auto kind = solid.classify({lower, lower + Vec3<T>{T(1) / 16, T(1) / 16, T(1) / 16}});
    found.cut += kind == BoxClass::Cut ? 1 : 0;
    found.unknown += kind == BoxClass::Unknown ? 1 : 0;
  }
  return found;
}

template <typename T>
class UnknownBoxesTest : public ::testing::Test {};
TYPED_TEST_SUITE(UnknownBoxesTest, Precisions);

TYPED_TEST(UnknownBoxesTest, FewOfAnyShapeAreUnknown) {
  using T = TypeParam;
  const auto at = [](double x, double y, double z) {
    return Vec3<T>{static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)};
  };
  const Vec3<T> a = at(0.01, 0.02, -0.53);
  const Vec3<T> b = at(0.01, 0.02, 0.41);
  const Box<T> box{at(-0.61, -0.43, -0.52), at(0.58, 0.47, 0.33)};
  const std::vector<Solid<T>> solids{Sphere<T>(a / 2, T(0.6)),
                                     Cuboid<T>(box),
                                     Plane<T>(a, at(0.3, 0.5, 1)),
                                     Cylinder<T>(a, b, T(0.4)),
                                     Capsule<T>(a, b, T(0.37)),
                                     CappedCone<T>(a, b, T(0.6), T(0.2)),
                                     Torus<T>(T(0.6), T(0.21)),
                                     CappedTorus<T>(T(0.6), T(0.21), 120),
                                     Link<T>(T(0.25), T(0.35), T(0.13)),
                                     RoundedBox<T>(box, T(0.1)),
                                     RoundedCylinder<T>(a, b, T(0.4), T(0.1)),
                                     Ellipsoid<T>(a / 2, at(0.7, 0.5, 0.3)),
                                     HexagonalPrism<T>(T(0.53), T(0.7)),
                                     Octahedron<T>(T(0.71)),
                                     Pyramid<T>(T(0.93), T(0.7))};
  for (auto solid : solids) {
    solid.rotate(31, at(1, 2, -1));
    const auto found = sharesOf(solid);
    EXPECT_GT(found.cut, 300) << solid.describe();
    EXPECT_LE(found.unknown, found.cut / 50) << solid.describe();
  }
}

}  // namespace
}  // namespace cutwater::test
