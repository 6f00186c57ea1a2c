#include <Cutwater/Core/FunctionRef.hpp>

#include <memory>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

int doubled(FunctionRef<int(int)> f, int value) {
  return 2 * f(value);
}
int successor(int value) {
  return value + 1;
}

TEST(FunctionRef, CallsWhatItRefersTo) {
  int calls = 0;
  const auto counting = [&](int value) { return ++calls + value; };
  EXPECT_EQ(doubled(counting, 10), 22);
  EXPECT_EQ(doubled(counting, 10), 24);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(doubled(successor, 4), 10);
}

TEST(FunctionRef, ChangesTheCallableItself) {
  auto adding = [sum = 0](int value) mutable { return sum += value; };
  EXPECT_EQ(doubled(adding, 3), 6);
  EXPECT_EQ(doubled(adding, 4), 14);  // not a copy: the sum went on
}

TEST(FunctionRef, PassesArgumentsThatOnlyMove) {
  const auto value = [](std::unique_ptr<int> p) { return *p; };
  const FunctionRef<int(std::unique_ptr<int>)> f = value;
  EXPECT_EQ(f(std::make_unique<int>(5)), 5);
}

}  // namespace
}  // namespace cutwater::test
