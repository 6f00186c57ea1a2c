#pragma once

#include <Cutwater/Core/Level.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/Detail/MortonCode.hpp>
#include <Cutwater/Grid/Refinement.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <span>

namespace cutwater::detail {

/// What classify() says about a cell, and whether it is to be divided.
struct CellTag {
  BoxClass kind = BoxClass::Unknown;
  bool isRefined = false;
};

/// Tags the cells that a refinement divides. A cell's tag depends on that cell alone, not on which
/// others are tagged or by whom, so the tags of grid patches, octrees and ranks agree.
template <std::floating_point T>
class CellTagger {
 public:
  /// Both must outlive it. @throws Error as Refinement::check().
  CellTagger(const SignedDistanceFunction<T>& solid, const Refinement<T>& refinement);

  /// Tags at most kMost cells of one level. On entry, hints are of boxes around the cells; on
  /// return, of the cells themselves.
  void tag(int level, std::span<const Box<T>> cells, std::span<BoxHint> hints,
           std::span<CellTag> tags) const;
  static constexpr std::size_t kMost = 256;

  /// Cells of one level, with callbacks for the hints of the cells from `first` on: hintsBefore
  /// supplies hints of boxes around the cells, hintsAfter receives those of the cells themselves.
  struct Cells {
    int level = 0;
    Level<T> grid;
    std::span<const MortonCode> codes;
    FunctionRef<void(std::size_t first, std::span<BoxHint>)> hintsBefore;
    FunctionRef<void(std::size_t first, std::span<const BoxHint>)> hintsAfter;
  };
  /// Tags any number of cells, in parallel; see parallelFor(). Several threads call the
  /// callbacks, for ranges that have no cell in common.
  void tag(const Cells& cells, std::span<CellTag> tags, const ParallelOptions& options) const;

 private:
  /// Distance from the surface within which cells of the level are refined; negative if they are
  /// not.
  [[nodiscard]] T reachOf(int level) const;
  /// Tags cells that may be within `reach` of the surface, among those not tagged yet.
  void tagNear(T reach, std::span<const Box<T>> cells, std::span<BoxHint> hints,
               std::span<CellTag> tags) const;
  [[nodiscard]] bool isNear(T reach, const Box<T>& cell, T atCenter, BoxHint& hint) const;

  const SignedDistanceFunction<T>& solid_;
  const Refinement<T>& refinement_;
  Guarantee<T> promise_;
};

extern template class CellTagger<float>;
extern template class CellTagger<double>;

}  // namespace cutwater::detail
