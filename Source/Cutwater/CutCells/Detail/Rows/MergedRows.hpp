// Private: the rows that merged() makes of cells and of leaves alike.
#pragma once

#include <Cutwater/CutCells/Detail/Moments/MomentRows.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallFaces.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/MergeGraph.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace cutwater {

/// Makes rows of the nodes of a graph that are kept, a cell and a piece each, in their order.
template <typename Cut>
class MergedRows {
 public:
  MergedRows(const Cut& in, const MergeGraph& graph, std::span<const std::uint32_t> kept, Cut& out)
      : in_(in), graph_(graph), kept_(kept), out_(out) {
    out_.patchNames = in_.patchNames;
    out_.patchNames.emplace_back("covered");
    out_.moments.degree = in_.moments.degree;
    pieceOf_.assign(graph.nodes().size(), CutCells::kNoRow);
    for (std::uint32_t piece = 0; piece < kept.size(); ++piece) pieceOf_[kept[piece]] = piece;
  }

  /// Adds what is known of cells by their rows, pieces and walls.
  void addPieces() {
    for (const auto node : kept_) addPiece(graph_.nodes()[node]);
    rows().firstPiece.push_back(static_cast<std::uint32_t>(kept_.size()));
    if (in_.moments.degree >= 0) addMoments();
  }
  /// Adds what all arcs have, of one that is open.
  void addArc(const MergeGraph::Arc& arc) {
    const auto sideOf = [&](std::uint32_t side) {
      return side < pieceOf_.size() ? pieceOf_[side] : side;
    };
    const auto patch = in_.openArcs.patchOf(arc.source);
    if (patch != CutCells::kNoRow) addOpenRow(out_.arcs.area.size(), patch, out_.openArcs);
    out_.arcs.below.push_back(sideOf(arc.below));
    out_.arcs.above.push_back(sideOf(arc.above));
    out_.arcs.area.push_back(arc.area);
    out_.arcs.centroid.push_back(arc.centroid);
    out_.arcs.axis.push_back(arc.axis);
    if (in_.moments.degree < 0) return;
    const auto moments = momentsOf(arc, arc.centroid);
    auto& to = out_.moments.arc;
    to.insert(to.end(), moments.begin(),
              moments.begin() + static_cast<std::ptrdiff_t>(in_.moments.perArc()));
  }
  /// Calls visit(arc) for the arcs that are open, in the order of nameOf(arc).
  template <typename NameOf, typename Visit>
  void forOpenArcs(const NameOf& nameOf, const Visit& visit) const {
    std::vector<std::pair<decltype(nameOf(graph_.arcs()[0])), std::uint32_t>> order;
    order.reserve(graph_.arcs().size());
    for (std::uint32_t arc = 0; arc < graph_.arcs().size(); ++arc) {
      if (!graph_.arcs()[arc].isClosed) order.emplace_back(nameOf(graph_.arcs()[arc]), arc);
    }
    if (!std::ranges::is_sorted(order)) std::ranges::sort(order);
    for (const auto& [name, arc] : order) visit(graph_.arcs()[arc]);
  }

 private:
  [[nodiscard]] auto& rows() {
    if constexpr (std::is_same_v<Cut, CutCells>) {
      return out_.cells;
    } else {
      return out_.cut;
    }
  }

  void addPiece(const MergeGraph::Node& node) {
    const auto number = static_cast<std::uint32_t>(out_.pieces.cell.size());
    const bool isPiece = node.source != CutCells::kNoRow;
    rows().firstPiece.push_back(number);
    const auto row = isPiece ? in_.pieces.cell[node.source] : 0;
    rows().fluidCorners.push_back(isPiece ? rowsOf(in_).fluidCorners[row] : std::uint8_t{0xff});
    rows().meets.push_back(isPiece ? rowsOf(in_).meets[row] : std::uint8_t{0});
    const auto& error = rowsOf(in_).error;
    if (!error.empty()) rows().error.push_back(isPiece ? error[row] : 0);
    const auto faces = wallFacesOf(node);
    rows().wallFaces.push_back(faces);
    out_.pieces.wallFaces.push_back(faces);
    auto wall = Moments(node.centroid);
    if (isPiece) {
      wall.add(in_.pieces.wallArea[node.source], in_.pieces.wallCentroid[node.source]);
      addWallParts(node.source, number);
    }
    if (node.closed.size() > 0) {
      wall.add(node.closed.size(), node.closed.centroid());
      addWallPart(number, out_.patchNames.size() - 1, node.closed.size(), node.closedVector,
                  node.closed.centroid());
    }
    out_.pieces.cell.push_back(number);
    out_.pieces.volume.push_back(node.volume);
    out_.pieces.centroid.push_back(node.centroid);
    out_.pieces.wallArea.push_back(wall.size());
    out_.pieces.wallVector.push_back(node.wallVector);
    out_.pieces.wallCentroid.push_back(wall.size() > 0 ? wall.centroid() : node.centroid);
  }
  /// Those of the piece, and those that hold closed parts.
  [[nodiscard]] std::uint8_t wallFacesOf(const MergeGraph::Node& node) const {
    unsigned faces = node.source != CutCells::kNoRow ? in_.pieces.wallFaces[node.source] : 0;
    for (const auto number : node.arcs) {
      const auto& arc = graph_.arcs()[number];
      const bool isHigh = arc.placeBelow() == node.place;
      if (arc.isClosed) faces |= bitOfFace(arc.axis, isHigh);
    }
    return static_cast<std::uint8_t>(faces);
  }
  void addWallParts(std::uint32_t source, std::uint32_t piece) {
    const auto& in = in_.wallParts;
    const auto first = std::ranges::lower_bound(in.piece, source) - in.piece.begin();
    for (auto n = static_cast<std::size_t>(first); n < in.piece.size() && in.piece[n] == source;
         ++n) {
      addWallPart(piece, in.patch[n], in.area[n], in.vector[n], in.centroid[n]);
    }
  }
  void addWallPart(std::uint32_t piece, std::size_t patch, double area, const Vec3<double>& vector,
                   const Vec3<double>& centroid) {
    auto& parts = out_.wallParts;
    parts.piece.push_back(piece);
    parts.patch.push_back(static_cast<std::uint32_t>(patch));
    parts.area.push_back(area);
    parts.vector.push_back(vector);
    parts.centroid.push_back(centroid);
  }
  void addMoments() {
    MomentRows moments(out_.pieces, out_.moments);
    for (std::size_t piece = 0; piece < kept_.size(); ++piece) {
      const auto& node = graph_.nodes()[kept_[piece]];
      if (node.source != CutCells::kNoRow) {
        moments.addPiece(piece, in_.pieces, in_.moments, node.source);
      } else {
        moments.addBox(piece, graph_.boxOf(node.place));
      }
      for (const auto number : node.arcs) {
        const auto& arc = graph_.arcs()[number];
        if (!arc.isClosed) continue;
        auto about = out_.pieces.wallCentroid[piece];
        if (arc.below == kept_[piece]) about[arc.axis] -= arc.belowBy;
        const auto box = graph_.boxOf(arc.owner);
        const double plane = arc.isHigh ? box.upper[arc.axis] : box.lower[arc.axis];
        moments.addClosedFace(piece, momentsOf(arc, about), arc.axis, plane - about[arc.axis],
                              arc.below == kept_[piece] ? 1 : -1);
      }
    }
  }
  [[nodiscard]] auto momentsOf(const MergeGraph::Arc& arc, const Vec3<double>& about) const {
    return momentsOfFace(in_, arc.source, graph_.boxOf(arc.owner), arc.axis, about);
  }

  const Cut& in_;
  const MergeGraph& graph_;
  std::span<const std::uint32_t> kept_;
  Cut& out_;
  std::vector<std::uint32_t> pieceOf_;  // of nodes
};

}  // namespace cutwater
