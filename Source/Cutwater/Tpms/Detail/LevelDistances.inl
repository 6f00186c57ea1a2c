// Distances to levels of patterns: LevelDistances.hpp. Compiled once per instruction set.

#include <Cutwater/Tpms/Detail/LevelDistances.hpp>
#include <Cutwater/Tpms/Detail/PatternFormulas.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

using detail::LevelTerms;
using detail::TpmsKind;

// Accessed as plain rows, which keeps the standard library's functions out.
static_assert(sizeof(detail::LevelBatch<double>) == 5 * 64 * sizeof(double));
static_assert(sizeof(detail::LevelBatch<float>) == 5 * 64 * sizeof(float));
constexpr int kRow = 64;

template <typename T>
CUTWATER_INLINE inline Lanes<T> distanceFrom(const LevelTerms<T>& terms,
                                             const Sample<Lanes<T>>& sample, Lanes<T> level) {
  using Real = Lanes<T>;
  const auto& part = terms.part;
  const Real whole = broadcast(part.absolute) * magnitude(sample.value) +
                     broadcast(part.plain) * sample.value + broadcast(part.level) * level;
  // Less than any level, unless only one half is meant.
  const T bottom = part.half == 0 ? T(-0x1p60) : T(0);
  const Real psi = most(whole, broadcast(part.half) * sample.value + broadcast(bottom));

  const auto& weight = terms.weight;
  const Triple<Real> gradient{broadcast(weight.x) * sample.gradient.x,
                              broadcast(weight.y) * sample.gradient.y,
                              broadcast(weight.z) * sample.gradient.z};
  const Real slope = most(squareRoot(dot(gradient, gradient)) + broadcast(terms.levelSlope),
                          broadcast(terms.leastSlope));
  const Real size = magnitude(psi);
  const Real root = squareRoot(slope * slope + broadcast(terms.twiceCurvature) * size);
  // Without the cancellation of (root - slope) / H.
  const Real second = (size + size) / (slope + root);
  const Real radians = most(second, size * broadcast(terms.perLipschitz));
  const Real distance = radians * broadcast(terms.lengthPerRadian);
  return where(isPositive(-psi), -distance, distance);
}

template <typename T>
CUTWATER_INLINE inline void fillRows(TpmsKind kind, const LevelTerms<T>& terms, T* rows,
                                     int count) {
  withFormula(
      kind, [&](auto formula) __attribute__((always_inline)) {
        for (int i = 0; i < count; i += kLanesOf<T>) {
          const auto sample = formula.at(anglesInRows(rows + i, kRow));
          store(rows + 4 * kRow + i, distanceFrom<T>(terms, sample, load(rows + 3 * kRow + i)));
        }
      });
}

template <typename T>
CUTWATER_INLINE inline T atPoint(TpmsKind kind, const LevelTerms<T>& terms, const T* numbers) {
  alignas(64) T lanes[kLanesOf<T>];
  withFormula(
      kind, [&](auto formula) __attribute__((always_inline)) {
        const auto sample = formula.at(anglesAtPoint(numbers));
        store(lanes, distanceFrom<T>(terms, sample, broadcast(numbers[3])));
      });
  return lanes[0];
}

}  // namespace

void levelRows(TpmsKind kind, const LevelTerms<float>& terms, float* rows, int count) {
  fillRows(kind, terms, rows, count);
}
void levelRows(TpmsKind kind, const LevelTerms<double>& terms, double* rows, int count) {
  fillRows(kind, terms, rows, count);
}
float levelPoint(TpmsKind kind, const LevelTerms<float>& terms, const float* numbers) {
  return atPoint(kind, terms, numbers);
}
double levelPoint(TpmsKind kind, const LevelTerms<double>& terms, const double* numbers) {
  return atPoint(kind, terms, numbers);
}

}  // namespace cutwater::CUTWATER_SIMD
