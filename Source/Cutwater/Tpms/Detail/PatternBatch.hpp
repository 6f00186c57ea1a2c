#pragma once

#include <Cutwater/Tpms/TpmsPattern.hpp>

#include <initializer_list>

namespace cutwater::detail {

enum class TpmsKind : std::uint8_t {
  Gyroid,
  SchwarzP,
  SchwarzD,
  SchwarzD4,
  Lidinoid,
  SplitP,
  Neovius,
  Iwp,
  Frd,
  FischerKochS,
};

/// A pattern at many points, component by component.
template <std::floating_point T>
struct alignas(64) PatternBatch {
  static constexpr int kMost = 64;
  using Row = std::array<T, kMost>;

  std::array<Row, 3> inCells;   ///< positions, in cells
  Row value;                    ///< F there
  std::array<Row, 3> gradient;  ///< per radian
};

/// Pads the rows after the first `count` numbers, up to the end of a vector, with numbers that are
/// fast to evaluate.
template <std::floating_point T, std::size_t kMost>
void padRows(std::initializer_list<std::array<T, kMost>*> rows, int count) {
  const auto begin = static_cast<std::size_t>(count);
  const std::size_t end = (begin + 15) / 16 * 16;
  for (auto* row : rows) std::fill(row->begin() + begin, row->begin() + end, T(0));
}

/// Fills in values and gradients of the first `count` points. Compiled for each instruction set
/// from one source: PatternBatch.inl.
template <std::floating_point T>
void samplePattern(TpmsKind kind, PatternBatch<T>& batch, int count);

/// The same, to the bit, at one point.
template <std::floating_point T>
[[nodiscard]] TpmsSample<T> samplePattern(TpmsKind kind, const Vec3<T>& inCells);

extern template void samplePattern(TpmsKind, PatternBatch<float>&, int);
extern template void samplePattern(TpmsKind, PatternBatch<double>&, int);
extern template TpmsSample<float> samplePattern(TpmsKind, const Vec3<float>&);
extern template TpmsSample<double> samplePattern(TpmsKind, const Vec3<double>&);

}  // namespace cutwater::detail
