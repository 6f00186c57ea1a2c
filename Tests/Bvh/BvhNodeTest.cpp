#include <Cutwater/Bvh/Detail/BvhNode.hpp>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using Node = BvhNode<16>;

/// A frame turned by any angles, rounded as the builder does.
Node turnedNode(RandomPoints<double>& random) {
  const auto u = normalized(random.next());
  const auto v = normalized(cross(u, random.next()));
  Node node{};
  node.center = static_cast<Vec3<float>>(random.next());
  node.axes = {static_cast<Vec3<float>>(u), static_cast<Vec3<float>>(v),
               static_cast<Vec3<float>>(cross(u, v))};
  return node;
}

TEST(BvhNodeTest, SinglePrecisionStaysWithinTheErrorItTells) {
  RandomPoints<double> random(1);
  double most = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Node node = turnedNode(random);
    // From far away to as near the centre as the frame's points are.
    const auto p = Vec3<double>(node.center) + std::ldexp(1.0, 20 - i % 60) * random.next();
    const auto exact = node.toLocal(p);
    const auto local = node.toLocalFloat(p);
    const auto off = abs(Vec3<double>(local.position) - exact);
    const double share = maxComponent(off) / double{local.error};
    ASSERT_LE(share, 5.0 / 6) << p;  // the rest is for the sum of a coordinate and its error
    most = std::max(most, share);
  }
  EXPECT_GT(most, 0.1);  // nor does it promise far too little
}

TEST(BvhNodeTest, TurnedFramesKeepLengths) {
  RandomPoints<double> random(1);
  for (int i = 0; i < 1000; ++i) {
    const Node node = turnedNode(random);
    const auto d = random.next();
    const auto local = node.toLocal(Vec3<double>(node.center) + d);
    EXPECT_NEAR(length(local), length(d), 0x1p-22 * length(d));
  }
}

TEST(BvhNodeTest, ChildrenAreCountedByKind) {
  Node node{};
  node.firstNode = 100;
  node.firstLeaf = 200;
  node.nodeMask = 0b10'0101;
  node.leafMask = 0b01'1010;
  EXPECT_EQ(node.childMask(), 0b11'1111U);
  EXPECT_EQ(node.nodeIndex(0), 100U);
  EXPECT_EQ(node.nodeIndex(5), 102U);
  EXPECT_EQ(node.leafIndex(1), 200U);
  EXPECT_EQ(node.leafIndex(4), 202U);
  EXPECT_TRUE(node.isLeaf(3));
  EXPECT_FALSE(node.isLeaf(2));
}

}  // namespace
}  // namespace cutwater::test
