#pragma once

#include <string_view>

namespace cutwater {

/// Instruction sets that the hot loops are compiled for, from the least to the most capable.
/// Answers do not depend on the choice.
enum class InstructionSet {
  Portable,  ///< any processor
  Baseline,  ///< x86-64: SSE2
  Avx2,      ///< AVX2 and FMA
  Avx512,    ///< AVX-512 F, DQ, BW and VL
};

/// The best set of this processor, chosen once, or the one that the environment variable
/// CUTWATER_INSTRUCTION_SET names (portable, baseline, avx2, avx512), if the processor has it.
[[nodiscard]] InstructionSet instructionSet();

/// The name as spelled in the environment variable.
[[nodiscard]] std::string_view name(InstructionSet set);

namespace detail {

/// The result of instructionSet() if the variable is `wanted`; null: not set. An unknown name, or a
/// set that the processor lacks, is ignored.
[[nodiscard]] InstructionSet chosenInstructionSet(const char* wanted);

/// One function compiled for each set.
template <typename Function>
struct PerInstructionSet {
  Function* portable = nullptr;
  Function* baseline = nullptr;  // null, like the others, where not built for it
  Function* avx2 = nullptr;
  Function* avx512 = nullptr;

  [[nodiscard]] Function* best() const {
    const InstructionSet set = instructionSet();
    if (set == InstructionSet::Avx512 && avx512 != nullptr) return avx512;
    if (set >= InstructionSet::Avx2 && avx2 != nullptr) return avx2;
    if (set >= InstructionSet::Baseline && baseline != nullptr) return baseline;
    return portable;
  }
};

}  // namespace detail

}  // namespace cutwater

// For a function that cutwater_vector_sources() compiles once per set, each in its own namespace:
// applies M(namespace) to all of them, to declare it, and selects the best for this processor.
#if defined(__x86_64__)
#define CUTWATER_FOR_INSTRUCTION_SETS(M) M(portable) M(baseline) M(avx2) M(avx512)
#define CUTWATER_BEST_OF(Function, name)                                                         \
  ::cutwater::detail::PerInstructionSet<Function>{&portable::name, &baseline::name, &avx2::name, \
                                                  &avx512::name}                                 \
      .best()
#else
#define CUTWATER_FOR_INSTRUCTION_SETS(M) M(portable)
#define CUTWATER_BEST_OF(Function, name) \
  ::cutwater::detail::PerInstructionSet<Function>{.portable = &portable::name}.best()
#endif
