#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Tpms/Detail/LargestRadius.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

/// r K(r) = change in closed form.
TEST(LargestRadiusTest, IsWhereWhatChangesReachesTheLevel) {
  const auto find = [](auto mostChange, double change) {
    return detail::largestRadius<double>(mostChange, change);
  };
  EXPECT_EQ(find([](double) { return 4.0; }, 2), 0.5);
  // r / (1 - r) = 3
  EXPECT_NEAR(find([](double r) { return r < 1 ? 1 / (1 - r) : Box<double>::kInf; }, 3), 0.75,
              1e-15);
  // A jump: 1 up to 0.3, then 100.
  EXPECT_NEAR(find([](double r) { return r < 0.3 ? 1.0 : 100.0; }, 2), 0.3, 1e-15);
  // r (1 + r) = 6
  EXPECT_NEAR(find([](double r) { return 1 + r; }, 6), 2, 1e-15);
  EXPECT_EQ(find([](double) { return Box<double>::kInf; }, 1), 0);
  EXPECT_EQ(find([](double) { return 1.0; }, 0), 0);
}

}  // namespace
}  // namespace cutwater::test
