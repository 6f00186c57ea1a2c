// The operator of Docs/shapes.md.
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Operations/UnaryOperation.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "Support/Guarantee.hpp"

namespace cutwater::test {
namespace {

// [DOCS
/// The operand with values cut off at `width` to either side of the surface.
///
///     f(p) = max(-width, min(g(p), width))        a lower bound if the operand's value is one
class CutOff final : public cutwater::UnaryOperation<double> {
  using Point = cutwater::Vec3<double>;

 public:
  CutOff(cutwater::Solid<double> operand, double width)
      : UnaryOperation(std::move(operand)), width_(width) {
    cutwater::require(0 < width, "CutOff: need 0 < width", cutwater::Named{"width", width});
  }

 private:
  double cut(double value) const { return std::clamp(value, -width_, width_); }

  double localSignedDistance(const Point& p) const override {
    return cut(operand().signedDistance(p));
  }
  void localSignedDistances(std::span<const Point> points,
                            std::span<double> distances) const override {
    operandValues(points, distances);
    for (double& value : distances) value = cut(value);
  }
  Point localGradient(const Point& p) const override {
    return std::abs(operand().signedDistance(p)) < width_ ? operand().gradient(p) : Point{};
  }
  // The surface is the operand's.
  cutwater::SurfacePoint<double> localClosestPoint(const Point& p) const override {
    auto found = operand().closestPoint(p);
    found.exact = found.exact && std::abs(found.distance) < width_;  // beyond, it is a bound
    found.distance = cut(found.distance);
    return found;
  }
  cutwater::SurfaceOwner localOwner(const Point& p) const override { return operand().owner(p); }
  cutwater::BoxClass localClassify(const cutwater::OrientedBox<double>& box,
                                   cutwater::BoxHint* hint) const override {
    return classOf(operand(), box, hint);
  }
  cutwater::Guarantee<double> localGuarantee() const override {
    auto promise = operand().guarantee();
    promise.outside = std::min(promise.outside, cutwater::Quality::LowerBound);
    promise.inside = std::min(promise.inside, cutwater::Quality::LowerBound);
    return promise;
  }
  cutwater::Box<double> localBoundingBox() const override { return operand().boundingBox(); }
  std::string localName() const override { return "Cut off"; }

  double width_;
};
// DOCS]

TEST(CutOffTest, MatchesHandComputedValues) {
  const CutOff ball(Sphere<double>({1, 0, 0}, 2), 0.5);
  EXPECT_EQ(ball.signedDistance({4, 0, 0}), 0.5);
  EXPECT_EQ(ball.signedDistance({3.25, 0, 0}), 0.25);
  EXPECT_EQ(ball.signedDistance({1, 0, 0}), -0.5);
}

TEST(CutOffTest, KeepsItsGuarantee) {
  expectGuarantee(CutOff(Sphere<double>({0.2, 0, 0}, 1), 0.25), /*extent=*/2);
  expectGuarantee(CutOff(translated(Cuboid<double>({-1, -1, -1}, {1, 0.5, 1}), {0.1, 0, 0}), 0.25),
                  /*extent=*/2);
}

TEST(CutOffTest, RefusesNoWidth) {
  EXPECT_THROW(CutOff(Sphere<double>({}, 1), 0), Error);
}

}  // namespace
}  // namespace cutwater::test
