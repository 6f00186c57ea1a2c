#pragma once

#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>
#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

namespace cutwater {

/// Sums of quadrature points that are a piece.
struct PieceRule {
  RulePoints points;
  double volume = 0;
  Vec3<double> moment;  // about the middle of the first span
  bool isOpen = false;  // to a face

  void add(const FluidSpan& span) {
    points.spans.push_back(span);
    volume += span.size();
    moment += span.size() * (span.middle() - points.spans.front().middle());
  }
};

/// Appends a piece of a cell with this box, and its walls by patch.
void addPiece(const FluidField& field, const Box<double>& box, std::uint32_t cell,
              const PieceRule& rule, CellPieces& to);

}  // namespace cutwater
