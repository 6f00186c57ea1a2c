// Patterns at many points: PatternBatch.hpp. Compiled once per instruction set.

#include <Cutwater/Tpms/PatternBatch.hpp>
#include <Cutwater/Tpms/PatternFormulas.inl>

namespace cutwater::CUTWATER_SIMD {

namespace {

using detail::TpmsKind;

// As plain rows: the standard library's functions stay out.
static_assert(sizeof(detail::PatternBatch<double>) == 7 * 64 * sizeof(double));
static_assert(sizeof(detail::PatternBatch<float>) == 7 * 64 * sizeof(float));
constexpr int kRow = 64;

/// For lanes beyond the last point there is room in the row, and what is in it does not matter.
template <typename Formula, typename T>
CUTWATER_INLINE inline void fillRows(T* rows, int count) {
  for (int i = 0; i < count; i += kLanesOf<T>) {
    const auto x = sineCosineOfTurns<T>(load(rows + i));
    const auto y = sineCosineOfTurns<T>(load(rows + kRow + i));
    const auto z = sineCosineOfTurns<T>(load(rows + 2 * kRow + i));
    const auto found = Formula::at(Angles<T>{x.sine, x.cosine, y.sine, y.cosine, z.sine, z.cosine});
    store(rows + 3 * kRow + i, found.value);
    store(rows + 4 * kRow + i, found.gradient.x);
    store(rows + 5 * kRow + i, found.gradient.y);
    store(rows + 6 * kRow + i, found.gradient.z);
  }
}

/// Sines and cosines of x, y and z are found in neighbouring lanes.
template <typename Formula, typename T>
CUTWATER_INLINE inline void fillPoint(T* numbers) {
  constexpr int kRoom = kLanesOf<T> < 4 ? 4 : kLanesOf<T>;
  alignas(64) T turns[kRoom] = {numbers[0], numbers[1], numbers[2]};
  alignas(64) T sines[kRoom];
  alignas(64) T cosines[kRoom];
  for (int i = 0; i < 3; i += kLanesOf<T>) {
    const auto found = sineCosineOfTurns<T>(load(turns + i));
    store(sines + i, found.sine);
    store(cosines + i, found.cosine);
  }
  const auto found =
      Formula::at(Angles<T>{broadcast(sines[0]), broadcast(cosines[0]), broadcast(sines[1]),
                            broadcast(cosines[1]), broadcast(sines[2]), broadcast(cosines[2])});
  alignas(64) T lanes[4][kLanesOf<T>];
  store(lanes[0], found.value);
  store(lanes[1], found.gradient.x);
  store(lanes[2], found.gradient.y);
  store(lanes[3], found.gradient.z);
  for (int i = 0; i < 4; ++i) numbers[i] = lanes[i][0];
}

/// Calls what(the pattern's formula).
template <typename What>
CUTWATER_INLINE inline void withFormula(TpmsKind kind, What what) {
  switch (kind) {
    case TpmsKind::Gyroid:
      return what(GyroidFormula{});
    case TpmsKind::SchwarzP:
      return what(SchwarzPFormula{});
    case TpmsKind::SchwarzD:
      return what(SchwarzDFormula{});
    case TpmsKind::SchwarzD4:
      return what(SchwarzD4Formula{});
    case TpmsKind::Lidinoid:
      return what(LidinoidFormula{});
    case TpmsKind::SplitP:
      return what(SplitPFormula{});
    case TpmsKind::Neovius:
      return what(NeoviusFormula{});
    case TpmsKind::Iwp:
      return what(IwpFormula{});
    case TpmsKind::Frd:
      return what(FrdFormula{});
    case TpmsKind::FischerKochS:
      return what(FischerKochSFormula{});
  }
}

template <typename T>
CUTWATER_INLINE inline void sampleRows(TpmsKind kind, T* rows, int count) {
  withFormula(kind, [&](auto formula) { fillRows<decltype(formula)>(rows, count); });
}

template <typename T>
CUTWATER_INLINE inline void samplePoint(TpmsKind kind, T* numbers) {
  withFormula(kind, [&](auto formula) { fillPoint<decltype(formula)>(numbers); });
}

}  // namespace

void samplePatternRows(TpmsKind kind, float* rows, int count) {
  sampleRows(kind, rows, count);
}
void samplePatternRows(TpmsKind kind, double* rows, int count) {
  sampleRows(kind, rows, count);
}
void samplePatternPoint(TpmsKind kind, float* numbers) {
  samplePoint(kind, numbers);
}
void samplePatternPoint(TpmsKind kind, double* numbers) {
  samplePoint(kind, numbers);
}

}  // namespace cutwater::CUTWATER_SIMD
