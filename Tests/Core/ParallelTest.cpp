#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace cutwater {
namespace {

TEST(Parallel, CoversEveryItemOnce) {
  for (const std::size_t grain : {0U, 1U, 7U, 5000U}) {
    std::vector<std::atomic<int>> visits(1003);
    parallelFor(visits.size(), {.threads = 3, .grain = grain},
                [&](std::size_t begin, std::size_t end) {
                  ASSERT_LE(end - begin, std::max<std::size_t>(grain, 1));
                  for (auto i = begin; i < end; ++i) ++visits[i];
                });
    for (const auto& count : visits) ASSERT_EQ(count.load(), 1);
  }
  parallelFor(0, {}, [](std::size_t, std::size_t) { FAIL() << "nothing to do"; });
}

TEST(Parallel, UsesAtMostTheThreadsAskedFor) {
  for (const int threads : {1, 2, 3}) {
    std::set<std::thread::id> seen;
    std::mutex guard;
    parallelFor(200, {.threads = threads}, [&](std::size_t, std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
      const std::scoped_lock lock(guard);
      seen.insert(std::this_thread::get_id());
    });
    EXPECT_LE(seen.size(), static_cast<std::size_t>(threads));
    if (threads == 1) {
      EXPECT_EQ(*seen.begin(), std::this_thread::get_id());
    }
  }
  EXPECT_THROW(parallelFor(1, {.threads = -1}, [](std::size_t, std::size_t) {}), Error);
  EXPECT_GE(availableThreads(), 1);
}

TEST(Parallel, StartsNoMoreThreadsThanAProcessCanHave) {
  std::atomic<std::size_t> items = 0;
  parallelFor(1U << 20U, {.threads = 1 << 20},
              [&](std::size_t begin, std::size_t end) { items += end - begin; });
  EXPECT_EQ(items.load(), 1U << 20U);
}

TEST(Parallel, RethrowsTheFirstExceptionAndStops) {
  for (const int threads : {1, 3}) {
    std::atomic<int> calls = 0;
    const auto failing = [&](std::size_t begin, std::size_t) {
      ++calls;
      if (begin == 10) throw std::out_of_range("item 10");
    };
    EXPECT_THROW(parallelFor(1000000, {.threads = threads}, failing), std::out_of_range);
    EXPECT_LT(calls.load(), 1000000);
  }
}

TEST(Parallel, IsSerialWithinItself) {
  std::atomic<int> wrong = 0;
  parallelFor(8, {.threads = 2}, [&](std::size_t, std::size_t) {
#ifdef _OPENMP
    if (omp_in_parallel() == 0) return;  // the outer loop had one thread only
    if (availableThreads() != 1) ++wrong;
#endif
    const auto outer = std::this_thread::get_id();
    parallelFor(50, {.threads = 4}, [&](std::size_t, std::size_t) {
      if (std::this_thread::get_id() != outer) ++wrong;
    });
  });
  EXPECT_EQ(wrong.load(), 0);
}

TEST(Parallel, ReportsProgressFromTheStartingThread) {
  for (const int threads : {1, 3}) {
    std::vector<double> fractions;
    const auto starter = std::this_thread::get_id();
    parallelFor(100,
                {.threads = threads,
                 .progress =
                     [&](double fraction) {
                       EXPECT_EQ(std::this_thread::get_id(), starter);
                       fractions.push_back(fraction);
                     }},
                [](std::size_t, std::size_t) {});
    ASSERT_FALSE(fractions.empty());
    EXPECT_EQ(fractions.back(), 1.0);
    for (std::size_t i = 1; i < fractions.size(); ++i) EXPECT_LE(fractions[i - 1], fractions[i]);
  }
}

TEST(Parallel, ReportsProgressWithinAnotherRegionToo) {
  // Each thread of the outer loop starts work of its own, and hears of all of it.
  std::atomic<int> reports = 0;
  parallelFor(3, {.threads = 3}, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; ++begin) {
      parallelFor(10, {.progress = [&](double) { ++reports; }}, [](std::size_t, std::size_t) {});
    }
  });
  EXPECT_EQ(reports.load(), 3 * (10 + 1));  // after each range, and in the end
}

}  // namespace
}  // namespace cutwater
