#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Cutwater.hpp>

#include <array>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

TEST(Algebra, TakesShapesAndSolidsAlike) {
  const Cylinder<double> outer({0, 0, 0}, {0, 0, 4}, 1);
  const Solid<double> pipe = outer - Cylinder<double>({0, 0, -1}, {0, 0, 5}, 0.5);
  EXPECT_EQ(pipe.signedDistance({0.75, 0, 2}), -0.25);
  EXPECT_EQ(pipe.signedDistance({0, 0, 2}), 0.5);
  const auto tank =
      offset(Cuboid<double>({-1, -1, -1}, {1, 1, 1}), 0.25) | translated(pipe, {4, 0, 0});
  EXPECT_EQ(tank.signedDistance({4.75, 0, 2}), -0.25);
  EXPECT_EQ(tank.signedDistance({0, 0, 2.25}), 1.0);
}

TEST(Algebra, FindsItsOperatorsForAUsersShape) {
  struct Slab final : SignedDistanceFunction<float> {
    float localSignedDistance(const Vec3<float>& p) const override { return std::abs(p.z) - 1; }
  };
  const auto half = Slab() & Plane<float>({0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(half.signedDistance({-5, 0, 0}), -1.0F);
  EXPECT_EQ((~Slab()).signedDistance({0, 0, 0}), 1.0F);
}

TEST(Algebra, MovesCopiesOnly) {
  const Solid<double> ball = Sphere<double>({1, 0, 0}, 1);
  EXPECT_EQ(rotated(ball, 90, 2).signedDistance({0, 1, 0}), -1);
  EXPECT_EQ(rotated(ball, 180, {0, 1, 0}, {2, 0, 0}).signedDistance({3, 0, 0}), -1);
  EXPECT_EQ(translated(ball, std::array<double, 3>{0, 0, 7}).signedDistance({1, 0, 7}), -1);
  EXPECT_EQ(ball.signedDistance({1, 0, 0}), -1);
  EXPECT_TRUE(ball.placement().isIdentity());
}

TEST(Algebra, NamesPatches) {
  using Names = std::vector<std::string>;
  const Sphere<double> ball({0, 0, 0}, 1);
  const auto rig = named(ball, "mast") | named(ball, "boom");
  EXPECT_EQ(rig.patchNames(), (Names{"mast", "boom"}));
  EXPECT_EQ(named(rig, "rig").patchNames(), (Names{"rig/mast", "rig/boom"}));
  EXPECT_EQ(named(ball | scaled(ball, 2), "buoys").patchNames(), (Names{"buoys", "buoys"}));
  EXPECT_EQ((rig - named(ball, "hatch")).patchNames(), (Names{"mast", "boom", "hatch"}));
  EXPECT_EQ(scaled(offset(~rig, 1), 2).patchNames(), (Names{"mast", "boom"}));
  EXPECT_EQ(named(ball, "mast").closestPoint({3, 0, 0}).point, ball.closestPoint({3, 0, 0}).point);
  EXPECT_THROW(static_cast<void>(named(ball, "")), Error);
}

}  // namespace
}  // namespace cutwater::test
