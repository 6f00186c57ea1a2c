#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

/// Counts its copies, so that sharing shows.
class Counted final : public SignedDistanceFunction<double> {
 public:
  Counted() = default;
  Counted(const Counted& other) : SignedDistanceFunction<double>(other) { ++copies; }
  Counted(Counted&&) noexcept = default;
  Counted& operator=(const Counted&) = delete;
  Counted& operator=(Counted&&) = delete;
  ~Counted() override = default;

  static inline int copies = 0;

 private:
  double localSignedDistance(const Vec3<double>& p) const override { return length(p) - 1; }
};

TEST(Solid, CopiesShareTheShape) {
  Counted::copies = 0;
  const Solid<double> solid = Counted();
  const auto copy = solid;
  auto moved = copy;
  moved.translate({5, 0, 0});
  EXPECT_EQ(Counted::copies, 0);
  EXPECT_EQ(solid.as<Counted>(), moved.as<Counted>());
  EXPECT_EQ(solid.as<Sphere<double>>(), nullptr);
}

TEST(Solid, MovingOneDoesNotMoveItsCopies) {
  Solid<double> solid = Sphere<double>({0, 0, 0}, 1);
  auto copy = solid;
  solid.translate({5, 0, 0});
  copy.rotate(90, 1);
  EXPECT_EQ(solid.signedDistance({5, 0, 0}), -1);
  EXPECT_EQ(copy.signedDistance({5, 0, 0}), 4);
}

TEST(Solid, TakesOverTheShapesPlacement) {
  Cuboid<float> box({0, 0, 0}, {4, 1, 1});
  box.rotate(90, 2);
  box.translate({10, 0, 0});
  Solid<float> solid = box;
  EXPECT_EQ(solid.placement(), box.placement());
  EXPECT_EQ(solid.signedDistance({9.5F, 2, 0.5F}), -0.5F);
  solid.setPlacement({});
  EXPECT_EQ(solid.signedDistance({2, 0.5F, 0.5F}), -0.5F);
  EXPECT_EQ(box.signedDistance({9.5F, 2, 0.5F}), -0.5F);  // the shape itself stays
}

TEST(Solid, OfASolidIsThatSolid) {
  const Solid solid = Sphere<double>({0, 0, 0}, 1);  // deduces double
  const Solid<double> again = solid;
  EXPECT_EQ(again.as<Sphere<double>>(), solid.as<Sphere<double>>());
}

TEST(Solid, RefusesNothing) {
  EXPECT_THROW(Solid<double>(std::unique_ptr<SignedDistanceFunction<double>>()), Error);
}

TEST(Solid, KeepsTheShapesGuaranteeWhenMoved) {
  Solid<double> solid = Sphere<double>({0, 0, 0}, 1);
  const auto before = solid.guarantee();
  solid.translate({100, 0, 0});
  const auto after = solid.guarantee();
  EXPECT_EQ(after.outside, Quality::Exact);
  EXPECT_GT(after.error(100), before.error(100));
  EXPECT_NEAR(solid.boundingBox().upper.x, 101, 1e-9);
}

}  // namespace
}  // namespace cutwater::test
