#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace cutwater {

namespace {

/// The mesh's faces as triangles; `polygons` tells which face each is part of.
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
TriangleSurfaceData<T>::TriangleSurfaceData(const DcelMesh<T>& mesh) {
  for (const FaceId face : mesh.faces()) patches_.push_back(mesh.patch(face));
  std::optional<DcelMesh<T>> split;
  if (hasOnlyTriangles(mesh)) {
    polygons_.resize(mesh.faces().size());
    std::iota(polygons_.begin(), polygons_.end(), 0U);
  } else {
    split.emplace(trianglesOf(mesh, polygons_));
  }
  if (polygons_.empty()) {
    throw Error(ErrorKind::Topology, "the surface has no triangles: " + check(mesh).summary());
  }
  takeOriented(split ? *split : mesh);
  markSlivers();
  openEdges_ = findOpenEdges(triangles_, positions_.size(), neighbours_);
}

template <std::floating_point T>
void TriangleSurfaceData<T>::takeOriented(const DcelMesh<T>& triangles) {
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
void TriangleSurfaceData<T>::take(const DcelMesh<T>& triangles) {
  scale_ = normalizingScale(triangles.positions());
  for (const auto& p : triangles.positions()) {
    positions_.push_back(scale_ * p);
    size_ = std::max(size_, length(positions_.back()));
  }
  for (const VertexId v : triangles.vertices()) pseudonormals_.push_back(triangles.pseudonormal(v));
  triangles_.resize(triangles.faces().size());
  neighbours_.resize(triangles_.size());
  parallelFor(triangles_.size(), {.grain = 16384}, [&](std::size_t begin, std::size_t end) {
    for (const FaceId face :
         IdRange<FaceId>(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end))) {
      std::size_t i = 0;
      for (const HalfEdgeId e : triangles.halfEdges(face)) {
        triangles_[index(face)][i] = index(triangles.origin(e));
        neighbours_[index(face)][i++] =
            triangles.hasTwin(e) ? index(triangles.face(triangles.twin(e))) : kNone;
      }
    }
  });
  for (const auto& triangle : triangles_) {
    for (const auto v : triangle) box_.extend(Vec3<double>(positions_[v]));
  }
}

template <std::floating_point T>
void TriangleSurfaceData<T>::markSlivers() {
  slivers_.assign((triangles_.size() + 31) / 32, 0);
  // By words: no two threads write to the same one.
  parallelFor(slivers_.size(), {.grain = 512}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 32 * begin; i < std::min(32 * end, triangles_.size()); ++i) {
      const auto& [a, b, c] = triangles_[i];
      if (isSliver(positions_[a], positions_[b], positions_[c])) slivers_[i / 32] |= 1U << i % 32;
    }
  });
}

template <std::floating_point T>
auto TriangleSurfaceData<T>::addTo(BlockWriter& writer) const -> Sections {
  return {.positions = writer.add(positions_),
          .triangles = writer.add(triangles_),
          .neighbours = writer.add(neighbours_),
          .slivers = writer.add(slivers_),
          .pseudonormals = writer.add(pseudonormals_),
          .polygons = writer.add(polygons_),
          .patches = writer.add(patches_),
          .scale = scale_,
          .size = size_,
          .box = box_};
}

template <std::floating_point T>
TriangleSurface<T> TriangleSurfaceData<T>::Sections::view(const Block& block) const {
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

template class TriangleSurfaceData<float>;
template class TriangleSurfaceData<double>;

}  // namespace cutwater
