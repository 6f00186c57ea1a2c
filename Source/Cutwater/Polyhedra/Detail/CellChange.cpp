#include <Cutwater/Polyhedra/Detail/CellChange.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cutwater {

namespace {

constexpr auto kNoFace = EditedMesh::kNone;
using Cells = std::vector<std::uint32_t>;
using Face = EditedMesh::Face;

/// Joins pairs of a cell's faces that have the same beyond them.
template <typename May>
void joinPairs(EditedMesh& mesh, std::uint32_t cell, const May& may) {
  const auto faces = mesh.facesOf(cell);
  for (std::size_t a = 0; a < faces.size(); ++a) {
    for (std::size_t b = a + 1; b < faces.size(); ++b) {
      const auto& one = mesh.face(faces[a]);
      const auto& other = mesh.face(faces[b]);
      if (one.loop.empty() || other.loop.empty()) continue;
      if (one.across(cell) != other.across(cell) || !may(one, other)) continue;
      if (mesh.joinFaces(faces[a], faces[b])) b = a;  // others may join now
    }
  }
}

/// Whether two walls are those of a sheet, or of what is thinner than the polygons tell.
bool areTwoSides(const EditedMesh& mesh, const CornerLoop& a, const CornerLoop& b) {
  constexpr double kCosine = -0.5;
  const auto at = [&](std::uint32_t n) { return mesh.points()[n]; };
  const auto area = faceMoments(a, at).area;
  const auto other = faceMoments(b, at).area;
  return dot(area, other) < kCosine * length(area) * length(other);
}

/// Joins all walls of a cell, or one with others; whether there were any.
bool joinWalls(EditedMesh& mesh, std::uint32_t cell, bool joinsSides,
               std::uint32_t wall = kNoFace) {
  const auto count = mesh.facesOf(cell).size();
  joinPairs(mesh, cell, [&](const Face& a, const Face& b) {
    const bool isWanted = wall == kNoFace || &a == &mesh.face(wall) || &b == &mesh.face(wall);
    return isWanted && a.other == EditedMesh::kNone && a.patch == b.patch &&
           (joinsSides || !areTwoSides(mesh, a.loop, b.loop));
  });
  return mesh.facesOf(cell).size() < count;
}

std::uint32_t joined(EditedMesh& mesh, std::uint32_t cell, std::uint32_t other) {
  const auto both = mesh.join(cell, other);
  joinPairs(mesh, both, [&](const Face& a, const Face& b) {
    return a.other != EditedMesh::kNone && areInOnePlane(a.loop, b.loop, mesh.points());
  });
  return both;
}

/// Closes the folds of a cell: it, and the cells beside them.
Cells withoutFolds(EditedMesh& mesh, std::uint32_t cell, bool alsoOfWalls) {
  Cells cells{cell};
  const auto faces = mesh.facesOf(cell);
  for (std::size_t a = 0; a < faces.size(); ++a) {
    for (std::size_t b = a + 1; b < faces.size(); ++b) {
      const auto there = mesh.face(faces[a]).across(cell);
      const auto beyond = mesh.face(faces[b]).across(cell);
      if (there == EditedMesh::kNone && beyond == EditedMesh::kNone && !alsoOfWalls) continue;
      if (!mesh.closeFold(cell, faces[a], faces[b])) continue;
      for (const auto of : {there, beyond}) {
        if (of != EditedMesh::kNone && std::ranges::count(cells, of) == 0) cells.push_back(of);
      }
      break;
    }
  }
  return cells;
}

/// Whether an edge of a cell is between two corners.
bool hasEdge(EditedMesh& mesh, std::uint32_t cell, std::uint32_t a, std::uint32_t b) {
  for (const auto number : mesh.facesOf(cell)) {
    const auto& loop = mesh.face(number).loop;
    const auto found = std::ranges::find(loop, a);
    if (found == loop.end()) continue;
    const auto next = found + 1 == loop.end() ? loop.front() : *(found + 1);
    const auto last = found == loop.begin() ? loop.back() : *(found - 1);
    if (next == b || last == b) return true;
  }
  return false;
}

Cells withDividedWall(EditedMesh& mesh, const CellChange& change) {
  auto wall = mesh.face(change.other);
  const auto [a, b] = change.corners;
  if (hasEdge(mesh, change.cell, a, b)) return {};
  std::rotate(wall.loop.begin(), std::ranges::find(wall.loop, a), wall.loop.end());
  const auto end = std::ranges::find(wall.loop, b);
  CornerLoop rest(end, wall.loop.end());
  rest.push_back(a);
  wall.loop.erase(end + 1, wall.loop.end());
  mesh.setLoop(change.other, wall.loop);
  wall.loop = std::move(rest);
  mesh.addFace(std::move(wall));
  return {change.cell};
}

Cells divided(const CellChange& change, EditedMesh& mesh) {
  using Kind = CellChange::Kind;
  const auto cell = change.cell;
  const auto behind = divideCell(mesh, cell, change.plane);
  if (!behind) return {};
  const bool isFront = change.kind == Kind::GiveFront || change.kind == Kind::DivideFront;
  const auto part = isFront ? cell : *behind;
  const auto rest = isFront ? *behind : cell;
  if (change.hasNeighbour()) return {rest, joined(mesh, part, change.other)};
  if (change.kind == Kind::Divide) return {cell, *behind};
  const auto third = divideCell(mesh, part, change.second);
  return third ? Cells{rest, part, *third} : Cells{};
}

}  // namespace

std::vector<std::uint32_t> apply(const CellChange& change, EditedMesh& mesh) {
  using Kind = CellChange::Kind;
  const bool joinsSides = change.joinsSides;
  switch (change.kind) {
    case Kind::CloseFolds:
      return withoutFolds(mesh, change.cell, joinsSides);
    case Kind::JoinWalls:
      if (!joinWalls(mesh, change.cell, joinsSides, change.other)) return {};
      return withoutFolds(mesh, change.cell, joinsSides);
    case Kind::DivideWall:
      return withDividedWall(mesh, change);
    case Kind::Join:
      return withoutFolds(mesh, joined(mesh, change.cell, change.other), joinsSides);
    case Kind::JoinWithWalls: {
      const auto both = joined(mesh, change.cell, change.other);
      if (!joinWalls(mesh, both, joinsSides)) return {};
      return withoutFolds(mesh, both, joinsSides);
    }
    case Kind::JoinAndDivide: {
      const auto both = joined(mesh, change.cell, change.other);
      const auto behind = divideCell(mesh, both, change.plane);
      return behind ? Cells{both, *behind} : Cells{};
    }
    default:
      return divided(change, mesh);
  }
}

}  // namespace cutwater
