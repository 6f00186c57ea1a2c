#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Curved/CurvedFaces.hpp>
#include <Cutwater/CutCells/Detail/Pieces/PieceSums.hpp>

namespace cutwater {

/// Appends the moments of an open part of a face about its centroid.
void addArcMoments(const OpenPart& part, int axis, CutCells::Moments& to);
/// Appends those of a piece and its wall, about their centroids, by these points.
void addPieceMoments(const CellPiece& piece, const RulePoints& rule, CutCells::Moments& to);

/// Appends the points of an open part, and those of a piece and its wall; so many along each span.
void addArcPoints(const OpenPart& part, int points, CutCells::Quadrature& to);
void addPiecePoints(const RulePoints& rule, int points, CutCells::Quadrature& to);

}  // namespace cutwater
