#include <Cutwater/Simd/InstructionSet.hpp>
#include <Cutwater/Tpms/Detail/LevelDistances.hpp>

namespace cutwater {

using detail::LevelTerms;
using detail::TpmsKind;

// Rows of LevelBatch<T>::kMost numbers, in the order of its members; a point and its level.
#define CUTWATER_DECLARE(set)                                                    \
  namespace set {                                                                \
  void levelRows(TpmsKind, const LevelTerms<float>&, float* rows, int);          \
  void levelRows(TpmsKind, const LevelTerms<double>&, double* rows, int);        \
  float levelPoint(TpmsKind, const LevelTerms<float>&, const float* numbers);    \
  double levelPoint(TpmsKind, const LevelTerms<double>&, const double* numbers); \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE

namespace {

template <std::floating_point T>
using LevelRows = void(TpmsKind, const LevelTerms<T>&, T*, int);
template <std::floating_point T>
using LevelPoint = T(TpmsKind, const LevelTerms<T>&, const T*);

}  // namespace

template <std::floating_point T>
void detail::levelDistances(TpmsKind kind, const LevelTerms<T>& terms, LevelBatch<T>& batch,
                            int count) {
  static LevelRows<T>* const function = CUTWATER_BEST_OF(LevelRows<T>, levelRows);
  padRows<T>({&batch.inCells[0], &batch.inCells[1], &batch.inCells[2], &batch.level}, count);
  function(kind, terms, batch.inCells[0].data(), count);
}

template <std::floating_point T>
T detail::levelDistance(TpmsKind kind, const LevelTerms<T>& terms, const Vec3<T>& inCells,
                        T level) {
  static LevelPoint<T>* const function = CUTWATER_BEST_OF(LevelPoint<T>, levelPoint);
  const std::array<T, 4> numbers{inCells.x, inCells.y, inCells.z, level};
  return function(kind, terms, numbers.data());
}

template void detail::levelDistances(TpmsKind, const LevelTerms<float>&, LevelBatch<float>&, int);
template void detail::levelDistances(TpmsKind, const LevelTerms<double>&, LevelBatch<double>&, int);
template float detail::levelDistance(TpmsKind, const LevelTerms<float>&, const Vec3<float>&, float);
template double detail::levelDistance(TpmsKind, const LevelTerms<double>&, const Vec3<double>&,
                                      double);

}  // namespace cutwater
