#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <gtest/gtest.h>

namespace cutwater {
namespace {

template <typename... Values>
std::string messageOf(const char* message, const Values&... values) {
  try {
    require(false, message, values...);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Argument);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Error, NamesTheArgumentAndItsValue) {
  EXPECT_EQ(messageOf("Torus: need 0 < minor < major", Named{"minor", 2.5}, Named{"major", 1.0F}),
            "Torus: need 0 < minor < major (minor = 2.5, major = 1)");
  EXPECT_EQ(messageOf("no point", Named{"p", Vec3<double>{1, -2, 0.1}}),
            "no point (p = (1, -2, 0.1))");
  EXPECT_EQ(messageOf("bad count", Named{"count", 7}), "bad count (count = 7)");
  EXPECT_EQ(messageOf("bare"), "bare");
  EXPECT_EQ(messageOf("x", Named{"x", std::numeric_limits<double>::infinity()}), "x (x = inf)");
  EXPECT_NO_THROW(require(true, "fine", Named{"x", 1.0}));
}

TEST(Error, TellsItsKind) {
  EXPECT_EQ(Error(ErrorKind::File, "hull.stl: truncated").kind(), ErrorKind::File);
  EXPECT_STREQ(Error(ErrorKind::File, "hull.stl: truncated").what(), "hull.stl: truncated");
}

}  // namespace
}  // namespace cutwater
