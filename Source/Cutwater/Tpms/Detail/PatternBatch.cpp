#include <Cutwater/Simd/InstructionSet.hpp>
#include <Cutwater/Tpms/Detail/PatternBatch.hpp>

namespace cutwater {

// The sets' functions take rows of PatternBatch<T>::kMost numbers, in the order of its members.
#define CUTWATER_DECLARE(set)                                  \
  namespace set {                                              \
  void samplePatternRows(detail::TpmsKind, float* rows, int);  \
  void samplePatternRows(detail::TpmsKind, double* rows, int); \
  void samplePatternPoint(detail::TpmsKind, float* numbers);   \
  void samplePatternPoint(detail::TpmsKind, double* numbers);  \
  }
CUTWATER_FOR_INSTRUCTION_SETS(CUTWATER_DECLARE)
#undef CUTWATER_DECLARE

namespace {

template <typename T>
using SampleRows = void(detail::TpmsKind, T*, int);
template <typename T>
using SamplePoint = void(detail::TpmsKind, T*);

}  // namespace

template <std::floating_point T>
void detail::samplePattern(TpmsKind kind, PatternBatch<T>& batch, int count) {
  static SampleRows<T>* const function = CUTWATER_BEST_OF(SampleRows<T>, samplePatternRows);
  padRows<T>({&batch.inCells[0], &batch.inCells[1], &batch.inCells[2]}, count);
  function(kind, batch.inCells[0].data(), count);
}

template <std::floating_point T>
TpmsSample<T> detail::samplePattern(TpmsKind kind, const Vec3<T>& inCells) {
  static SamplePoint<T>* const function = CUTWATER_BEST_OF(SamplePoint<T>, samplePatternPoint);
  std::array<T, 4> numbers{inCells.x, inCells.y, inCells.z, 0};
  function(kind, numbers.data());
  return {numbers[0], {numbers[1], numbers[2], numbers[3]}};
}

template void detail::samplePattern(TpmsKind, PatternBatch<float>&, int);
template void detail::samplePattern(TpmsKind, PatternBatch<double>&, int);
template TpmsSample<float> detail::samplePattern(TpmsKind, const Vec3<float>&);
template TpmsSample<double> detail::samplePattern(TpmsKind, const Vec3<double>&);

}  // namespace cutwater
