#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Surface/Detail/InsideOut.hpp>
#include <Cutwater/Surface/Detail/Pseudonormals.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace cutwater {

namespace {

/// The mesh's faces as triangles; `polygons` receives the face that each is part of.
template <std::floating_point T>
PolygonSoup trianglesOf(const DcelMesh<T>& mesh, std::vector<std::uint32_t>& polygons) {
  PolygonSoup soup;
  soup.points.reserve(mesh.positions().size());
  for (const auto& p : mesh.positions()) soup.points.emplace_back(p);
  for (const FaceId face : mesh.faces()) {
    for (const auto& [a, b, c] : mesh.triangles(face)) {
      soup.addPolygon(std::array{index(a), index(b), index(c)}, mesh.patch(face));
      polygons.push_back(index(face));
    }
  }
  soup.patchNames.assign(mesh.patchNames().begin(), mesh.patchNames().end());
  return soup;
}

void turn(PolygonSoup& triangles, const std::vector<bool>& chosen) {
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) std::swap(triangles.corners[3 * i + 1], triangles.corners[3 * i + 2]);
  }
}

template <std::floating_point T>
bool hasOnlyTriangles(const DcelMesh<T>& mesh) {
  return std::ranges::all_of(mesh.faces(), [&](FaceId face) {
    return mesh.vertices(face).size() == 3 && mesh.triangles(face).size() == 1;
  });
}

}  // namespace

template <std::floating_point T>
TriangleSurfaceArrays<T>::TriangleSurfaceArrays(const DcelMesh<T>& mesh) {
  for (const FaceId face : mesh.faces()) patches_.own().push_back(mesh.patch(face));
  std::optional<DcelMesh<T>> split;
  auto& polygons = polygons_.own();
  if (hasOnlyTriangles(mesh)) {
    polygons.resize(mesh.faces().size());
    std::iota(polygons.begin(), polygons.end(), 0U);
  } else {
    split.emplace(trianglesOf(mesh, polygons));
  }
  if (polygons.empty()) {
    throw Error(ErrorKind::Topology, "the surface has no triangles: " + check(mesh).summary());
  }
  takeOriented(split ? *split : mesh);
  measureTriangles();
  findEdges();
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::findEdges() {
  openEdges_ = findOpenEdges(triangles(), positions_.size(), neighbours_.view());
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::takeOriented(const DcelMesh<T>& triangles) {
  orientation_ = orientShells(triangles);
  if (orientation_.changesNothing()) {
    take(triangles);
    return;
  }
  std::vector<std::uint32_t> faces;
  auto soup = trianglesOf(triangles, faces);
  turn(soup, orientation_.turned);
  take(DcelMesh<T>(soup));
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::take(const DcelMesh<T>& triangles) {
  pseudonormals_.reserve(triangles.positions().size());
  for (const VertexId v : triangles.vertices()) pseudonormals_.push_back(triangles.pseudonormal(v));
  auto& corners = triangles_.own();
  auto& neighbours = neighbours_.own();
  corners.resize(triangles.faces().size());
  neighbours.resize(corners.size());
  parallelFor(corners.size(), {.grain = 16384}, [&](std::size_t begin, std::size_t end) {
    for (const FaceId face :
         IdRange<FaceId>(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end))) {
      std::size_t i = 0;
      for (const HalfEdgeId e : triangles.halfEdges(face)) {
        corners[index(face)][i] = index(triangles.origin(e));
        neighbours[index(face)][i++] =
            triangles.hasTwin(e) ? index(triangles.face(triangles.twin(e))) : kNone;
      }
    }
  });
  takePositions(triangles.positions());
}

template <std::floating_point T>
TriangleSurfaceArrays<T>::TriangleSurfaceArrays(const TriangleSurface<T>& before,
                                                const SignReport& signs,
                                                std::span<const std::uint32_t> insideOut,
                                                std::span<const Vec3<T>> positions)
    : triangles_(before.triangles),
      neighbours_(before.neighbours),
      polygons_(before.polygons),
      patches_(before.patches) {
  takePositions(positions);
  orientAgain(positions, signs, insideOut);
  std::vector<TriangleCorners> corners;
  corners.reserve(triangles().size());
  for (const auto& [a, b, c] : triangles()) {
    corners.push_back({VertexId{a}, VertexId{b}, VertexId{c}});
  }
  pseudonormals_ = cutwater::pseudonormals<T>(positions, corners).vertices;
  measureTriangles();
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::takePositions(std::span<const Vec3<T>> positions) {
  scale_ = normalizingScale(positions, triangles());
  // Points of no triangle may be too far away for this scale.
  constexpr T kMost = std::numeric_limits<T>::max();
  constexpr Vec3<T> kFarthest{kMost, kMost, kMost};
  positions_.reserve(positions.size());
  for (const auto& p : positions) {
    positions_.push_back(min(max(scale_ * p, -kFarthest), kFarthest));
  }
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::orientAgain(std::span<const Vec3<T>> positions,
                                           const SignReport& signs,
                                           std::span<const std::uint32_t> wereInsideOut) {
  orientation_.turnedFaces = signs.turnedFaces;
  orientation_.unorientable = signs.unorientable;
  auto shells = signs.shells == 1
                    ? ConnectedShells{std::vector<std::uint32_t>(triangles().size()), {0}}
                    : connectShells(triangles(), positions.size(), neighbours_.view());
  turnShells(shells, wereInsideOut);
  if (!signs.isClosed()) findEdges();
  orientation_.insideOut =
      insideOutShells({.positions = normalizedPositions(positions, triangles()),
                       .triangles = triangles(),
                       .shells = shells,
                       .openEdges = openEdges_});
  turnShells(shells, orientation_.insideOut);
  if (!signs.isClosed() && !orientation_.insideOut.empty()) findEdges();
  orientation_.firstFaces = std::move(shells.firstTriangles);
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::turnShells(const ConnectedShells& shells,
                                          std::span<const std::uint32_t> chosen) {
  if (chosen.empty()) return;
  auto& triangles = triangles_.own();
  auto& neighbours = neighbours_.own();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!std::ranges::binary_search(chosen, shells.shellOf[t])) continue;
    std::swap(triangles[t][1], triangles[t][2]);    // a, c, b, whose edges are
    std::swap(neighbours[t][0], neighbours[t][2]);  // ca, bc, ab
  }
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::measureTriangles() {
  for (const auto& triangle : triangles()) {
    for (const auto v : triangle) {
      box_.extend(Vec3<double>(positions_[v]));
      size_ = std::max(size_, length(positions_[v]));
    }
  }
  markSlivers();
}

template <std::floating_point T>
void TriangleSurfaceArrays<T>::markSlivers() {
  const auto triangles = this->triangles();
  slivers_.assign((triangles.size() + 31) / 32, 0);
  // In whole words, so that no two threads write to the same one.
  parallelFor(slivers_.size(), {.grain = 512}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 32 * begin; i < std::min(32 * end, triangles.size()); ++i) {
      const auto& [a, b, c] = triangles[i];
      if (isSliver(positions_[a], positions_[b], positions_[c])) slivers_[i / 32] |= 1U << i % 32;
    }
  });
}

template <std::floating_point T>
auto TriangleSurfaceArrays<T>::addTo(BlockWriter& writer) const -> Sections {
  return {.positions = writer.add(positions_),
          .triangles = writer.add(triangles_.view()),
          .neighbours = writer.add(neighbours_.view()),
          .slivers = writer.add(slivers_),
          .pseudonormals = writer.add(pseudonormals_),
          .polygons = writer.add(polygons_.view()),
          .patches = writer.add(patches_.view()),
          .scale = scale_,
          .size = size_,
          .box = box_};
}

template <std::floating_point T>
TriangleSurface<T> TriangleSurfaceArrays<T>::Sections::view(const Block& block) const {
  TriangleSurface<T> surface;
  surface.positions = block.array<Vec3<T>>(positions);
  surface.triangles = block.array<Corners>(triangles);
  surface.neighbours = block.array<Corners>(neighbours);
  surface.slivers = block.array<std::uint32_t>(slivers);
  surface.pseudonormals = block.array<Vec3<T>>(pseudonormals);
  surface.polygons = block.array<std::uint32_t>(polygons);
  surface.patches = block.array<std::uint32_t>(patches);
  surface.scale = scale;
  surface.size = size;
  surface.box = box;
  return surface;
}

template class TriangleSurfaceArrays<float>;
template class TriangleSurfaceArrays<double>;

}  // namespace cutwater
