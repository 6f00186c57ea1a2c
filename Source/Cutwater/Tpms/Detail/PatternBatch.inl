// Patterns at many points: PatternBatch.hpp. Compiled once per instruction set.

#include <Cutwater/Tpms/Detail/PatternFormulas.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

// Accessed as plain rows, which keeps the standard library's functions out.
static_assert(sizeof(detail::PatternBatch<double>) == 7 * 64 * sizeof(double));
static_assert(sizeof(detail::PatternBatch<float>) == 7 * 64 * sizeof(float));
constexpr int kRow = 64;

/// The row has room for lanes beyond the last point; their contents do not matter.
template <typename Formula, typename T>
CUTWATER_INLINE inline void fillRows(T* rows, int count) {
  for (int i = 0; i < count; i += kLanesOf<T>) {
    const auto found = Formula::at(anglesInRows(rows + i, kRow));
    store(rows + 3 * kRow + i, found.value);
    store(rows + 4 * kRow + i, found.gradient.x);
    store(rows + 5 * kRow + i, found.gradient.y);
    store(rows + 6 * kRow + i, found.gradient.z);
  }
}

template <typename Formula, typename T>
CUTWATER_INLINE inline void fillPoint(T* numbers) {
  const auto found = Formula::at(anglesAtPoint(numbers));
  alignas(64) T lanes[4][kLanesOf<T>];
  store(lanes[0], found.value);
  store(lanes[1], found.gradient.x);
  store(lanes[2], found.gradient.y);
  store(lanes[3], found.gradient.z);
  for (int i = 0; i < 4; ++i) numbers[i] = lanes[i][0];
}

template <typename T>
CUTWATER_INLINE inline void sampleRows(detail::TpmsKind kind, T* rows, int count) {
  withFormula(kind, [&](auto formula) { fillRows<decltype(formula)>(rows, count); });
}

template <typename T>
CUTWATER_INLINE inline void samplePoint(detail::TpmsKind kind, T* numbers) {
  withFormula(kind, [&](auto formula) { fillPoint<decltype(formula)>(numbers); });
}

}  // namespace

void samplePatternRows(detail::TpmsKind kind, float* rows, int count) {
  sampleRows(kind, rows, count);
}
void samplePatternRows(detail::TpmsKind kind, double* rows, int count) {
  sampleRows(kind, rows, count);
}
void samplePatternPoint(detail::TpmsKind kind, float* numbers) {
  samplePoint(kind, numbers);
}
void samplePatternPoint(detail::TpmsKind kind, double* numbers) {
  samplePoint(kind, numbers);
}

}  // namespace cutwater::CUTWATER_SIMD
