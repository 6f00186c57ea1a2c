// Private: what merged() does, on any mesh.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/Detail/Moments/Moments.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace cutwater {

/// The pieces of cut cells as nodes that open parts of faces connect. It covers nodes, and closes
/// what leads to them, until one at most is left in every cell.
class MergeGraph {
 public:
  /// A cell, given by a number. What comes first in the order of these is covered first.
  using Place = std::uint64_t;

  /// A piece, or a cell that was all fluid before one of its faces was closed.
  struct Node {
    Place place = 0;
    std::uint32_t source = CutCells::kNoRow;  ///< the piece
    double volume = 0;
    Vec3<double> centroid;
    double wallArea = 0;  ///< without the faces that were closed
    Vec3<double> wallVector;
    Moments closed;  ///< the faces that were closed
    Vec3<double> closedVector = {};
    bool isCovered = false;
    std::vector<std::uint32_t> arcs = {};
  };
  /// An open part of a face.
  struct Arc {
    std::uint32_t below = CutCells::kWholeCell;  ///< a node, kWholeCell or kBeyond
    std::uint32_t above = CutCells::kWholeCell;
    Place owner = 0;  ///< the finer cell, whose face it lies in
    Place other = 0;  ///< the cell across
    double area = 0;
    Vec3<double> centroid;
    std::uint8_t axis = 0;
    bool isHigh = false;  ///< of the owner's faces across the axis
    double belowBy = 0;   ///< how much higher the cell below is: it is at the other end of a period
    std::uint32_t source = CutCells::kNoRow;  ///< the arc; kNoRow for all of the owner's face
    bool isClosed = false;

    [[nodiscard]] Place placeBelow() const { return isHigh ? owner : other; }
    [[nodiscard]] Place placeAbove() const { return isHigh ? other : owner; }
  };

  /// What the graph asks of its mesh.
  class Mesh {
   public:
    Mesh() = default;
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;
    virtual ~Mesh() = default;
    /// Of a cell, or of one around the mesh that owns an arc.
    [[nodiscard]] virtual Box<double> boxOf(Place place) const = 0;
    /// The faces of a cell that is all fluid to others that are, or beyond the mesh, where the side
    /// across is kBeyond.
    [[nodiscard]] virtual std::vector<Arc> facesOfWhole(Place place) const = 0;
  };

  /// Of about so many pieces and arcs.
  MergeGraph(const Mesh& mesh, std::size_t pieces, std::size_t arcs) : mesh_(mesh) {
    nodes_.reserve(pieces);
    arcs_.reserve(arcs);
  }

  /// Adds a piece; those of a cell one after the other, cells in the order of places.
  void add(Node node) { nodes_.push_back(std::move(node)); }
  /// Adds an arc between pieces that were added, or cells of the mesh that are all fluid. Faces are
  /// closed in the order of arcs.
  void add(const Arc& arc);

  /// Covers all but the largest piece of each cell, pieces with less than this share of their cell,
  /// and those that are left with a wall without direction.
  void cover(double smallest);

  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }
  [[nodiscard]] std::span<const Arc> arcs() const { return arcs_; }
  [[nodiscard]] Box<double> boxOf(Place place) const { return mesh_.boxOf(place); }
  /// The nodes that are not covered, one a cell; their cells in the order of nameOf(place).
  template <typename NameOf>
  [[nodiscard]] std::vector<std::uint32_t> kept(const NameOf& nameOf) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
      if (!nodes_[node].isCovered) result.push_back(node);
    }
    std::ranges::sort(result, {}, [&](std::uint32_t node) { return nameOf(nodes_[node].place); });
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t largest(std::uint32_t first, std::uint32_t last) const;
  [[nodiscard]] bool isSmall(const Node& node, double share) const;
  /// Of its wall. Cells without one, which open patches bound, need none.
  [[nodiscard]] bool hasDirection(const Node& node) const;
  std::uint32_t nodeOfWhole(Place place);
  void coverNode(std::uint32_t node);
  void closeArc(std::uint32_t arc);

  const Mesh& mesh_;
  std::vector<Node> nodes_;  // pieces, then cells that were all fluid
  std::vector<Arc> arcs_;    // those that were added, then faces of cells that were all fluid
  std::map<Place, std::vector<std::uint32_t>> ofWhole_;  // arcs to cells that are all fluid
  std::vector<std::uint32_t> changed_;                   // nodes whose walls have grown
};

}  // namespace cutwater
