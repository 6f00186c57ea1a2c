// Geometry files that are damaged, cut or made up are found out.

#include <Cutwater/Core/Checksum.hpp>

#include <random>

#include "Mesh/GeometryFiles.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

constexpr std::size_t kHead = 64;
constexpr std::size_t kBlockChecksum = 48;

template <typename T>
class GeometryDamageTest : public ::testing::Test {};
TYPED_TEST_SUITE(GeometryDamageTest, Precisions);

/// Bytes whose checksums are made good after a change: what only a forger would do.
class ForgedBytes : public EditableBytes {
 public:
  using EditableBytes::EditableBytes;

  [[nodiscard]] std::size_t headerBytes() const { return read<std::uint64_t>(24); }
  /// Of word i behind the first bytes.
  [[nodiscard]] static std::size_t word(std::size_t i) { return kHead + 8 * i; }
  [[nodiscard]] std::size_t wordCount() const { return (headerBytes() - kHead) / 8 - 1; }
  /// Of element i, `element` bytes long, of an array as the header lists them.
  [[nodiscard]] std::size_t place(std::size_t array, std::size_t i = 0) const {
    return headerBytes() + read<std::uint64_t>(word(3 * array)) + i * elementBytes(array);
  }
  [[nodiscard]] std::size_t count(std::size_t array) const {
    return read<std::uint64_t>(word(3 * array + 1));
  }
  [[nodiscard]] std::size_t elementBytes(std::size_t array) const {
    return read<std::uint64_t>(word(3 * array + 2));
  }
  void makeGood() {
    write(kBlockChecksum, checksum(bytes().subspan(headerBytes())));
    write(headerBytes() - 8, xxHash64(bytes().first(headerBytes() - 8)));
  }
};

enum ArrayOf : std::size_t {
  kPositions,
  kTriangles,
  kNeighbours,
  kSlivers,
  kPseudonormals,
  kPolygons,
  kPatches,
  kNodes,
  kSlots,
  kPackets,
  kCapPositions,
  kCapTriangles,
  kCapNodes,
  kCapSlots,
  kMoments,
  kWindingEdges,
  kOpenEdges,
  kInsideOut,
  kPatchNames,
  kArrays
};

/// What it says when `Number` stands there instead; the bytes are as before afterwards.
template <typename T, typename Number>
std::string refusalWith(ForgedBytes& bytes, std::size_t at, Number number) {
  const auto before = bytes.read<Number>(at);
  bytes.write(at, number);
  bytes.makeGood();
  const auto result = refusal<T>(bytes.bytes());
  bytes.write(at, before);
  bytes.makeGood();
  return result;
}

TYPED_TEST(GeometryDamageTest, RandomDamageIsFound) {
  using T = TypeParam;
  EditableBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  const std::size_t size = bytes.bytes().size();
  ASSERT_EQ(refusal<T>(bytes.bytes()), "");
  std::mt19937_64 engine(1);
  for (int i = 0; i < scaled(5000); ++i) {
    const std::size_t at = engine() % size;
    const auto before = bytes[at];
    bytes[at] ^= std::byte{1} << engine() % 8;
    EXPECT_NE(refusal<T>(bytes.bytes()), "") << "bit of byte " << at;
    bytes[at] = before ^ static_cast<std::byte>(1 + engine() % 255);
    EXPECT_NE(refusal<T>(bytes.bytes()), "") << "byte " << at;
    bytes[at] = before;
    const std::size_t cut = engine() % size;
    EXPECT_NE(refusal<T>(bytes.bytes().first(cut)), "") << "cut to " << cut;
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(refusal<T>(bytes.bytes()), "");
}

TYPED_TEST(GeometryDamageTest, DamageToManyBytesIsFound) {
  using T = TypeParam;
  EditableBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  const std::vector<std::byte> intact(bytes.bytes().begin(), bytes.bytes().end());
  std::mt19937_64 engine(2);
  for (int i = 0; i < scaled(300); ++i) {
    // A range of zeros or of noise, as a lost block of a disk; or two ranges that changed places.
    const std::size_t length = 8 + engine() % 512;
    const std::size_t at = engine() % (intact.size() - length);
    const std::size_t other = engine() % (intact.size() - length);
    if (i % 3 == 0) std::fill_n(bytes.data() + at, length, std::byte{0});
    if (i % 3 == 1) std::generate_n(bytes.data() + at, length, [&] { return std::byte(engine()); });
    if (i % 3 == 2) {
      std::ranges::copy(std::span(intact).subspan(other, length), bytes.data() + at);
    }
    const bool isChanged = !std::ranges::equal(bytes.bytes(), intact);
    EXPECT_EQ(!refusal<T>(bytes.bytes()).empty(), isChanged) << i;
    std::ranges::copy(intact, bytes.data());
  }
}

TYPED_TEST(GeometryDamageTest, EveryByteOfTheHeaderCounts) {
  using T = TypeParam;
  EditableBytes bytes(MeshSDF<T>(tetrahedron()).toBytes().bytes());
  const auto headerBytes = bytes.template read<std::uint64_t>(24);
  ASSERT_LT(headerBytes, 2000U);
  for (std::size_t at = 0; at < headerBytes; ++at) {
    bytes[at] ^= std::byte{0x10};
    EXPECT_NE(refusal<T>(bytes.bytes(), {.verifyPayload = false}), "") << at;
    bytes[at] ^= std::byte{0x10};
  }
  for (std::size_t size = 0; size < bytes.bytes().size(); ++size) {
    EXPECT_NE(refusal<T>(bytes.bytes().first(size), {.verifyPayload = false}), "") << size;
  }
}

TYPED_TEST(GeometryDamageTest, ThePayloadIsLeftToOthersIfTheySaySo) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(tetrahedron()).toBytes().bytes());
  const auto at = bytes.place(kPositions) + sizeof(T) - 1;  // an exponent of the first position
  bytes[at] ^= std::byte{0x01};
  EXPECT_EQ(refusal<T>(bytes.bytes()),
            "the geometry file is damaged: the checksum of its arrays is another");
  EXPECT_EQ(refusal<T>(bytes.bytes(), {.verifyPayload = false}), "");
}

TYPED_TEST(GeometryDamageTest, LargeFilesAreCheckedToTheirEnd) {
  using T = TypeParam;
  EditableBytes bytes(MeshSDF<T>(tessellation::icosphere(1, 5)).toBytes().bytes());
  const std::size_t size = bytes.bytes().size();
  ASSERT_GT(size, std::size_t{1} << 21U);
  EXPECT_EQ(refusal<T>(bytes.bytes()), "");
  for (std::size_t i = 1; i <= 16; ++i) {
    bytes[size * i / 16 - 1] ^= std::byte{0x80};
    for (const int threads : {1, 2}) {
      EXPECT_NE(refusal<T>(bytes.bytes(), {.threads = threads}), "") << i << ", " << threads;
    }
    bytes[size * i / 16 - 1] ^= std::byte{0x80};
  }
}

TYPED_TEST(GeometryDamageTest, SaysWhatAFileIsThatFitsNot) {
  using T = TypeParam;
  using Other = std::conditional_t<sizeof(T) == 4, double, float>;
  EditableBytes bytes(MeshSDF<T>(tetrahedron()).toBytes().bytes(), 64);
  EXPECT_EQ(refusal<Other>(bytes.bytes()),
            sizeof(T) == 4 ? "the geometry file is of single precision, not double"
                           : "the geometry file is of double precision, not single");
  bytes.write(8, std::uint32_t{kGeometryFileVersion + 6});
  EXPECT_EQ(refusal<T>(bytes.bytes()),
            "the geometry file has version 7, this library reads version 1: prepare it anew");
  bytes.write(8, std::uint32_t{kGeometryFileVersion});
  bytes.write(12, std::uint32_t{0x04030201});
  EXPECT_EQ(refusal<T>(bytes.bytes()),
            "the geometry file was written on a machine with another byte order");
  bytes.write(12, std::uint32_t{0x01020304});
  for (const std::size_t more : {1U, 8U, 64U}) {
    const std::span<const std::byte> longer(bytes.data(), bytes.bytes().size() + more);
    EXPECT_EQ(refusal<T>(longer),
              "the geometry file is damaged: it is longer than its header tells");
  }
  EXPECT_EQ(refusal<T>(bytes.bytes().first(bytes.bytes().size() - 1)),
            "the geometry file is damaged: it is shorter than its header tells");
  EXPECT_EQ(refusal<T>({}), "there is nothing in it");
}

TYPED_TEST(GeometryDamageTest, IndicesAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  for (std::size_t array = 0; array < kArrays; ++array) {
    ASSERT_TRUE(array == kInsideOut || bytes.count(array) > 0) << array;
  }
  const auto count = [&](std::size_t array) {
    return static_cast<std::uint32_t>(bytes.count(array));
  };
  const auto expectRefused = [&](std::size_t at, auto number, const char* why) {
    EXPECT_EQ(refusalWith<T>(bytes, at, number),
              std::string("the geometry file is damaged: ") + why);
  };
  for (const std::size_t i : {std::size_t{0}, bytes.count(kTriangles) - 1}) {
    for (std::size_t k = 0; k < 12; k += 4) {
      expectRefused(bytes.place(kTriangles, i) + k, count(kPositions),
                    "a triangle's corner is no vertex");
      expectRefused(bytes.place(kTriangles, i) + k, kNone, "a triangle's corner is no vertex");
      expectRefused(bytes.place(kNeighbours, i) + k, count(kTriangles),
                    "a triangle's neighbour is no triangle");
      EXPECT_EQ(refusalWith<T>(bytes, bytes.place(kNeighbours, i) + k, kNone), "");
    }
    expectRefused(bytes.place(kPolygons, i), count(kPatches), "a triangle is part of no polygon");
  }
  expectRefused(bytes.place(kPatches, 5), 3U, "a polygon's patch is none");
  expectRefused(bytes.place(kPatches, 5), kNone, "a polygon's patch is none");
  expectRefused(bytes.place(kPatchNames, bytes.count(kPatchNames) - 1), 'x',
                "the last patch name has no end");
  expectRefused(bytes.place(kPositions, 3), std::numeric_limits<T>::quiet_NaN(),
                "a position is farther from the origin than the header tells");
  expectRefused(bytes.place(kPositions, 3), T(1e18),
                "a position is farther from the origin than the header tells");
}

TYPED_TEST(GeometryDamageTest, TreesAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  constexpr const char* kNoLeaf = "the geometry file is damaged: a leaf holds what is no triangle";
  constexpr const char* kNotAll = "the geometry file is damaged: not every triangle is in one leaf";
  for (const auto& [nodes, slots, triangles] :
       {std::array{kNodes, kSlots, kTriangles}, std::array{kCapNodes, kCapSlots, kCapTriangles}}) {
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

TYPED_TEST(GeometryDamageTest, WindingsAreCheckedEvenWhereChecksumsAgree) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  const auto vertices = static_cast<std::uint32_t>(bytes.count(kCapPositions));
  const auto edges = static_cast<std::uint32_t>(bytes.count(kOpenEdges));
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(kCapTriangles), vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(kOpenEdges), vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(kOpenEdges) + 4, vertices), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(kWindingEdges) + 4, edges + 1), "");
  EXPECT_NE(refusalWith<T>(bytes, bytes.place(kCapPositions), HUGE_VAL), "");
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

TYPED_TEST(GeometryDamageTest, HeadersAreCheckedEvenWhereChecksumsAgree) {
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

TYPED_TEST(GeometryDamageTest, ForgedIndicesAreRefusedOrHarmless) {
  using T = TypeParam;
  ForgedBytes bytes(MeshSDF<T>(openBoxOfPatches()).toBytes().bytes());
  std::mt19937_64 engine(3);
  std::size_t refused = 0;
  for (int i = 0; i < scaled(400); ++i) {
    constexpr std::array kIndices{kTriangles, kNeighbours, kSlivers,      kPolygons,
                                  kPatches,   kSlots,      kCapTriangles, kCapSlots};
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
