#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// Area vectors of three faces that close lie in one plane, from which no gradient can be made.
constexpr std::size_t kFewestFaces = 4;

/// The faces of each cell of a mesh.
class CellFaces {
 public:
  /// Views the mesh.
  explicit CellFaces(const FluidMesh& mesh);

  [[nodiscard]] const FluidMesh& mesh() const { return mesh_; }
  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  /// Numbers of faces, ascending.
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t cell) const {
    return std::span(faces_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  /// Whether it has six faces of four corners, all beside other cells: a leaf that is all fluid, as
  /// others have a wall.
  [[nodiscard]] bool isInnerCuboid(std::uint32_t cell) const;

 private:
  const FluidMesh& mesh_;
  std::vector<std::uint64_t> first_;
  std::vector<std::uint32_t> faces_;
};

/// Edges of cells. Keeps its memory from one to the next.
class CellEdges {
 public:
  using Edge = std::array<std::uint32_t, 2>;

  /// Those of a cell along which its faces do not meet others in the opposite direction. Valid
  /// until the next call.
  [[nodiscard]] std::span<const Edge> openOf(const CellFaces& cells, std::uint32_t cell);

 private:
  struct Half {
    Edge edge;  // its lesser end first
    int sign;
  };

  std::vector<Half> halves_;
  std::vector<Edge> open_;
};

}  // namespace cutwater
