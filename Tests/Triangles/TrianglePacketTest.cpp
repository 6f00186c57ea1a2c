// The boxes of packets; what the search makes of packets is in TriangleSearchTest.cpp.

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Triangles/Search/TrianglePacket.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using Corners = std::array<Vec3<double>, 3>;

/// How far corners reach beyond the packet's box, and how far the box beyond them, at most.
std::array<double, 2> overhangs(std::span<const Corners> triangles) {
  const auto packet = packTriangles(triangles);
  Vec3<double> reach;
  for (const auto& triangle : triangles) {
    for (const auto& corner : triangle) {
      reach = max(reach, abs(detail::along(packet.axes, corner - Vec3<double>(packet.center))));
    }
  }
  const auto rest = Vec3<double>(packet.half) - reach;
  return {maxComponent(-rest), maxComponent(rest)};
}

/// Of triangles of all shapes, turned anyhow, small and far from the origin.
TEST(TrianglePacketTest, BoxesHoldTheCornersAndFitThem) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto point = [&] { return Vec3<double>{number(random), number(random), number(random)}; };
  for (int round = 0; round < 2000; ++round) {
    const auto middle = point();
    const double size = std::ldexp(1.0, -static_cast<int>(random() % 40U));
    std::vector<Corners> triangles(1 + random() % TrianglePacket::kWidth);
    const Vec3<double> flat{1, round % 3 == 0 ? 1e-9 : 1, round % 2 == 0 ? 0.0 : 1.0};
    RigidTransform<double> turn;
    turn.rotate(180 * number(random), point());
    for (auto& triangle : triangles) {
      for (auto& corner : triangle) {
        const auto p = point();
        corner =
            middle + size * turn.toWorld(Vec3<double>{flat.x * p.x, flat.y * p.y, flat.z * p.z});
      }
    }
    const auto [outside, spare] = overhangs(triangles);
    ASSERT_LT(outside, 0) << round;
    ASSERT_LT(spare, 1e-6 * size + 1e-6) << round;  // the centre is rounded to single precision
  }
}

TEST(TrianglePacketTest, BoxesOfTrianglesWithoutAreaHoldThem) {
  const Vec3<double> p{0.3, -0.7, 0.9};
  EXPECT_LT(overhangs(std::vector<Corners>{{p, p, p}})[0], 0);
  const Vec3<double> way{0.1, 0.2, -0.3};
  EXPECT_LT(overhangs(std::vector<Corners>{{p, p + way, p + 2.0 * way}, {p, p, p}})[0], 0);
}

}  // namespace
}  // namespace cutwater::test
