#include <Cutwater/Core/Detail/MixedBits.hpp>

#include <array>
#include <set>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

/// As java.util.SplittableRandom, of which SplitMix64 is the core, gives them.
TEST(MixedBitsTest, AreTheNumbersOfSplitMix64) {
  constexpr std::array<std::uint64_t, 5> kOfSeed0{0xe220a8397b1dcdaf, 0x6e789e6aa1b965f4,
                                                  0x06c45d188009454f, 0xf88bb8a8724c81ec,
                                                  0x1b39896a51a8749b};
  std::uint64_t state = 0;
  for (const auto number : kOfSeed0) {
    EXPECT_EQ(detail::mixed(state += detail::kGoldenIncrement), number);
  }
}

TEST(MixedBitsTest, AreDistinct) {
  std::set<std::uint64_t> found;
  for (std::uint64_t n = 0; n < 1000; ++n) found.insert(detail::mixed(n));
  for (unsigned bit = 10; bit < 64; ++bit) found.insert(detail::mixed(std::uint64_t{1} << bit));
  EXPECT_EQ(found.size(), 1054U);
}

}  // namespace
}  // namespace cutwater::test
