#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/HexagonalPrism.hpp>
#include <Cutwater/Shapes/Octahedron.hpp>
#include <Cutwater/Shapes/Pyramid.hpp>

#include <algorithm>
#include <numbers>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class ConvexPolyhedronTest : public ::testing::Test {};
TYPED_TEST_SUITE(ConvexPolyhedronTest, Precisions);

template <typename T>
using HalfSpaces = std::vector<HalfSpace<T>>;

template <typename T>
HalfSpaces<T> cube() {
  return {{{1, 0, 0}, {1, 0, 0}},   {{-1, 0, 0}, {-1, 0, 0}}, {{0, 1, 0}, {0, 2, 0}},
          {{0, -1, 0}, {0, -1, 0}}, {{7, 7, 1}, {0, 0, 1}},   {{0, 0, -1}, {0, 0, -1}}};
}
template <typename T>
HalfSpaces<T> octahedron() {
  HalfSpaces<T> all;
  for (int i = 0; i < 8; ++i) {
    const Vec3<T> normal{T(i & 1) * 2 - 1, T(i >> 1 & 1) * 2 - 1, T(i >> 2 & 1) * 2 - 1};
    all.push_back({{normal.x, 0, 0}, normal});
  }
  return all;
}
template <typename T>
HalfSpaces<T> pyramid(T half, T height) {
  const Vec3<T> apex{0, 0, height};
  return {{{0, 0, 0}, {0, 0, -1}},
          {apex, {height, 0, half}},
          {apex, {-height, 0, half}},
          {apex, {0, height, half}},
          {apex, {0, -height, half}}};
}
/// `count` planes that touch the unit ball.
template <typename T>
HalfSpaces<T> aroundBall(int count) {
  HalfSpaces<T> all;
  RandomPoints<T> random(1, 7);
  while (static_cast<int>(all.size()) < count) {
    const auto direction = random.next();
    if (length(direction) > T(0.1)) all.push_back({normalized(direction), direction});
  }
  return all;
}

template <typename T>
void expectSame(const SignedDistanceFunction<T>& a, const SignedDistanceFunction<T>& b) {
  RandomPoints<T> points(3);
  for (int i = 0; i < 3000; ++i) {
    auto p = points.next();
    if (i % 4 == 0) p[i / 4 % 3] = 0;
    if (i % 8 == 1) p = T(1e4) * p;
    if (i % 8 == 3) p = a.closestPoint(p).point;
    const T allowed = tolerance<T>(length(p) + 2, 8);
    EXPECT_NEAR(a.signedDistance(p), b.signedDistance(p), allowed) << p;
    const auto slopes = length(a.gradient(p)) * length(b.gradient(p));
    const bool isNear = std::abs(a.signedDistance(p)) < T(1e-3);  // rounding decides there
    if (slopes > 0 && !isNear) {
      EXPECT_LT(length(a.gradient(p) - b.gradient(p)), T(1e-3)) << p;
    }
  }
}

TYPED_TEST(ConvexPolyhedronTest, IsWhatTheShapesWithTheSameFacesAre) {
  using T = TypeParam;
  expectSame<T>(ConvexPolyhedron<T>(cube<T>()), Cuboid<T>({-1, -1, -1}, {1, 1, 1}));
  expectSame<T>(ConvexPolyhedron<T>(octahedron<T>()), Octahedron<T>(1));
  expectSame<T>(ConvexPolyhedron<T>(pyramid<T>(1, T(0.75))), Pyramid<T>(2, T(0.75)));
  expectSame<T>(ConvexPolyhedron<T>(pyramid<T>(T(0.01), 2)), Pyramid<T>(T(0.02), 2));
  HalfSpaces<T> hexagon{{{0, 0, 1}, {0, 0, 1}}, {{0, 0, -1}, {0, 0, -1}}};
  for (int side = 0; side < 6; ++side) {
    const double angle = (30 + 60 * side) * std::numbers::pi / 180;
    const Vec3<T> normal(Vec3<double>{std::cos(angle), std::sin(angle), 0});
    hexagon.push_back({normal, normal});
  }
  expectSame<T>(ConvexPolyhedron<T>(hexagon), HexagonalPrism<T>(1, 2));
}

TYPED_TEST(ConvexPolyhedronTest, LeavesOutHalfSpacesWithoutAFace) {
  using T = TypeParam;
  auto halfSpaces = cube<T>();
  halfSpaces.push_back({{3, 0, 0}, {1, T(0.1), 0}});       // beyond
  halfSpaces.push_back({{2, 0, 0}, {1, 0, 0}});            // parallel
  halfSpaces.push_back({{1, 5, 0}, {3, 0, 0}});            // twice
  halfSpaces.push_back({{1, 1, 1}, {3, 3, 3}});            // touches at a corner
  halfSpaces.push_back({{1, 1, 0}, {T(0.3), T(0.2), 0}});  // touches along an edge
  const ConvexPolyhedron<T> solid(halfSpaces);
  EXPECT_EQ(ConvexPolyhedron<T>(cube<T>()).faceCount(), 6U);
  EXPECT_LE(solid.faceCount(), 8U);
  expectSame<T>(solid, Cuboid<T>({-1, -1, -1}, {1, 1, 1}));
}

/// By trying all: the nearest of the feet on every plane, every line of two and every point of
/// three that are in all half-spaces.
class AllFeet {
 public:
  explicit AllFeet(const HalfSpaces<double>& halfSpaces) {
    for (const auto& half : halfSpaces) {
      normals_.push_back(normalized(half.normal));
      offsets_.push_back(dot(normals_.back(), half.point));
    }
  }

  [[nodiscard]] double height(std::size_t i, const Vec3<double>& p) const {
    return dot(normals_[i], p) - offsets_[i];
  }
  [[nodiscard]] double deepest(const Vec3<double>& p) const {
    double value = height(0, p);
    for (std::size_t i = 1; i < normals_.size(); ++i) value = std::max(value, height(i, p));
    return value;
  }
  [[nodiscard]] double distance(const Vec3<double>& p) const {
    double best = 1e9;
    const auto offer = [&](const Vec3<double>& foot) {
      if (length(foot - p) < best && deepest(foot) < 1e-12) best = length(foot - p);
    };
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      offer(p - height(i, p) * normals_[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const auto line = cross(normals_[i], normals_[j]);
        offer(meet(i, j, line, dot(line, p)));
        for (std::size_t k = 0; k < j; ++k) offer(meet(i, j, normals_[k], offsets_[k]));
      }
    }
    return best;
  }

 private:
  /// Where the planes i and j meet that with this normal and offset.
  [[nodiscard]] Vec3<double> meet(std::size_t i, std::size_t j, const Vec3<double>& normal,
                                  double offset) const {
    const auto& a = normals_[i];
    const auto& b = normals_[j];
    const Vec3<double> sum =
        offsets_[i] * cross(b, normal) + offsets_[j] * cross(normal, a) + offset * cross(a, b);
    return sum / dot(a, cross(b, normal));
  }

  std::vector<Vec3<double>> normals_;
  std::vector<double> offsets_;
};

TEST(ConvexPolyhedronBruteForce, AgreesWithAllFeet) {
  for (const int count : {12, 40}) {
    const auto halfSpaces = aroundBall<double>(count);
    const ConvexPolyhedron<double> solid(halfSpaces);
    const AllFeet all(halfSpaces);
    RandomPoints<double> points(3);
    int outside = 0;
    for (int i = 0; i < 200; ++i) {
      const auto p = points.next();
      const double deepest = all.deepest(p);
      outside += deepest > 0 ? 1 : 0;
      EXPECT_NEAR(solid.signedDistance(p), deepest < 0 ? deepest : all.distance(p), 1e-11) << p;
    }
    EXPECT_GT(outside, 100);
  }
}

TYPED_TEST(ConvexPolyhedronTest, KnowsTheRangeInBoxesInsideAndInFrontOfAFace) {
  using T = TypeParam;
  const ConvexPolyhedron<T> solid(cube<T>());
  const auto expectRange = [&](const Box<T>& box, T lower, T upper) {
    const auto range = solid.bounds(box);
    EXPECT_NEAR(range.lower, lower, tolerance<T>(4, 40));
    EXPECT_NEAR(range.upper, upper, tolerance<T>(4, 40));
  };
  expectRange({{T(-0.25), T(-0.5), 0}, {T(0.25), T(0.5), T(0.75)}}, -1, T(-0.25));
  // The centre is 2 away, and the corners sqrt(0.75) from it.
  expectRange({{T(2.5), T(-0.5), T(-0.5)}, {T(3.5), T(0.5), T(0.5)}}, T(1.5),
              2 + std::sqrt(T(0.75)));
}

/// A turned cube, two half-spaces for each face, whose normals differ by about as much as `noise`:
/// as the triangles of a mesh may give them.
template <typename T>
HalfSpaces<T> cubeOfPairs(const RigidTransform<double>& turn, double noise,
                          RandomPoints<double>& random) {
  HalfSpaces<T> all;
  for (int side = 0; side < 6; ++side) {
    for (const double along : {-0.5, 0.5}) {
      Vec3<double> normal;
      normal[side / 2] = side % 2 == 0 ? 1 : -1;
      auto point = normal;
      point[(side / 2 + 1) % 3] = along;
      all.push_back(
          {Vec3<T>(turn.toWorld(point)), Vec3<T>(turn.toWorld(normal) + noise * random.next())});
    }
  }
  return all;
}

TYPED_TEST(ConvexPolyhedronTest, FacesMayBeGivenTwiceWithRoundedNormals) {
  using T = TypeParam;
  RandomPoints<double> random(1, 7);
  const double eps = std::numeric_limits<T>::epsilon();
  for (int n = 0; n < scaled(300); ++n) {
    RigidTransform<double> turn;
    turn.rotate(180 * random.next().x, random.next());
    const double noise = std::array{0.5, 1.0, 4.0, 1000.0}[static_cast<std::size_t>(n % 4)] * eps;
    const ConvexPolyhedron<T> solid(cubeOfPairs<T>(turn, noise, random));
    const double allowed = 4 * noise + double{solid.guarantee().error(T(2))};
    for (int i = 0; i < 50; ++i) {
      auto p = 0.9 * random.next();
      p[i % 3] = i % 2 == 0 ? 1 : -1;
      const Vec3<T> there(turn.toWorld(p));
      ASSERT_NEAR(solid.signedDistance(there), 0, allowed) << turn.toWorld(p) << " of cube " << n;
      ASSERT_EQ(solid.classify(Box<T>{there, there}.grown(T(0.01))), BoxClass::Cut);
      // Its gradient points out.
      EXPECT_GT(dot(Vec3<double>(solid.gradient(Vec3<T>(turn.toWorld(1.01 * p)))), turn.toWorld(p)),
                0.5);
    }
  }
}

TYPED_TEST(ConvexPolyhedronTest, RefusesImpossibleArguments) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_THROW(ConvexPolyhedron<T>({}), Error);
  auto open = cube<T>();
  open.pop_back();
  EXPECT_THROW(ConvexPolyhedron<T>{open}, Error);
  auto flat = cube<T>();
  flat.push_back({{-1, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(ConvexPolyhedron<T>{flat}, Error);
  auto empty = cube<T>();
  empty.push_back({{-2, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(ConvexPolyhedron<T>{empty}, Error);
  auto point = cube<T>();
  point.push_back({{-1, -1, -1}, {1, 1, 1}});
  EXPECT_THROW(ConvexPolyhedron<T>{point}, Error);
  auto bad = cube<T>();
  bad[2].normal = {0, 0, 0};
  EXPECT_THROW(ConvexPolyhedron<T>{bad}, Error);
  bad[2] = {{nan, 0, 0}, {0, 1, 0}};
  EXPECT_THROW(ConvexPolyhedron<T>{bad}, Error);
}

TYPED_TEST(ConvexPolyhedronTest, KeepsItsGuarantee) {
  using T = TypeParam;
  const auto halfSpaces = aroundBall<T>(12);
  expectGuarantee(ConvexPolyhedron<T>(halfSpaces), 2.5,
                  {.inside =
                       [=](const Vec3<double>& p) {
                         return std::ranges::all_of(halfSpaces, [&](const auto& half) {
                           return dot(p - Vec3<double>(half.point), Vec3<double>(half.normal)) < 0;
                         });
                       },
                   .covering = 4});
  expectGuarantee(ConvexPolyhedron<T>(pyramid<T>(1, T(0.25))), 2, {.covering = 4});
}

TEST(ConvexPolyhedronRounding, StaysWithinItsBound) {
  const auto widened = [](const HalfSpaces<float>& halfSpaces) {
    HalfSpaces<double> wide;
    for (const auto& half : halfSpaces) {
      wide.push_back({Vec3<double>(half.point), Vec3<double>(half.normal)});
    }
    return ConvexPolyhedron<double>(wide);
  };
  for (const auto& halfSpaces :
       {aroundBall<float>(12), aroundBall<float>(60), pyramid<float>(2, 0.001f),
        pyramid<float>(0.001f, 2), octahedron<float>()}) {
    expectRounding(ConvexPolyhedron<float>(halfSpaces), widened(halfSpaces), 4);
  }
}

}  // namespace
}  // namespace cutwater::test
