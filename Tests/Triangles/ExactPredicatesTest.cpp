#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

__extension__ using Integer = __int128;
using Triangle3 = std::array<Vec3<double>, 3>;

int sign(Integer value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// For integer coordinates below 2^40.
Integer determinant(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c,
                    const Vec3<double>& p) {
  std::array<std::array<Integer, 3>, 3> m{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    m[0][k] = static_cast<Integer>(b[i]) - static_cast<Integer>(a[i]);
    m[1][k] = static_cast<Integer>(c[i]) - static_cast<Integer>(a[i]);
    m[2][k] = static_cast<Integer>(p[i]) - static_cast<Integer>(a[i]);
  }
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

class Integers {
 public:
  Vec3<double> vector(int bits) { return {number(bits), number(bits), number(bits)}; }
  double number(int bits) {
    return std::floor(std::ldexp(std::uniform_real_distribution<double>(-1, 1)(engine_), bits));
  }
  /// One of 0, 1, ..., count - 1.
  double below(unsigned count) { return static_cast<double>(engine_() % count); }

 private:
  std::mt19937 engine_{5};
};

TEST(ExactPredicates, OrientationOfIntegers) {
  Integers random;
  for (int i = 0; i < 20'000; ++i) {
    const int bits = 1 + i % 39;
    const auto a = random.vector(bits);
    const auto b = random.vector(bits);
    const auto c = random.vector(bits);
    const auto p = random.vector(bits);
    const int expected = sign(determinant(a, b, c, p));
    ASSERT_EQ(orientation(a, b, c, p), expected);
    ASSERT_EQ(orientation(b, a, c, p), -expected);
    ASSERT_EQ(orientation(p, b, c, a), -expected);
    const double scale = std::ldexp(1.0, i % 60 - 80);  // another place among the exponents
    ASSERT_EQ(orientation(scale * a, scale * b, scale * c, scale * p), expected);
  }
}

TEST(ExactPredicates, OrientationOfCoplanarPoints) {
  Integers random;
  for (int i = 0; i < 5'000; ++i) {
    const auto a = random.vector(30);
    const auto u = random.vector(30);
    const auto v = random.vector(30);
    const auto p = a + random.number(6) * u + random.number(6) * v;
    ASSERT_EQ(orientation(a, a + u, a + v, p), 0);
    for (int axis = 0; axis < 3; ++axis) {
      auto q = p;
      q[axis] = std::nextafter(p[axis], 1e300);
      const auto normal = cross(u, v)[axis];  // about 2^60: its sign is certain unless tiny
      if (std::abs(normal) < 1e6) continue;
      ASSERT_EQ(orientation(a, a + u, a + v, q), normal > 0 ? 1 : -1);
    }
  }
}

// Integer vectors of determinant 1 (the third is a solution of n . w = 1 for n = u x v, reduced by
// u and v): 150 bits cancel, more than even twice the precision has.
TEST(ExactPredicates, OrientationWhereAlmostEverythingCancels) {
  using Rows = std::array<Vec3<double>, 3>;
  constexpr Rows kUnimodular[] = {{{{652225791528247, -908438621936560, -701975743197141},
                                    {-158984624976139, -738828703149864, 757380690437978},
                                    {-26253617232780, 97027198693321, -8656560399981}}},
                                  {{{-42051724768369, -859691715573210, -847294192874071},
                                    {-902568493655532, -130232100332852, -526134101633333},
                                    {286041156134378, 374642643961199, 488066254608999}}},
                                  {{{761735168644502, -661780669655669, -279801490320057},
                                    {-687111563546109, 1109751714395615, 970981785727727},
                                    {299675448635101, -487212938001902, -427977505002297}}},
                                  {{{502521709978672, -7085408548947, -316299454680025},
                                    {-757257520473093, 226304293957295, 1103907635021601},
                                    {-83301384253747, 40440382840468, 166658448390777}}},
                                  {{{420979273171655, 895469454421280, -796231187251912},
                                    {-382976142993176, 414583560076543, 773259422117762},
                                    {-276025338921058, -350844510217533, 531469710193715}}},
                                  {{{-776329648655920, 405875757007308, 451163530911887},
                                    {1110925908680653, -816217920512150, -704379618844418},
                                    {22325902753822, -63715613303333, -25966283001123}}}};
  Integers random;
  for (const auto& [u, v, w] : kUnimodular) {
    for (int i = 0; i < 100; ++i) {
      const auto a = i == 0 ? Vec3<double>{} : random.vector(50);
      ASSERT_EQ(orientation(a, a + u, a + v, a + w), 1);
      ASSERT_EQ(orientation(a, a + v, a + u, a + w), -1);
      ASSERT_EQ(orientation(a, a + u, a + v, a + (w + u)), 1);
      ASSERT_EQ(orientation(a, a + u, a + v, a + (v - u)), 0);
    }
  }
}

TEST(ExactPredicates, CrossSignIsThatOfIntegers) {
  Integers random;
  for (int i = 0; i < 20'000; ++i) {
    const int bits = 1 + i % 50;
    const auto a = random.vector(bits);
    const auto b = random.vector(bits);
    const auto c = random.vector(bits);
    auto d = random.vector(bits);
    if (i % 3 == 0) d = c + (b - a);  // parallel, as far as the sum is exact
    for (int axis = 0; axis < 3; ++axis) {
      const int j = (axis + 1) % 3;
      const int k = (axis + 2) % 3;
      const auto part = [](double x, double y) {
        return static_cast<Integer>(x) - static_cast<Integer>(y);
      };
      const Integer expected =
          part(b[j], a[j]) * part(d[k], c[k]) - part(b[k], a[k]) * part(d[j], c[j]);
      ASSERT_EQ(crossSign(a, b, c, d, axis), sign(expected));
    }
  }
}

TEST(ExactPredicates, NumbersWhoseProductsUnderflowHaveSigns) {
  const Vec3<double> a{0, 0, 0};
  const Vec3<double> b{1, 0, 0};
  const Vec3<double> c{0, 1, 0};
  for (const double height : {0x1p-330, 0x1p-341, 1e-130, 1e-200, 1e-300, 0x1p-1074}) {
    EXPECT_EQ(orientation(a, b, c, {0.25, 0.25, height}), 1) << height;
    EXPECT_EQ(orientation(a, b, c, {0.25, 0.25, -height}), -1) << height;
    EXPECT_EQ(orientation({0, 0, height}, {1, 0, height}, {0, 1, height}, {1, 1, height / 2}), -1);
    EXPECT_EQ(orientation({0, 0, height}, {1, 0, height}, {0, 1, height}, {1, 1, height}), 0);
    EXPECT_EQ(crossSign(a, b, a, {0.5, height, 0}, 2), 1) << height;
    EXPECT_EQ(crossSign({0, height, 0}, b, a, {1, -height, 0}, 2), 0) << height;
  }
}

/// The same integers as before, with a power of two for each axis; the signs stay.
TEST(ExactPredicates, OrientationInUnitsOfAnySize) {
  Integers random;
  for (int i = 0; i < 20'000; ++i) {
    const int bits = 1 + i % 39;
    const auto a = random.vector(bits);
    const auto b = random.vector(bits);
    auto c = random.vector(bits);
    const auto p = random.vector(bits);
    if (i % 5 == 0) c = a + (b - a) + (p - a);  // in a plane, as far as there are bits for it
    const auto exponent = [&] { return -1074 + static_cast<int>(random.below(1074)); };
    const std::array<int, 3> unit{exponent(), exponent(), exponent()};
    const auto scaled = [&](const Vec3<double>& v) {
      return Vec3<double>{std::ldexp(v.x, unit[0]), std::ldexp(v.y, unit[1]),
                          std::ldexp(v.z, unit[2])};
    };
    const int expected = sign(determinant(a, b, c, p));
    ASSERT_EQ(orientation(scaled(a), scaled(b), scaled(c), scaled(p)), expected);
    ASSERT_EQ(orientation(scaled(b), scaled(a), scaled(c), scaled(p)), -expected);
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(crossSign(scaled(a), scaled(b), scaled(c), scaled(p), axis),
                crossSign(a, b, c, p, axis));
    }
  }
}

TEST(ExactPredicates, PassageThroughTheInteriorTellsTheDirection) {
  const Triangle3 t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_EQ(passage({{0.2, 0.2, -1}, {0.2, 0.2, 1}}, t), 1);
  EXPECT_EQ(passage({{0.2, 0.2, 1}, {0.2, 0.2, -1}}, t), -1);
  EXPECT_EQ(passage({{0.2, 0.2, 1}, {0.2, 0.2, 2}}, t), 0);
  EXPECT_EQ(passage({{2, 2, 1}, {2, 2, -1}}, t), 0);
  EXPECT_EQ(passage({{-1, 0.2, 0}, {2, 0.2, 0}}, t), 0);     // in its plane
  EXPECT_EQ(passage({{0.2, 0.2, 0}, {0.2, 0.2, 0}}, t), 0);  // no length
  EXPECT_EQ(passage({{0.2, 0.2, -1}, {0.2, 0.2, 1}}, {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}), 0);
}

/// Cubes of a small integer lattice: every segment between lattice points is degenerate somehow.
class PassageThroughLattice : public ::testing::Test {
 protected:
  static std::vector<Triangle3> box(const Vec3<double>& lower, const Vec3<double>& upper) {
    const auto corner = [&](int i) { return Box<double>{lower, upper}.corner(i); };
    constexpr int kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    std::vector<Triangle3> triangles;
    for (const auto& q : kQuads) {
      triangles.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
      triangles.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
    }
    return triangles;
  }
};

TEST_F(PassageThroughLattice, ClosedSurfacesHaveAWindingNumberAlongEverySegment) {
  // The sum of passages depends on the ends alone. So it is the same along any two-segment detour.
  const auto surface = box({1, 1, 1}, {3, 4, 2});
  Integers random;
  const auto count = [&](const Vec3<double>& from, const Vec3<double>& to) {
    int sum = 0;
    for (const auto& t : surface) sum += passage({from, to}, t);
    return sum;
  };
  const auto lattice = [&] {
    return Vec3<double>{random.below(6), random.below(6), random.below(6)};
  };
  for (int i = 0; i < 20'000; ++i) {
    const auto a = lattice();
    const auto b = lattice();
    const auto c = lattice();
    ASSERT_EQ(count(a, b) + count(b, c), count(a, c)) << a << b << c;
    // Moved by (e, e^2, e^3), a lattice point is inside if 1 <= x < 3, 1 <= y < 4, 1 <= z < 2.
    const bool inside = a.x >= 1 && a.x < 3 && a.y >= 1 && a.y < 4 && a.z >= 1 && a.z < 2;
    ASSERT_EQ(count(a, {17, 23, 31}), inside ? 1 : 0) << a;
  }
}

TEST(ExactPredicates, OnTriangleMeansExactlyOn) {
  const Triangle3 t{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_TRUE(isOnTriangle({0.25, 0.25, 0.5}, t));
  EXPECT_TRUE(isOnTriangle({0.5, 0.5, 0}, t));  // on an edge
  EXPECT_TRUE(isOnTriangle({0, 0, 1}, t));      // a vertex
  EXPECT_FALSE(isOnTriangle({0.25, 0.25, std::nextafter(0.5, 1)}, t));
  EXPECT_FALSE(isOnTriangle({0.75, 0.75, -0.5}, t));
  EXPECT_FALSE(isOnTriangle({0.5, 0.5, 0}, {{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}));  // no area
}

}  // namespace
}  // namespace cutwater::test
