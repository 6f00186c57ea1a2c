#pragma once

#include <Cutwater/CutCells/Detail/Pieces/CellPieces.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace cutwater {

/// What open patches have of the sides of rectangles, see PlaneCut.hpp.
class OpenSides {
 public:
  /// Adds a trace, as an arc with its area and its centroid. Those that share an edge of the mesh
  /// are one.
  void addTrace(const FaceTrace& trace, const PieceArc& arc);
  /// Adds a part of a side where triangles meet: all that a patch has of a piece in a side are one.
  void addMeeting(const PieceArc& arc) { add(kNone, arc); }

  /// In the order of the first part of each.
  [[nodiscard]] std::vector<PieceArc> arcs() const;

 private:
  /// `edge`: kNone where triangles meet.
  void add(std::uint32_t edge, const PieceArc& arc) {
    ends_.emplace_back(edge, static_cast<std::uint32_t>(parts_.size()));
    parts_.push_back(arc);
  }

  std::vector<PieceArc> parts_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;  // edges, and parts that have them
};

}  // namespace cutwater
