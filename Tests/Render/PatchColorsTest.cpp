#include <Cutwater/Render/PatchColors.hpp>

#include <cstdlib>

#include <gtest/gtest.h>

#include "Colors.hpp"

namespace cutwater::test {
namespace {

TEST(PatchColorsTest, AreToldApart) {
  for (std::size_t a = 0; a < 36; ++a) {
    EXPECT_EQ(patchColor(a), patchColor(a + 36));
    for (std::size_t b = 0; b < a; ++b) {
      const bool both = a / 12 == b / 12;
      EXPECT_GT(difference(patchColor(a), patchColor(b)), both ? 45 : 12) << a << ' ' << b;
    }
  }
}

TEST(PatchColorsTest, HaveNamesAndNumbers) {
  EXPECT_EQ(colorNamed("#4a90D9"), (Rgb{0x4a, 0x90, 0xd9}));
  for (const auto* name : {"steel", "white", "grey", "graphite", "sand", "copper"}) {
    EXPECT_TRUE(colorNamed(name)) << name;
  }
  const auto red = colorNamed("red").value_or(Rgb{});
  EXPECT_GT(red.red, red.green + 60);
  const auto blue = colorNamed("blue").value_or(Rgb{});
  EXPECT_GT(blue.blue, blue.red + 60);
  for (const auto* name : {"", "mauve", "Steel", "#12345", "#1234567", "#12345g", "#-12345"}) {
    EXPECT_FALSE(colorNamed(name)) << name;
  }
}

}  // namespace
}  // namespace cutwater::test
