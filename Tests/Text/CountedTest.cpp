#include <Cutwater/Text/Counted.hpp>

#include <gtest/gtest.h>

namespace cutwater {
namespace {

TEST(Counted, CountsInWords) {
  EXPECT_EQ(detail::counted(0, "face", "faces"), "0 faces");
  EXPECT_EQ(detail::counted(1, "face", "faces"), "1 face");
  EXPECT_EQ(detail::counted(4'000'000'000, "vertex", "vertices"), "4000000000 vertices");
}

}  // namespace
}  // namespace cutwater
