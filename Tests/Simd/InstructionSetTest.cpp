#include <Cutwater/Simd/InstructionSet.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using enum InstructionSet;
using detail::chosenInstructionSet;

TEST(InstructionSetTest, TheVariableNamesWhatTheProcessorHas) {
  const InstructionSet best = chosenInstructionSet(nullptr);
  for (const auto set : {Portable, Baseline, Avx2, Avx512}) {
    const std::string wanted(name(set));
    EXPECT_EQ(chosenInstructionSet(wanted.c_str()), set <= best ? set : best) << wanted;
  }
  EXPECT_EQ(name(Portable), "portable");
  EXPECT_EQ(name(Avx512), "avx512");
}

TEST(InstructionSetTest, UnknownNamesArePassedOver) {
  const InstructionSet best = chosenInstructionSet(nullptr);
  for (const char* wanted : {"", "AVX2", "avx", "avx5120", "neon"}) {
    EXPECT_EQ(chosenInstructionSet(wanted), best) << wanted;
  }
}

int one() {
  return 1;
}
int two() {
  return 2;
}

TEST(InstructionSetTest, TheBestOfAFunctionIsForThisProcessor) {
  using detail::PerInstructionSet;
  EXPECT_EQ(PerInstructionSet<int()>{.portable = &one}.best()(), 1);
  const PerInstructionSet<int()> all{&one, &two, &two, &two};
  EXPECT_EQ(all.best()(), instructionSet() == Portable ? 1 : 2);
}

}  // namespace
}  // namespace cutwater::test
