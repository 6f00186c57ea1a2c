#include <Cutwater/CutCells/Detail/Curved/NearestFew.hpp>

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(NearestFewTest, AreTheFirstOfAllThatAreSorted) {
  constexpr std::size_t kMost = 7;
  std::mt19937 random(3);
  NearestFew<double, int> few(kMost);
  for (const int count : {0, 3, 7, 100}) {
    few.clear();
    std::vector<double> all;
    for (int i = 0; i < count; ++i) {
      all.push_back(std::uniform_real_distribution(0.0, 1.0)(random));
      few.add(all.back(), i);
    }
    const auto orders = all;
    std::ranges::sort(all);
    const auto found = few.sorted();
    ASSERT_EQ(found.size(), std::min(kMost, all.size()));
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].order, all[i]);
      EXPECT_EQ(orders[static_cast<std::size_t>(found[i].item)], all[i]);
    }
  }
}

TEST(NearestFewTest, AreToldWhetherAnotherIsNearer) {
  NearestFew<double, int> few(2);
  few.add(1, 0);
  EXPECT_TRUE(few.mayTake(5));
  few.add(3, 1);
  EXPECT_FALSE(few.mayTake(3));
  EXPECT_TRUE(few.mayTake(2));
}

}  // namespace
}  // namespace cutwater::test
