#include <Cutwater/Core/Checksum.hpp>

#include <random>
#include <set>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

std::uint64_t hashOf(std::string_view text) {
  return xxHash64(std::as_bytes(std::span(text)));
}

std::vector<std::byte> noise(std::size_t size) {
  std::mt19937_64 engine(7);
  std::vector<std::byte> bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::byte>(engine());
  return bytes;
}

/// What the reference implementation, libxxhash 0.8, says.
TEST(XxHash64, IsThatOfTheSpecification) {
  EXPECT_EQ(hashOf(""), 0xef46db3751d8e999U);
  EXPECT_EQ(hashOf("a"), 0xd24ec4f1a98c6e5bU);
  EXPECT_EQ(hashOf("abc"), 0x44bc2cf5ad770999U);
  const std::string_view text =
      "It finds accidents, not forgeries: a change goes unnoticed w"
      "ith a probability of 2^-64.";
  EXPECT_EQ(hashOf(text.substr(0, 4)), 0x33597d9122996130U);
  EXPECT_EQ(hashOf(text.substr(0, 7)), 0xb2f7aa750b361c91U);
  EXPECT_EQ(hashOf(text.substr(0, 8)), 0xf73b07a486def9a9U);
  EXPECT_EQ(hashOf(text.substr(0, 31)), 0x944b3487eb3e9df3U);
  EXPECT_EQ(hashOf(text.substr(0, 32)), 0xfd39b15c4a5dab31U);
  EXPECT_EQ(hashOf(text.substr(0, 33)), 0x1e24a8aa5d20cfabU);
  EXPECT_EQ(hashOf(text.substr(0, 63)), 0xb9c829fe52c025f0U);
  EXPECT_EQ(hashOf(text.substr(0, 87)), 0x2c554c1fb56b8b19U);
}

TEST(XxHash64, DoesNotDependOnAlignment) {
  const auto bytes = noise(300);
  for (std::size_t shift = 0; shift < 16; ++shift) {
    std::vector<std::byte> moved(shift);
    moved.insert(moved.end(), bytes.begin(), bytes.end());
    EXPECT_EQ(xxHash64(std::span(moved).subspan(shift)), xxHash64(bytes)) << shift;
  }
}

TEST(Checksum, ChangesWithEveryBit) {
  for (const std::size_t size : {1U, 7U, 31U, 32U, 100U}) {
    auto bytes = noise(size);
    std::set<std::uint64_t> seen{checksum(bytes)};
    for (std::size_t bit = 0; bit < 8 * size; ++bit) {
      bytes[bit / 8] ^= std::byte{1} << bit % 8;
      EXPECT_TRUE(seen.insert(checksum(bytes)).second) << size << " bytes, bit " << bit;
      bytes[bit / 8] ^= std::byte{1} << bit % 8;
    }
  }
}

TEST(Checksum, ChangesWithTheLength) {
  const std::vector<std::byte> zeros((std::size_t{3} << 20U) + 40);
  std::set<std::uint64_t> seen;
  for (const std::size_t size : {0U, 1U, 8U, 32U, 1U << 20U, (1U << 20U) + 1, 3U << 20U}) {
    EXPECT_TRUE(seen.insert(checksum(std::span(zeros).first(size))).second) << size;
  }
}

TEST(Checksum, IsTheHashOfThePiecesHashesForAnyNumberOfThreads) {
  const auto bytes = noise((std::size_t{5} << 20U) + 12345);
  std::vector<std::uint64_t> pieces;
  for (std::size_t at = 0; at < bytes.size(); at += std::size_t{1} << 20U) {
    const auto rest = std::span(bytes).subspan(at);
    pieces.push_back(xxHash64(rest.first(std::min(rest.size(), std::size_t{1} << 20U))));
  }
  ASSERT_EQ(pieces.size(), 6U);
  const auto expected = xxHash64(std::as_bytes(std::span(pieces)));
  for (const int threads : {0, 1, 2, 3}) EXPECT_EQ(checksum(bytes, threads), expected) << threads;
}

TEST(Checksum, SeesPiecesThatChangedPlaces) {
  auto bytes = noise(std::size_t{2} << 20U);
  const auto before = checksum(bytes);
  const auto middle = bytes.begin() + (std::ptrdiff_t{1} << 20U);
  std::swap_ranges(bytes.begin(), middle, middle);
  EXPECT_NE(checksum(bytes), before);
}

}  // namespace
}  // namespace cutwater::test
