#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Simd/InstructionSet.hpp>
#include <Cutwater/Simd/SineCosine.hpp>

namespace cutwater {

namespace {

template <typename T>
using SinesAndCosines = void(const T* turns, std::size_t count, T* sines, T* cosines);

}  // namespace

#define CUTWATER_DECLARE(set)                                         \
  namespace set {                                                     \
  void sinesAndCosines(const float*, std::size_t, float*, float*);    \
  void sinesAndCosines(const double*, std::size_t, double*, double*); \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE

template <std::floating_point T>
void sinesAndCosines(std::span<const T> turns, std::span<T> sines, std::span<T> cosines) {
  require(turns.size() == sines.size() && turns.size() == cosines.size(),
          "sinesAndCosines: need one of each per angle", Named{"turns", turns.size()},
          Named{"sines", sines.size()}, Named{"cosines", cosines.size()});
  static SinesAndCosines<T>* const function = CUTWATER_BEST_OF(SinesAndCosines<T>, sinesAndCosines);
  function(turns.data(), turns.size(), sines.data(), cosines.data());
}

template void sinesAndCosines(std::span<const float>, std::span<float>, std::span<float>);
template void sinesAndCosines(std::span<const double>, std::span<double>, std::span<double>);

}  // namespace cutwater
