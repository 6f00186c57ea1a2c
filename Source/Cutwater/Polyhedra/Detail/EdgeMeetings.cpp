#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/EdgeMeetings.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cutwater {

namespace {

/// Orders points by the lines along an axis on which they lie, and along these.
struct AlongLines {
  const std::vector<Vec3<double>>& points;
  int axis;
  std::array<double, 3> operator()(std::uint32_t n) const {
    const auto& p = points[n];
    return {p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
  }
};

/// Points by the lines along each axis on which they lie.
class PointsOnAxes {
 public:
  PointsOnAxes(const std::vector<Vec3<double>>& points, const std::vector<std::uint32_t>& of)
      : points_(points) {
    for (int axis = 0; axis < 3; ++axis) {
      auto& line = lines_[asIndex(axis)];
      line = of;
      std::ranges::sort(line, {}, AlongLines{points, axis});
    }
  }
  /// Appends the points between two, if these lie on one line.
  void addBetween(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t>& out) const {
    const int axis = axisOf(points_[to] - points_[from]);
    if (axis < 0) return;
    const AlongLines key{points_, axis};
    const bool goesUp = points_[from][axis] < points_[to][axis];
    const auto& line = lines_[asIndex(axis)];
    const auto first = std::ranges::upper_bound(line, key(goesUp ? from : to), {}, key);
    const auto last = std::ranges::lower_bound(first, line.end(), key(goesUp ? to : from), {}, key);
    const auto begin = static_cast<std::ptrdiff_t>(out.size());
    out.insert(out.end(), first, last);
    if (!goesUp) std::reverse(out.begin() + begin, out.end());
  }

 private:
  /// The axis along which an edge runs; -1: none.
  static int axisOf(const Vec3<double>& edge) {
    int axis = -1;
    for (int a = 0; a < 3; ++a) {
      if (edge[a] == 0) continue;
      if (axis >= 0) return -1;
      axis = a;
    }
    return axis;
  }
  const std::vector<Vec3<double>>& points_;
  std::array<std::vector<std::uint32_t>, 3> lines_;
};

}  // namespace

void meetEdgeByEdge(FluidMesh& mesh) {
  const CellFaces cells(mesh);
  std::vector<char> isEnd(mesh.points.size(), 0);
  std::vector<std::uint32_t> ends;
  CellEdges edges;
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    if (cells.isInnerCuboid(cell)) continue;
    for (const auto& edge : edges.openOf(cells, cell)) {
      for (const auto end : edge) {
        if (isEnd[end] == 0) ends.push_back(end);
        isEnd[end] = 1;
      }
    }
  }
  if (ends.empty()) return;
  const PointsOnAxes points(mesh.points, ends);
  FluidMesh::Faces faces;
  faces.corners.reserve(mesh.faces.corners.size() + ends.size());
  std::vector<std::uint32_t> firstOf;  // the faces that each one became
  std::vector<CornerLoop> parts;
  CornerLoop through;
  for (std::size_t face = 0; face < mesh.faces.count(); ++face) {
    firstOf.push_back(static_cast<std::uint32_t>(faces.count()));
    const auto loop = mesh.faces.of(face);
    through.clear();
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const auto next = loop[(k + 1) % loop.size()];
      through.push_back(loop[k]);
      if (isEnd[loop[k]] != 0 && isEnd[next] != 0) points.addBetween(loop[k], next, through);
    }
    parts.clear();
    if (through.size() == loop.size()) {
      parts.push_back(through);
    } else {
      addSimpleLoops(through, parts);
    }
    for (const auto& part : parts) {
      faces.corners.insert(faces.corners.end(), part.begin(), part.end());
      faces.first.push_back(faces.corners.size());
      faces.owner.push_back(mesh.faces.owner[face]);
      if (face < mesh.faces.neighbour.size()) {
        faces.neighbour.push_back(mesh.faces.neighbour[face]);
      }
    }
  }
  firstOf.push_back(static_cast<std::uint32_t>(faces.count()));
  for (auto& patch : mesh.patches) {
    const auto end = firstOf[patch.firstFace + patch.faceCount];
    patch.firstFace = firstOf[patch.firstFace];
    patch.faceCount = end - patch.firstFace;
  }
  std::erase_if(mesh.patches, [](const auto& patch) { return patch.faceCount == 0; });
  mesh.faces = std::move(faces);
}

}  // namespace cutwater
