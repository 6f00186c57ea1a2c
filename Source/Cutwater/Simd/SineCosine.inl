// Sines and cosines of many angles: SineCosine.hpp. Compiled once per instruction set.

#include <Cutwater/Simd/TurnTrigonometry.inl>

#include <cstddef>

namespace cutwater::CUTWATER_SIMD {

namespace {

template <typename T>
CUTWATER_INLINE inline void sinesAndCosinesOf(const T* turns, std::size_t count, T* sines,
                                              T* cosines) {
  constexpr std::size_t kLanes = kLanesOf<T>;
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t some = count - first < kLanes ? count - first : kLanes;
    alignas(64) T block[3][kLanes] = {};
    for (std::size_t i = 0; i < some; ++i) block[0][i] = turns[first + i];
    const auto found = sineCosineOfTurns<T>(load(block[0]));
    store(block[1], found.sine);
    store(block[2], found.cosine);
    for (std::size_t i = 0; i < some; ++i) {
      sines[first + i] = block[1][i];
      cosines[first + i] = block[2][i];
    }
  }
}

}  // namespace

void sinesAndCosines(const float* turns, std::size_t count, float* sines, float* cosines) {
  sinesAndCosinesOf(turns, count, sines, cosines);
}
void sinesAndCosines(const double* turns, std::size_t count, double* sines, double* cosines) {
  sinesAndCosinesOf(turns, count, sines, cosines);
}

}  // namespace cutwater::CUTWATER_SIMD
