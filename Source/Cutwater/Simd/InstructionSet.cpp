#include <Cutwater/Simd/InstructionSet.hpp>

#include <array>
#include <cstdlib>
#include <string_view>

namespace cutwater {

namespace {

using enum InstructionSet;

InstructionSet best() {
#if defined(__x86_64__)
  const auto has512 = [] {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0;
  };
  if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
    return has512() ? Avx512 : Avx2;
  }
  return Baseline;
#else
  return Portable;
#endif
}

}  // namespace

std::string_view name(InstructionSet set) {
  constexpr std::array<std::string_view, 4> kNames{"portable", "baseline", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(set)];
}

InstructionSet detail::chosenInstructionSet(const char* wanted) {
  if (wanted == nullptr) return best();
  for (const auto set : {Portable, Baseline, Avx2, Avx512}) {
    if (name(set) == wanted && set <= best()) return set;
  }
  return best();
}

InstructionSet instructionSet() {
  static const InstructionSet set =
      detail::chosenInstructionSet(std::getenv("CUTWATER_INSTRUCTION_SET"));
  return set;
}

}  // namespace cutwater
