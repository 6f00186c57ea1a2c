#include <Cutwater/Adapters/FluidDomain.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cmath>
#include <string>

#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class FluidDomainTest : public ::testing::Test {
 protected:
  static FluidDomain<T> around() { return {ball(), FluidSide::Outside, {3, 0, 0}}; }
  static FluidDomain<T> within() { return {ball(), FluidSide::Inside, {0, 0, 0}}; }
  static Solid<T> ball() { return Sphere<T>({0, 0, 0}, 2); }

  /// What the constructor says of this point.
  static std::string refusal(FluidSide side, const Vec3<T>& fluidPoint) {
    try {
      const FluidDomain<T> domain(ball(), side, fluidPoint);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Argument);
      return error.what();
    }
    return "nothing";
  }
};

TYPED_TEST_SUITE(FluidDomainTest, Precisions);

TYPED_TEST(FluidDomainTest, IsNegativeInTheFluid) {
  using T = TypeParam;
  EXPECT_EQ(this->around().levelSet({5, 0, 0}), T(-3));
  EXPECT_EQ(this->around().levelSet({0, 1, 0}), T(1));
  EXPECT_EQ(this->within().levelSet({5, 0, 0}), T(3));
  EXPECT_EQ(this->within().levelSet({0, 1, 0}), T(-1));
  for (const auto& domain : {this->around(), this->within()}) {
    EXPECT_TRUE(sameBits(domain.levelSet({0, 0, 2}), T(0))) << "on the surface";
  }
}

TYPED_TEST(FluidDomainTest, GradientLeadsOutOfTheFluid) {
  using T = TypeParam;
  EXPECT_EQ(this->around().gradient({5, 0, 0}), (Vec3<T>{-1, 0, 0}));
  EXPECT_EQ(this->within().gradient({0, 1, 0}), (Vec3<T>{0, 1, 0}));
}

TYPED_TEST(FluidDomainTest, ClassifiesBoxesForTheFlow) {
  using T = TypeParam;
  const Box<T> inBall{{T(-0.5), T(-0.5), T(-0.5)}, {T(0.5), T(0.5), T(0.5)}};
  const Box<T> far{{4, 4, 4}, {5, 5, 5}};
  const Box<T> across{{1, 0, 0}, {3, 1, 1}};
  const Box<T> touching{{2, 0, 0}, {3, 1, 1}};
  EXPECT_EQ(this->around().classify(inBall), FluidClass::Body);
  EXPECT_EQ(this->around().classify(far), FluidClass::Fluid);
  EXPECT_EQ(this->within().classify(inBall), FluidClass::Fluid);
  EXPECT_EQ(this->within().classify(far), FluidClass::Body);
  for (const auto& domain : {this->around(), this->within()}) {
    EXPECT_EQ(domain.classify(across), FluidClass::Cut);
    EXPECT_EQ(domain.classify(Box<T>{}), FluidClass::Unknown) << "empty";
    const auto touched = domain.classify(touching);
    EXPECT_TRUE(touched == FluidClass::Cut || touched == FluidClass::Unknown);
  }
}

TYPED_TEST(FluidDomainTest, BatchesAreTheSameAsOneByOne) {
  using T = TypeParam;
  RandomPoints<T> random(4);
  std::vector<Vec3<T>> points(500);
  std::vector<Box<T>> boxes;
  for (auto& point : points) {
    point = random.next();
    boxes.push_back(Box<T>{point, point}.grown(T(0.4)));
  }
  for (const auto& domain : {this->around(), this->within()}) {
    std::vector<T> values(points.size());
    std::vector<FluidClass> classes(points.size());
    domain.levelSets(points, values);
    domain.classify(boxes, classes);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(sameBits(values[i], domain.levelSet(points[i])));
      EXPECT_EQ(classes[i], domain.classify(boxes[i]));
    }
  }
}

TYPED_TEST(FluidDomainTest, RefusesAPointThatIsNotFluid) {
  const auto inside = this->refusal(FluidSide::Outside, {0, 0.5, 0});
  for (const auto* part : {"fluid outside", "fluidPoint = (0, 0.5, 0)", "signed distance = -1.5"}) {
    EXPECT_NE(inside.find(part), std::string::npos) << inside;
  }
  const auto outside = this->refusal(FluidSide::Inside, {0, 3, 0});
  for (const auto* part : {"fluid inside", "fluidPoint = (0, 3, 0)", "signed distance = 1"}) {
    EXPECT_NE(outside.find(part), std::string::npos) << outside;
  }
  EXPECT_EQ(this->refusal(FluidSide::Outside, {3, 0, 0}), "nothing");
}

TYPED_TEST(FluidDomainTest, RefusesAPointOnTheSurfaceOrNowhere) {
  using T = TypeParam;
  for (const auto side : {FluidSide::Outside, FluidSide::Inside}) {
    EXPECT_NE(this->refusal(side, {2, 0, 0}), "nothing");
    EXPECT_NE(this->refusal(side, {std::numeric_limits<T>::quiet_NaN(), 0, 0}), "nothing");
  }
}

}  // namespace
}  // namespace cutwater::test
