#include <Cutwater/Core/Detail/ParallelBatches.hpp>

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::detail::test {
namespace {

TEST(ParallelBatchesTest, CoverEveryIndexOnceFromMultiplesOfTheirSize) {
  constexpr std::size_t kSize = 16;
  for (const std::size_t count : {0U, 1U, 16U, 17U, 1003U}) {
    for (const std::size_t grain : {0U, 1U, 40U, 64U, 5000U}) {
      std::vector<std::atomic<int>> visits(count);
      parallelBatches(count, kSize, {.threads = 3, .grain = grain},
                      [&](std::size_t first, std::size_t batch) {
                        EXPECT_EQ(first % kSize, 0U);
                        EXPECT_EQ(batch, std::min(kSize, count - first));
                        for (auto i = first; i < first + batch; ++i) ++visits[i];
                      });
      for (const auto& times : visits) ASSERT_EQ(times.load(), 1);
    }
  }
}

}  // namespace
}  // namespace cutwater::detail::test
