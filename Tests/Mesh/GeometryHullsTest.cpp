// Geometry files of meshes whose trees have hulls; see ChildHulls.

#include <Cutwater/Triangles/Search/TrianglePacket.hpp>

#include "Mesh/ForgedBytes.hpp"
#include "Support/Precisions.hpp"
#include "Support/SameMeshes.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class GeometryHullsTest : public ::testing::Test {};
TYPED_TEST_SUITE(GeometryHullsTest, Precisions);

TYPED_TEST(GeometryHullsTest, AreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  const MeshSDF<T> mesh(bipyramid(1000));
  ForgedBytes bytes(mesh.toBytes().bytes());
  const auto hulls = static_cast<std::uint32_t>(bytes.count(Hulls));
  ASSERT_GT(hulls, 0U);
  ASSERT_EQ(bytes.count(HullsOfNode), bytes.count(Nodes));
  for (std::size_t n = 0; n < bytes.count(Nodes); ++n) {
    const auto at = bytes.place(HullsOfNode, n);
    for (const auto wrong : {hulls, kNone - 1, 0x80000000U}) {
      EXPECT_EQ(refusalWith<T>(bytes, at, wrong),
                "the geometry file is damaged: a node's hulls are none");
    }
    EXPECT_EQ(refusalWith<T>(bytes, at, kNone), "");
  }
  const auto count = ForgedBytes::word(std::size_t{3} * HullsOfNode + 1);
  ASSERT_NE(bytes.count(Nodes) % 16, 0U);  // one more ends in the same line of 64 bytes
  EXPECT_EQ(refusalWith<T>(bytes, count, std::uint64_t{bytes.count(Nodes) + 1}),
            "the geometry file is damaged: arrays that belong together are not of one length");

  // Without a hull of its own, a node is found by its box: the same answers.
  for (std::size_t n = 0; n < bytes.count(Nodes); ++n) {
    bytes.write(bytes.place(HullsOfNode, n), kNone);
  }
  bytes.makeGood();
  expectSame(MeshSDF<T>::view(bytes.bytes()), mesh);
}

/// How many triangles' centroids are not on the surface, by what the mesh answers.
template <typename T>
int missing(const MeshSDF<T>& mesh) {
  int count = 0;
  for (std::uint32_t id = 0; id < mesh.triangleCount(); ++id) {
    const auto [a, b, c] = mesh.triangle(id);
    count += std::abs(mesh.signedDistance((a + b + c) / T(3))) > T(1e-4) ? 1 : 0;
  }
  return count;
}

TYPED_TEST(GeometryHullsTest, OfAFileAreThoseThatAreSearched) {
  using T = TypeParam;
  const MeshSDF<T> mesh(bipyramid(1000));
  ForgedBytes bytes(mesh.toBytes().bytes());
  // The last ones, of a node that has few triangles, pretend to be far away.
  const auto center = bytes.place(Hulls, bytes.count(Hulls) - 1) + offsetof(TrianglePacket, center);
  for (const std::size_t axis : {0U, 1U, 2U}) bytes.write(center + 4 * axis, 1000.0F);
  bytes.makeGood();
  EXPECT_EQ(missing(mesh), 0);
  const int lost = missing(MeshSDF<T>::view(bytes.bytes()));
  EXPECT_GT(lost, 0);
  EXPECT_LE(lost, 16 * 16);
}

}  // namespace
}  // namespace cutwater::test
