#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// The traces at the edges of each fragment.
class TracesOfFragments {
 public:
  explicit TracesOfFragments(const TileSurface& surface) : first_(surface.fragments().size() + 2) {
    // Counted two places ahead, so that adding leaves the first of each in its place.
    forEach(surface, [&](std::uint32_t fragment, std::uint32_t) { ++first_[fragment + 2]; });
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    traces_.resize(first_.back());
    forEach(surface, [&](std::uint32_t fragment, std::uint32_t trace) {
      traces_[first_[fragment + 1]++] = trace;
    });
  }
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t fragment) const {
    return std::span(traces_).subspan(first_[fragment], first_[fragment + 1] - first_[fragment]);
  }

 private:
  template <typename Visit>
  static void forEach(const TileSurface& surface, Visit&& visit) {
    for (std::uint32_t i = 0; i < surface.traces().size(); ++i) {
      const auto& trace = surface.traces()[i];
      if (trace.below != kNone) visit(trace.below, i);
      if (trace.above != kNone) visit(trace.above, i);
    }
  }

  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> traces_;
};

/// Adds the faces of cut cells that are wanted which are whole in the fluid; returns their numbers
/// by face.
[[nodiscard]] std::vector<std::uint32_t> addFullFaces(
    const TileSurface& surface, const EdgeStretches& stretches, const FacePieces& faces,
    const GridPlanes& planes, const CellMask* wanted, std::vector<PieceArc>& arcs);

}  // namespace cutwater
