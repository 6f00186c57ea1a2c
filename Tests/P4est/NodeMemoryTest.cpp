#include <Cutwater/P4est/Detail/NodeMemory.hpp>

#include <algorithm>
#include <cstdint>
#include <fstream>

#include "Ranks.hpp"

namespace cutwater::test {
namespace {

std::vector<std::byte> pattern(std::size_t size) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * i % 251);
  return bytes;
}

/// Of this process, in pages.
std::size_t addressSpace() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages;
}

TEST(NodeMemoryTest, EveryRankSeesTheBytesOfRank0) {
  for (const std::size_t size : {0U, 1U, 64U, 100'001U}) {
    for (const int ranksPerCopy : {0, 1, 2, 3}) {
      const auto expected = pattern(size);
      const auto own = ownRank() == 0 ? expected : std::vector<std::byte>(7);
      const detail::NodeMemory memory(MPI_COMM_WORLD, own, ranksPerCopy);
      const auto block = memory.block();
      EXPECT_TRUE(std::ranges::equal(block.bytes(), expected));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.bytes().data()) % BlockWriter::kAlignment,
                0U);
    }
  }
}

/// What one rank writes, those see that share the copy, and no others.
TEST(NodeMemoryTest, RanksShareOneCopy) {
  const std::vector<std::byte> bytes(4096);
  for (const int ranksPerCopy : {0, 1, 2}) {
    const detail::NodeMemory memory(MPI_COMM_WORLD, bytes, ranksPerCopy);
    EXPECT_EQ(memory.isWriter(),
              ranksPerCopy == 0 ? ownRank() == 0 : ownRank() % ranksPerCopy == 0);
    const auto block = memory.block();
    auto* marks = const_cast<std::byte*>(block.bytes().data());  // a test may
    marks[ownRank()] = std::byte{1};
    MPI_Barrier(MPI_COMM_WORLD);
    const auto count = std::ranges::count(block.bytes(), std::byte{1});
    const int together = ranksPerCopy == 0 ? rankCount() : ranksPerCopy;
    const int first = ownRank() / together * together;
    EXPECT_EQ(count, std::min(together, rankCount() - first));
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST(NodeMemoryTest, IsGivenBackUnlessInUse) {
  const std::vector<std::byte> bytes(std::size_t{1} << 24U, std::byte{7});
  const auto make = [&] { return detail::NodeMemory(MPI_COMM_WORLD, bytes).block().bytes()[5]; };
  EXPECT_EQ(make(), std::byte{7});  // what MPI keeps for itself from the first time on
  const auto before = addressSpace();
  for (int n = 0; n < 6; ++n) EXPECT_EQ(make(), std::byte{7});
  EXPECT_LT(addressSpace(), before + 2 * bytes.size() / 4096);
  // The last rank's copy keeps it for all, and the others must not wait for it.
  Block kept;
  {
    const detail::NodeMemory memory(MPI_COMM_WORLD, bytes);
    if (ownRank() == rankCount() - 1) kept = memory.block();
  }
  EXPECT_EQ(std::ranges::count(kept.bytes(), std::byte{7}),
            static_cast<std::ptrdiff_t>(kept.bytes().size()));
  EXPECT_EQ(kept.bytes().empty(), ownRank() != rankCount() - 1);
}

TEST(NodeMemoryTest, RefusesFewerThanNoRanks) {
  const std::vector<std::byte> bytes(8);
  expectAgreedError(ErrorKind::Argument,
                    [&] { const detail::NodeMemory memory(MPI_COMM_WORLD, bytes, -1); });
}

}  // namespace
}  // namespace cutwater::test
