#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/EdgeMeetings.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace cutwater {

namespace {

constexpr std::size_t kBatch = 1024;  // cells or faces

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
  PointsOnAxes(const std::vector<Vec3<double>>& points, const std::vector<std::uint32_t>& of,
               int threads)
      : points_(points) {
    parallelFor(3, {.threads = threads}, [&](std::size_t first, std::size_t last) {
      for (auto axis = first; axis < last; ++axis) {
        lines_[axis] = of;
        std::ranges::sort(lines_[axis], {}, AlongLines{points, static_cast<int>(axis)});
      }
    });
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

/// Of each point, whether an edge ends in it along which the faces of a cell do not meet others.
std::vector<char> endsOfOpenEdges(const FluidMesh& mesh, int threads) {
  const CellFaces cells(mesh);
  std::vector<std::vector<std::uint32_t>> found(cells.count() / kBatch + 1);
  detail::parallelBatches(
      cells.count(), kBatch, {.threads = threads}, [&](std::size_t first, std::size_t count) {
        CellEdges edges;
        for (auto cell = static_cast<std::uint32_t>(first); cell < first + count; ++cell) {
          if (cells.isInnerCuboid(cell)) continue;
          for (const auto& edge : edges.openOf(cells, cell)) {
            found[first / kBatch].insert(found[first / kBatch].end(), edge.begin(), edge.end());
          }
        }
      });
  std::vector<char> isEnd(mesh.points.size(), 0);
  for (const auto& of : found) {
    for (const auto end : of) isEnd[end] = 1;
  }
  return isEnd;
}

/// A face that goes through points in which others end.
struct LongerFace {
  std::uint32_t face;
  CornerLoop loop;
};

/// The faces whose edges go through such points, ascending.
std::vector<LongerFace> facesThrough(const FluidMesh& mesh, const std::vector<char>& isEnd,
                                     int threads) {
  std::vector<std::uint32_t> ends;
  for (std::uint32_t point = 0; point < isEnd.size(); ++point) {
    if (isEnd[point] != 0) ends.push_back(point);
  }
  if (ends.empty()) return {};
  const PointsOnAxes points(mesh.points, ends, threads);
  std::vector<std::vector<LongerFace>> found(mesh.faces.count() / kBatch + 1);
  detail::parallelBatches(
      mesh.faces.count(), kBatch, {.threads = threads}, [&](std::size_t first, std::size_t count) {
        CornerLoop through;
        for (auto face = static_cast<std::uint32_t>(first); face < first + count; ++face) {
          const auto loop = mesh.faces.of(face);
          through.clear();
          for (std::size_t k = 0; k < loop.size(); ++k) {
            const auto next = loop[k + 1 < loop.size() ? k + 1 : 0];
            through.push_back(loop[k]);
            if (isEnd[loop[k]] != 0 && isEnd[next] != 0) points.addBetween(loop[k], next, through);
          }
          if (through.size() > loop.size()) found[first / kBatch].push_back({face, through});
        }
      });
  std::vector<LongerFace> all;
  for (auto& of : found) std::ranges::move(of, std::back_inserter(all));
  return all;
}

/// Appends a face with this loop, between the cells of another one.
void addFace(const FluidMesh::Faces& from, std::size_t face, const CornerLoop& loop,
             FluidMesh::Faces& out) {
  out.corners.insert(out.corners.end(), loop.begin(), loop.end());
  out.first.push_back(out.corners.size());
  out.owner.push_back(from.owner[face]);
  if (face < from.neighbour.size()) out.neighbour.push_back(from.neighbour[face]);
}

/// Appends some faces as they are.
void addFaces(const FluidMesh::Faces& from, std::size_t begin, std::size_t end,
              FluidMesh::Faces& out) {
  const auto append = [](const auto& rows, std::size_t first, std::size_t last, auto& to) {
    first = std::min(first, rows.size());
    last = std::min(last, rows.size());
    to.insert(to.end(), rows.begin() + static_cast<std::ptrdiff_t>(first),
              rows.begin() + static_cast<std::ptrdiff_t>(last));
  };
  const auto shift = out.corners.size() - from.first[begin];  // modulo 2^64
  append(from.corners, from.first[begin], from.first[end], out.corners);
  append(from.owner, begin, end, out.owner);
  append(from.neighbour, begin, end, out.neighbour);
  for (auto n = begin; n < end; ++n) out.first.push_back(from.first[n + 1] + shift);
}

}  // namespace

void meetEdgeByEdge(FluidMesh& mesh, int threads) {
  const auto longer = facesThrough(mesh, endsOfOpenEdges(mesh, threads), threads);
  if (longer.empty()) return;
  FluidMesh::Faces faces;
  faces.first.reserve(mesh.faces.first.size());
  faces.corners.reserve(mesh.faces.corners.size() + 4 * longer.size());
  faces.owner.reserve(mesh.faces.owner.size());
  faces.neighbour.reserve(mesh.faces.neighbour.size());
  std::vector<std::size_t> firstOf;  // of the faces that each longer one became
  std::vector<CornerLoop> parts;
  std::size_t done = 0;
  for (const auto& [face, loop] : longer) {
    addFaces(mesh.faces, done, face, faces);
    firstOf.push_back(faces.count());
    parts.clear();
    addSimpleLoops(loop, parts);
    for (const auto& part : parts) addFace(mesh.faces, face, part, faces);
    done = face + std::size_t{1};
  }
  addFaces(mesh.faces, done, mesh.faces.count(), faces);
  const auto numberOf = [&](std::size_t face) {
    const auto after = std::ranges::lower_bound(longer, face, {}, &LongerFace::face);
    if (after == longer.end()) return faces.count() - (mesh.faces.count() - face);
    return firstOf[static_cast<std::size_t>(after - longer.begin())] - (after->face - face);
  };
  for (auto& patch : mesh.patches) {
    const auto first = numberOf(patch.firstFace);
    const auto end = numberOf(patch.firstFace + std::size_t{patch.faceCount});
    patch.firstFace = static_cast<std::uint32_t>(first);
    patch.faceCount = static_cast<std::uint32_t>(end - first);
  }
  std::erase_if(mesh.patches, [](const auto& patch) { return patch.faceCount == 0; });
  mesh.faces = std::move(faces);
}

}  // namespace cutwater
