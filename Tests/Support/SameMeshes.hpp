#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>

#include "Support/Random.hpp"
#include "Support/SameClosestPoints.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {

inline void expectSameReport(const SignReport& a, const SignReport& b) {
  EXPECT_EQ(a.scheme, b.scheme);
  EXPECT_EQ(a.unbalancedEdges, b.unbalancedEdges);
  EXPECT_EQ(a.shells, b.shells);
  EXPECT_EQ(a.turnedFaces, b.turnedFaces);
  EXPECT_EQ(a.turnedShells, b.turnedShells);
  EXPECT_EQ(a.unorientable, b.unorientable);
  EXPECT_EQ(a.probes, b.probes);
  EXPECT_EQ(a.unsound, b.unsound);
  EXPECT_EQ(a.ambiguous, b.ambiguous);
  EXPECT_EQ(a.selfIntersections, b.selfIntersections);
  EXPECT_EQ(a.touchingEdges, b.touchingEdges);
  EXPECT_EQ(a.isProven, b.isProven);
}

/// Points around the surface and, from its vertices, at distances down to its rounding.
template <typename T>
std::vector<Vec3<T>> probesOf(const MeshSDF<T>& mesh) {
  const auto box = mesh.surfaceBox();
  const T size = box.diagonal();
  RandomPoints<T> random(1);
  std::vector<Vec3<T>> result;
  for (int i = 0; i < scaled(400); ++i) {
    result.push_back(box.center() + T(0.75) * size * random.next());
    const auto id =
        static_cast<std::uint32_t>(static_cast<std::size_t>(i) * 7919U % mesh.triangleCount());
    const auto [a, b, c] = mesh.triangle(id);
    const T away = size * std::pow(T(10), T(-(i % 7)));
    result.push_back((a + b + c) / T(3) + away * random.next());
    if (i % 8 == 0) result.push_back(a);
  }
  return result;
}

/// Of two meshes. In trees of another shape, bounds of the same boxes are searched for in another
/// order, and may end a thousandth of their distance from the surface apart.
enum class Trees { Same, Different };

/// Everything that can be asked.
template <typename T>
void expectSame(const MeshSDF<T>& mesh, const MeshSDF<T>& expected, Trees trees = Trees::Same) {
  const auto isAlike = [apart = trees == Trees::Same ? T(0) : T(0.001)](T value, T other) {
    return value == other || std::abs(value - other) <= apart * std::abs(other);
  };
  expectSameReport(mesh.signReport(), expected.signReport());
  EXPECT_EQ(mesh.boundingBox(), expected.boundingBox());
  EXPECT_EQ(mesh.patchNames(), expected.patchNames());
  ASSERT_EQ(mesh.triangleCount(), expected.triangleCount());
  for (std::uint32_t id = 0; id < expected.triangleCount(); ++id) {
    ASSERT_EQ(mesh.triangle(id), expected.triangle(id)) << id;
  }
  int wrong = 0;
  for (const auto& p : probesOf(expected)) {
    const auto differing = differingFields(mesh.closestPoint(p), expected.closestPoint(p));
    EXPECT_EQ(differing, "") << "at " << p;
    const Box<T> box{p, p + T(0.125) * expected.surfaceBox().size()};
    const auto [lower, upper] = mesh.bounds(box);
    const auto bounds = expected.bounds(box);
    EXPECT_TRUE(isAlike(lower, bounds.lower)) << lower << ", not " << bounds.lower << " at " << p;
    EXPECT_TRUE(isAlike(upper, bounds.upper)) << upper << ", not " << bounds.upper << " at " << p;
    EXPECT_EQ(mesh.classify(box), expected.classify(box)) << p;
    const Segment<T> across{p, expected.surfaceBox().center()};
    const auto any = [](const auto&) { return true; };
    EXPECT_EQ(mesh.crossings(across, any).found, expected.crossings(across, any).found) << p;
    if (::testing::Test::HasFailure() && ++wrong > 3) return;
  }
}

}  // namespace cutwater::test
