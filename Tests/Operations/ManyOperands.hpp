#pragma once

// Unions and intersections of many operands, compared with the plain fold over all of them.

#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Capsule.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <set>

#include "Operations/PlainFold.hpp"
#include "Support/Grid.hpp"
#include "Support/Random.hpp"
#include "Support/SameClosestPoints.hpp"

namespace cutwater::test {

/// Counted from `begin` to `end`: balls, boxes and capsules, moved and not, some deep in others
/// and some twice.
template <typename T>
std::vector<Solid<T>> parts(int begin, int end, T size) {
  std::vector<Solid<T>> result;
  RandomPoints<T> random(1, /*seed=*/static_cast<unsigned>(begin + 1));
  for (int i = begin; i < end; ++i) {
    const Vec3<T> at = random.next();
    const Vec3<T> half = size * (abs(random.next()) + Vec3<T>{T(0.1), T(0.1), T(0.1)});
    switch (i % 5) {
      case 0:
        result.push_back(Sphere<T>(at, half.x));
        break;
      case 1:
        result.push_back(Cuboid<T>(at - half, at + half));
        break;
      case 2:
        result.push_back(Capsule<T>(at - half, at + half, half.y));
        break;
      case 3:
        result.push_back(rotated(Cuboid<T>(at - half, at + half), T(7) * half.z / size, at));
        break;
      default:
        result.push_back(result[result.size() / 2]);
    }
  }
  return result;
}

/// A block, and all that is taken away from it.
template <typename T>
std::vector<Solid<T>> block(const std::vector<Solid<T>>& holes) {
  std::vector<Solid<T>> result;
  for (const auto& hole : holes) result.push_back(~hole);
  const auto middle = result.begin() + static_cast<std::ptrdiff_t>(result.size() / 2);
  result.insert(middle, rotated(Cuboid<T>({-1, -1, -1}, {1, 1, 1}), T(10), 2));
  return result;
}

/// Counts how often it is asked. Values are those of a small ball.
template <typename T>
struct Counted final : SignedDistanceFunction<T> {
  Counted(const Vec3<T>& at, int& asked) : ball(at, T(0.01)), calls(&asked) {}
  T localSignedDistance(const Vec3<T>& p) const override {
    ++*calls;
    return ball.signedDistance(p);
  }
  Guarantee<T> localGuarantee() const override { return ball.guarantee(); }
  Box<T> localBoundingBox() const override { return ball.boundingBox(); }
  Sphere<T> ball;
  int* calls;
};

template <typename T>
void expectSamePoint(const Solid<T>& solid, const Solid<T>& plain, const Vec3<T>& p) {
  SCOPED_TRACE(testing::Message() << "point " << p);
  EXPECT_PRED2(sameBits<T>, solid.signedDistance(p), plain.signedDistance(p));
  EXPECT_TRUE(isSame(solid.gradient(p), plain.gradient(p)));
  EXPECT_EQ(solid.owner(p), plain.owner(p));
  EXPECT_EQ(differingFields(solid.closestPoint(p), plain.closestPoint(p)), "");
}

template <typename T>
BoxClass expectSameBox(const Solid<T>& solid, const Solid<T>& plain, const Box<T>& box) {
  const auto bounds = solid.bounds(box);
  const auto expected = plain.bounds(box);
  EXPECT_PRED2(sameBits<T>, bounds.lower, expected.lower) << box.lower << box.upper;
  EXPECT_PRED2(sameBits<T>, bounds.upper, expected.upper) << box.lower << box.upper;
  EXPECT_EQ(solid.classify(box), plain.classify(box)) << box.lower << box.upper;
  return solid.classify(box);
}

template <typename T>
void expectSameCrossings(const Solid<T>& solid, const Solid<T>& plain, const Segment<T>& segment) {
  const auto all = [&segment](const Solid<T>& asked) {
    std::vector<T> result;
    const auto count = asked.crossings(segment, [&](const Crossing<T>& c) {
      const auto [object, patch, face] = c.owner;
      result.insert(result.end(), {c.parameter, c.normal.x, c.normal.y, c.normal.z, T(c.entering),
                                   static_cast<T>(object), static_cast<T>(patch), T(face)});
      return true;
    });
    result.push_back(static_cast<T>(count.unresolved));
    return result;
  };
  EXPECT_EQ(all(solid), all(plain)) << segment.start << segment.end;
}

template <typename T>
void expectSameAsPlain(Solid<T> solid, const std::vector<Solid<T>>& operands, bool least) {
  Solid<T> plain = PlainFold<T>(operands, least, solid.guarantee());
  RandomPoints<T> random(T(1.3), /*seed=*/3);
  for (int motion = 0; motion < 2; ++motion) {
    std::vector<Vec3<T>> points;
    for (int i = 0; i < 700; ++i) points.push_back(random.next());
    for (const T far : {T(1e3), T(1e9), T(1e17), T(1e25), T(1e37)}) {
      points.push_back(far * random.next());
    }
    points.push_back({std::numeric_limits<T>::quiet_NaN(), 0, 0});
    std::vector<T> values(points.size());
    solid.signedDistances(points, values);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_PRED2(sameBits<T>, values[i], plain.signedDistance(points[i])) << points[i];
    }
    for (std::size_t i = 0; i + 3 < points.size(); i += 3) expectSamePoint(solid, plain, points[i]);
    std::set<BoxClass> classes;
    for (int i = 0; i < 200; ++i) {
      const auto at = random.next();
      const T size = std::ldexp(T(1), -(i % 12));
      classes.insert(expectSameBox(solid, plain, Box<T>{at, at + size * abs(random.next())}));
    }
    EXPECT_GE(classes.size(), 3U);  // few remain Unknown
    expectSameBox(solid, plain, {{0, 0, 0}, {T(1e20), T(1e20), T(1e20)}});
    expectSameBox(solid, plain, {{-9, -9, -9}, {9, 9, 9}});
    for (int i = 0; i < 4; ++i) expectSameCrossings(solid, plain, {random.next(), random.next()});
    for (auto* moved : {&solid, &plain}) {
      moved->rotate(T(25), {1, 1, 0}, {T(0.1), 0, 0});
      moved->translate({T(0.05), 0, 0});
    }
  }
}

}  // namespace cutwater::test
