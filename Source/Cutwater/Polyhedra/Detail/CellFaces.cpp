#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>

#include <algorithm>
#include <numeric>

namespace cutwater {

CellFaces::CellFaces(const FluidMesh& mesh) : mesh_(mesh), first_(mesh.cells.leaf.size() + 1, 0) {
  const auto& [first, corners, owner, neighbour] = mesh.faces;
  for (const auto cell : owner) ++first_[cell + 1];
  for (const auto cell : neighbour) ++first_[cell + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  faces_.resize(first_.back());
  auto next = first_;
  for (std::uint32_t face = 0; face < owner.size(); ++face) {
    faces_[next[owner[face]]++] = face;
    if (face < neighbour.size()) faces_[next[neighbour[face]]++] = face;
  }
}

bool CellFaces::isInnerCuboid(std::uint32_t cell) const {
  const auto faces = of(cell);
  return faces.size() == 6 && std::ranges::all_of(faces, [&](std::uint32_t face) {
           return face < mesh_.faces.neighbour.size() && mesh_.faces.of(face).size() == 4;
         });
}

std::span<const CellEdges::Edge> CellEdges::openOf(const CellFaces& cells, std::uint32_t cell) {
  halves_.clear();
  open_.clear();
  const auto& faces = cells.mesh().faces;
  for (const auto face : cells.of(cell)) {
    const int sign = faces.owner[face] == cell ? 1 : -1;
    const auto loop = faces.of(face);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto a = loop[k];
      const auto b = loop[k + 1 < loop.size() ? k + 1 : 0];
      halves_.push_back(a < b ? Half{{a, b}, sign} : Half{{b, a}, -sign});
    }
  }
  std::ranges::sort(halves_, {}, &Half::edge);
  for (std::size_t n = 0; n < halves_.size();) {
    const auto edge = halves_[n].edge;
    int sum = 0;
    for (; n < halves_.size() && halves_[n].edge == edge; ++n) sum += halves_[n].sign;
    if (sum != 0) open_.push_back(edge);
  }
  return open_;
}

}  // namespace cutwater
