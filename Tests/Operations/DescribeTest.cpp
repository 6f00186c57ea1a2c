#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class DescribeTest : public ::testing::Test {};
TYPED_TEST_SUITE(DescribeTest, Precisions);

TYPED_TEST(DescribeTest, DescribesTheWholeExpression) {
  using T = TypeParam;
  Solid<T> ring = Torus<T>(T(0.75), T(0.25));
  ring.rotate(90, 0);
  ring.translate({2, 0, 0});
  const Solid<T> body =
      named((Sphere<T>({0, 0, 0}, 1) | ring) - Plane<T>({0, 0, 0}, {0, 0, 1}), "cup");
  const auto text = body.describe();
  std::vector<std::string> lines;
  for (std::istringstream in(text); std::getline(in, lines.emplace_back());) {
  }
  lines.pop_back();
  ASSERT_EQ(lines.size(), 7U) << text;
  const auto expectLine = [&](std::size_t i, const std::string& begin, const std::string& part) {
    EXPECT_EQ(lines[i].substr(0, begin.size()), begin) << text;
    EXPECT_NE(lines[i].find(part), std::string::npos) << text;
  };
  expectLine(0, "Named \"cup\": ", "Lipschitz 1");
  expectLine(1, "  Intersection: lower bound", "in (");
  expectLine(2, "    Union: outside exact, inside lower bound, Lipschitz 1;", "");
  expectLine(3, "      Sphere: exact, Lipschitz 1; in (-1, -1, -1) .. (1, 1, 1)", "");
  expectLine(4, "      Torus, moved by (2, 0, 0) and turned: exact", "");
  expectLine(5, "    Complement: exact", "");
  expectLine(6, "      Plane: exact, Lipschitz 1", "");
}

TYPED_TEST(DescribeTest, DescribesTheFirstOfManyOperands) {
  using T = TypeParam;
  std::vector<Solid<T>> balls;
  for (int i = 0; i < 20; ++i) balls.push_back(Sphere<T>({T(2 * i), 0, 0}, 1));
  const auto text = unionOf(balls).describe();
  EXPECT_EQ(std::ranges::count(text, '\n'), 1 + 16 + 1);
  EXPECT_NE(text.find("\n  and 4 more\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace cutwater::test
