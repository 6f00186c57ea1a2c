// Geometry files that are damaged, cut or not what is wanted are found out.

#include <random>

#include "Mesh/GeometryFiles.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class GeometryDamageTest : public ::testing::Test {};
TYPED_TEST_SUITE(GeometryDamageTest, Precisions);

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
  EditableBytes bytes(MeshSDF<T>(tetrahedron()).toBytes().bytes());
  const auto headerBytes = bytes.template read<std::uint64_t>(24);
  const auto at = headerBytes + sizeof(T) - 1;  // an exponent of the first position
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
            "the geometry file has version 12, this library reads version 6: prepare it anew");
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

}  // namespace
}  // namespace cutwater::test
