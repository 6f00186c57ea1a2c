#include <Cutwater/Io/Tables.hpp>

#include <clocale>
#include <fstream>

#include <gtest/gtest.h>

#include "TableFile.hpp"

namespace cutwater::test {
namespace {

using BallTableTest = TableFile<readBalls>;

TEST_F(BallTableTest, ReadsALinePerBall) {
  const std::vector<Ball<double>> expected{{{1, -2.5, 3e-3}, 0.1}, {{0, 0, 1e6}, 2}};
  EXPECT_EQ(read("1,-2.5,3e-3,0.1\n0,0,1e6,2\n"), expected);
  EXPECT_EQ(read("x,y,z,r\n1,-2.5,3e-3,0.1\n0,0,1e6,2"), expected);
  EXPECT_EQ(read("\xef\xbb\xbf# of a run\r\n\r\nX, Y, Z, Radius\r\n 1 ,\t-2.5, .003, "
                 "+0.1\r\n0,0,1e6,2\r\n"),
            expected);
}

TEST_F(BallTableTest, ScalesCentresAndRadii) {
  const std::vector<Ball<double>> expected{{{2, 4, 6}, 8}};
  EXPECT_EQ(read("1,2,3,4", {.scale = 2}), expected);
  EXPECT_THROW((void)read("1,2,3,4", {.scale = 0}), Error);
  EXPECT_THROW((void)read("1,2,3,4", {.scale = -1}), Error);
}

TEST_F(BallTableTest, ReadsTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const auto* const name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_NUMERIC, name);
  EXPECT_EQ(read("1.5,2,3,0.25")[0], (Ball<double>{{1.5, 2, 3}, 0.25}));
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST_F(BallTableTest, RefusesWhatIsNoBallWithItsLine) {
  const std::string good = "x,y,z,r\n1,2,3,4\n";
  EXPECT_EQ(refusal(good + "1,2,3\n"), "line 3: need 4 fields, found 3");
  EXPECT_EQ(refusal(good + "1,2,3,4,5\n"), "line 3: need 4 fields, found 5");
  EXPECT_EQ(refusal(good + "1 2 3 4\n"), "line 3: need 4 fields, found 1");
  EXPECT_EQ(refusal(good + "\n1,2,,4\n"), "line 4: field 3 is empty");
  EXPECT_EQ(refusal(good + "1,2,3,0\n"), "line 3: need a radius above 0, found 0");
  EXPECT_EQ(refusal(good + "1,2,3,-4\n"), "line 3: need a radius above 0, found -4");
  EXPECT_EQ(refusal(good + "1,2,nan,4\n"), "line 3: need finite numbers, found \"nan\"");
  EXPECT_EQ(refusal(good + "1,2,3,inf\n"), "line 3: need finite numbers, found \"inf\"");
  EXPECT_EQ(refusal(good + "1,2,3,1e999\n"), "line 3: \"1e999\" is out of range");
  EXPECT_EQ(refusal(good + "1,2,3;4,5\n"), "line 3: expected a number, found \"3;4\"");
  EXPECT_EQ(refusal(good + "x,y,z,r\n"), "line 3: expected a number, found \"x\"");
  EXPECT_EQ(refusal("a,b,c,d\n"), "line 1: expected a number, found \"a\"");
  EXPECT_EQ(refusal(std::string("1,2,3,4\n1,2\0,3,4\n", 18)), "line 2: a NUL byte in text");
  EXPECT_NE(refusal("").find("without a ball"), std::string::npos);
  EXPECT_NE(refusal("x,y,z,r\n# nothing\n").find("without a ball"), std::string::npos);
}

TEST_F(BallTableTest, RefusesFilesThatAreMissingOrTooLarge) {
  EXPECT_THROW((void)readBalls(folder / "none.csv"), Error);
  try {
    static_cast<void>(read("1,2,3,4\n1,2,3,4\n", {.maxBytes = 10}));
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
}

}  // namespace
}  // namespace cutwater::test
