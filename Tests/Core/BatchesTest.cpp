#include <Cutwater/Core/Detail/Batches.hpp>

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using Batch = std::pair<std::size_t, std::size_t>;

std::vector<Batch> batchesOf(std::size_t count, std::size_t size) {
  std::vector<Batch> result;
  detail::forBatches(
      count, size, [&](std::size_t first, std::size_t some) { result.emplace_back(first, some); });
  return result;
}

TEST(Batches, TheLastMayBeSmaller) {
  EXPECT_EQ(batchesOf(7, 3), (std::vector<Batch>{{0, 3}, {3, 3}, {6, 1}}));
  EXPECT_EQ(batchesOf(6, 3), (std::vector<Batch>{{0, 3}, {3, 3}}));
  EXPECT_EQ(batchesOf(2, 3), (std::vector<Batch>{{0, 2}}));
  EXPECT_TRUE(batchesOf(0, 3).empty());
}

}  // namespace
}  // namespace cutwater::test
