// Geometry files that are wrong although their checksums are not: no query is to suffer from them.

#include <random>

#include "Mesh/ForgedBytes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class GeometryCheckTest : public ::testing::Test {};
TYPED_TEST_SUITE(GeometryCheckTest, Precisions);

TYPED_TEST(GeometryCheckTest, IndicesAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  for (std::size_t array = 0; array < kArrays; ++array) {
    const bool mayBeEmpty = array == InsideOut || array == Hulls || array == HullsOfNode;
    ASSERT_TRUE(mayBeEmpty || bytes.count(array) > 0) << array;
  }
  const auto count = [&](std::size_t array) {
    return static_cast<std::uint32_t>(bytes.count(array));
  };
  const auto expectRefused = [&](std::size_t at, auto number, const char* why) {
    EXPECT_EQ(refusalWith<T>(bytes, at, number),
              std::string("the geometry file is damaged: ") + why);
  };
  for (const std::size_t i : {std::size_t{0}, bytes.count(Triangles) - 1}) {
    for (std::size_t k = 0; k < 12; k += 4) {
      expectRefused(bytes.place(Triangles, i) + k, count(Positions),
                    "a triangle's corner is no vertex");
      expectRefused(bytes.place(Triangles, i) + k, kNone, "a triangle's corner is no vertex");
      expectRefused(bytes.place(Neighbours, i) + k, count(Triangles),
                    "a triangle's neighbour is no triangle");
      EXPECT_EQ(refusalWith<T>(bytes, bytes.place(Neighbours, i) + k, kNone), "");
    }
    expectRefused(bytes.place(PolygonIds, i), count(Patches), "a triangle is part of no polygon");
  }
  expectRefused(bytes.place(Patches, 5), 3U, "a polygon's patch is none");
  expectRefused(bytes.place(Patches, 5), kNone, "a polygon's patch is none");
  expectRefused(bytes.place(PatchNames, bytes.count(PatchNames) - 1), 'x',
                "the last patch name has no end");
  expectRefused(bytes.place(Positions, 3), std::numeric_limits<T>::quiet_NaN(),
                "a position is farther from the origin than the header tells");
  expectRefused(bytes.place(Positions, 3), T(1e18),
                "a position is farther from the origin than the header tells");
}

TYPED_TEST(GeometryCheckTest, TreesAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  constexpr const char* kNoLeaf = "the geometry file is damaged: a leaf holds what is no triangle";
  constexpr const char* kNotAll = "the geometry file is damaged: not every triangle is in one leaf";
  for (const auto& [nodes, slots, triangles] :
       {std::array{Nodes, Slots, Triangles}, std::array{CapNodes, CapSlots, CapTriangles}}) {
    for (std::size_t n = 0; n < bytes.count(nodes); ++n) {
      const auto node = bytes.place(nodes, n);
      for (const std::size_t index : {432U, 436U}) {  // firstNode, firstLeaf
        const auto before = bytes.read<std::uint32_t>(node + index);
        for (const auto wrong : {before + 1, before - 1, kNone, 0x80000000U}) {
          EXPECT_NE(refusalWith<T>(bytes, node + index, wrong), "") << n << ", " << wrong;
        }
      }
      for (const std::size_t mask : {440U, 442U}) {
        const auto before = bytes.read<std::uint16_t>(node + mask);
        for (unsigned bit = 0; bit < 16; ++bit) {
          const auto wrong = static_cast<std::uint16_t>(before ^ 1U << bit);
          EXPECT_NE(refusalWith<T>(bytes, node + mask, wrong), "") << n << ", " << bit;
        }
      }
    }
    const auto end = static_cast<std::uint32_t>(bytes.count(triangles));
    EXPECT_EQ(refusalWith<T>(bytes, bytes.place(slots), kNone), kNoLeaf);
    EXPECT_EQ(refusalWith<T>(bytes, bytes.place(slots), end), kNoLeaf);
    std::size_t last = bytes.count(slots);
    while (bytes.read<std::uint32_t>(bytes.place(slots, last - 1)) == kNone) --last;
    EXPECT_NE(refusalWith<T>(bytes, bytes.place(slots, last - 1), kNone), "");
    if (last == bytes.count(slots)) continue;
    EXPECT_EQ(refusalWith<T>(bytes, bytes.place(slots, last), 0U), kNotAll);
  }
}

TYPED_TEST(GeometryCheckTest, WindingsAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  const auto vertices = static_cast<std::uint32_t>(bytes.count(CapPositions));
  const auto edges = static_cast<std::uint32_t>(bytes.count(OpenEdges));
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(CapTriangles), vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(OpenEdges), vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(OpenEdges) + 4, vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(WindingEdges) + 4, edges + 1), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(CapPositions), HUGE_VAL), "");
  // Any byte stands for some winding number, or none.
  EXPECT_EQ(refusalWith<T>(bytes, bytes.place(Fronts), std::uint8_t{0xFF}), "");
  EXPECT_EQ(refusalWith<T>(bytes, bytes.place(SignCellBytes), std::uint8_t{0xFF}), "");
  const auto cells = bytes.count(SignCellBytes);
  ASSERT_NE(cells % 64, 0U);  // one more ends in the same line of 64 bytes
  EXPECT_EQ(
      refusalWith<T>(bytes, ForgedBytes::word(3 * SignCellBytes + 1), std::uint64_t{cells + 1}),
      "the geometry file is damaged: arrays that belong together are not of one length");
  // Finite, but what exact predicates make of it would not be.
  EXPECT_EQ(refusalWith<T>(bytes, ForgedBytes::word(3 * kArrays + 1), 1e200),  // the surface's size
            "the geometry file is damaged: its extent is larger than can be");
  EXPECT_EQ(
      refusalWith<T>(bytes, bytes.place(CapPositions), 1e200),
      "the geometry file is damaged: a cap's position is farther from the origin than can be");
}

TYPED_TEST(GeometryCheckTest, LeavesMustHoldSomething) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(tessellation::icosphere(1, 4)).toBytes().bytes());
  constexpr std::size_t kWidth = 16;
  const auto idAt = [&](std::size_t i) {
    return bytes.template read<std::uint32_t>(bytes.place(Slots, i));
  };
  // The ids of the first leaf go where others have room: every triangle still is in one leaf.
  std::size_t rest = kWidth;
  while (idAt(rest - 1) == kNone) --rest;
  for (std::size_t i = kWidth + 1; i < bytes.count(Slots) && rest > 0; ++i) {
    if (idAt(i) != kNone || idAt(i - 1) == kNone) continue;
    bytes.write(bytes.place(Slots, i), idAt(--rest));
    bytes.write(bytes.place(Slots, rest), kNone);
  }
  ASSERT_EQ(rest, 0U);
  bytes.makeGood();
  EXPECT_EQ(refusal<T>(bytes.bytes()),
            "the geometry file is damaged: a leaf holds what is no triangle");
}

TYPED_TEST(GeometryCheckTest, ALaneIsANodeOrALeaf) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(tessellation::icosphere(1, 4)).toBytes().bytes());
  int tried = 0;
  for (std::size_t n = 0; n < bytes.count(Nodes); ++n) {
    const auto at = bytes.place(Nodes, n) + 440;
    const auto nodes = bytes.template read<std::uint16_t>(at);
    const auto leaves = bytes.template read<std::uint16_t>(at + 2);
    if (nodes == 0 || leaves == 0 || ++tried > 3) continue;
    // As many of each, but a lane of both.
    const auto both = (nodes & (nodes - 1U)) | (leaves & (0U - leaves));
    EXPECT_EQ(refusalWith<T>(bytes, at, static_cast<std::uint16_t>(both)),
              "the geometry file is damaged: a tree's node does not follow the ones before it");
  }
  EXPECT_GT(tried, 0);
}

TYPED_TEST(GeometryCheckTest, DepthsAndLengthsMustFit) {
  using T = TypeParam;
  const auto intact = MeshSDF<T>(openBoxOfPatches()).toBytes();
  ForgedBytes bytes(intact.bytes());
  for (const std::size_t i : {3 * kArrays + 12, 3 * kArrays + 17}) {  // of the trees
    const auto at = ForgedBytes::word(i);
    const auto depth = bytes.template read<std::uint64_t>(at);
    ASSERT_TRUE(1 <= depth && depth <= 3) << depth;
    for (const auto wrong : {depth - 1, depth + 1}) {
      EXPECT_EQ(refusalWith<T>(bytes, at, wrong),
                "the geometry file is damaged: a tree is not as deep as the header tells");
    }
    EXPECT_EQ(refusalWith<T>(bytes, at, std::uint64_t{64}),
              "the geometry file is damaged: a tree is deeper than can be");
  }
  std::vector<std::byte> longer(intact.bytes().begin(), intact.bytes().end());
  longer.resize(longer.size() + 64);
  ForgedBytes more(longer);
  more.write(32, std::uint64_t{longer.size()});
  more.makeGood();
  EXPECT_EQ(refusal<T>(more.bytes()), "the geometry file is damaged: its arrays do not fill it");
}

/// Asks what reads every kind of array.
template <typename T>
void ask(const MeshSDF<T>& mesh) {
  RandomPoints<T> random(3, 5);
  for (int i = 0; i < 4; ++i) {
    const auto p = random.next();
    static_cast<void>(mesh.closestPoint(p));
    static_cast<void>(mesh.classify({p, p + Vec3<T>{1, 1, 1}}));
    mesh.crossings({p, -p}, [](const auto&) { return true; });
  }
  static_cast<void>(mesh.patchNames());
  static_cast<void>(mesh.soup());
}

TYPED_TEST(GeometryCheckTest, HeadersAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  std::size_t refused = 0;
  std::size_t tried = 0;
  for (std::size_t i = 0; i < bytes.wordCount(); ++i) {
    const auto before = bytes.template read<std::uint64_t>(ForgedBytes::word(i));
    for (const auto wrong :
         {before + 1, before - 1, before + 64, ~std::uint64_t{0}, std::uint64_t{1} << 63U,
          std::uint64_t{1} << 32U, (std::uint64_t{1} << 60U) + before,
          std::bit_cast<std::uint64_t>(-HUGE_VAL), std::bit_cast<std::uint64_t>(std::nan(""))}) {
      bytes.write(ForgedBytes::word(i), wrong);
      bytes.makeGood();
      ++tried;
      const auto why = refusal<T>(bytes.bytes());
      refused += !why.empty();
      // A count that is one off may still end in the same line of 64 bytes.
      const bool isCount = i % 3 == 1 && wrong <= before + 64;
      if (i < 3 * kArrays && !isCount) {
        EXPECT_NE(why, "") << "word " << i << ", " << wrong;
      }
      if (why.empty()) ask(MeshSDF<T>::view(bytes.bytes()));
    }
    bytes.write(ForgedBytes::word(i), before);
  }
  EXPECT_GT(refused, tried * 2 / 3);
}

TYPED_TEST(GeometryCheckTest, ForgedIndicesAreRefusedOrHarmless) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  std::mt19937_64 engine(3);
  std::size_t refused = 0;
  for (int i = 0; i < scaled(400); ++i) {
    constexpr std::array kIndices{Triangles, Neighbours, Slivers,      PolygonIds,
                                  Patches,   Slots,      CapTriangles, CapSlots};
    const auto array = kIndices[engine() % kIndices.size()];
    const auto numbers = bytes.count(array) * bytes.elementBytes(array) / 4;
    const auto at = bytes.place(array) + 4 * (engine() % numbers);
    const auto before = bytes.template read<std::uint32_t>(at);
    const auto limit = engine() % 2 == 0 ? 64 : std::uint64_t{1} << 32U;
    bytes.write(at, static_cast<std::uint32_t>(engine() % limit));
    bytes.makeGood();
    const auto why = refusal<T>(bytes.bytes());
    refused += !why.empty();
    if (why.empty()) ask(MeshSDF<T>::view(bytes.bytes()));
    bytes.write(at, before);
  }
  EXPECT_GT(refused, 100U);
}

}  // namespace
}  // namespace cutwater::test
