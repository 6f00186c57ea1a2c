#pragma once

#include <Cutwater/Polyhedra/Detail/CellDivision.hpp>
#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace cutwater {

/// One way to change a cell, with a neighbour or without.
struct CellChange {
  enum class Kind : std::uint8_t {
    CloseFolds,     ///< pairs of its faces that are one, seen from both sides
    JoinWalls,      ///< a wall with others of its patch
    DivideWall,     ///< by a line between two of its corners
    Divide,         ///< by a plane
    DivideFront,    ///< then the part in front of the plane by a second one
    DivideBehind,   ///< or the other part
    Join,           ///< with the neighbour
    JoinWithWalls,  ///< and then all walls of a patch
    JoinAndDivide,  ///< and then by a plane
    GiveFront,      ///< what is in front of a plane to the neighbour
    GiveBehind      ///< or the other part
  };
  Kind kind = Kind::CloseFolds;
  std::uint32_t cell = 0;
  std::uint32_t other = EditedMesh::kNone;  ///< the neighbour, or the wall
  DividingPlane plane = {};
  DividingPlane second = {};
  std::array<std::uint32_t, 2> corners = {};  ///< that the line is between
  /// Whether walls that are two sides of a sheet are joined as well: what of it both have is gone.
  bool joinsSides = false;

  [[nodiscard]] bool hasNeighbour() const { return kind >= Kind::Join; }
};

/// Makes a change. Closes folds of cells that were joined; faces between the same cells that lie in
/// one plane across an axis are joined.
/// @returns the cells that there are in place of those that it is of; none, if it cannot be made:
/// the mesh may be anything then.
[[nodiscard]] std::vector<std::uint32_t> apply(const CellChange& change, EditedMesh& mesh);

}  // namespace cutwater
