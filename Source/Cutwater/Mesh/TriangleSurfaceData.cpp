#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

#include <cmath>

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

}  // namespace

template <std::floating_point T>
TriangleSurfaceData<T>::TriangleSurfaceData(const DcelMesh<T>& mesh) {
  auto soup = trianglesOf(mesh, polygons_);
  if (polygons_.empty()) {
    throw Error(ErrorKind::Topology, "the surface has no triangles: " + check(mesh).summary());
  }
  for (const FaceId face : mesh.faces()) patches_.push_back(mesh.patch(face));
  const DcelMesh<T> triangles(soup);
  orientation_ = orientShells(triangles);
  if (orientation_.changesNothing()) {
    take(triangles);
  } else {
    turn(soup, orientation_.turned);
    take(DcelMesh<T>(soup));
  }
  markSlivers();
  openEdges_ = findOpenEdges(triangles_, positions_.size());
}

template <std::floating_point T>
void TriangleSurfaceData<T>::take(const DcelMesh<T>& triangles) {
  scale_ = normalizingScale(triangles.positions());
  for (const auto& p : triangles.positions()) {
    positions_.push_back(scale_ * p);
    size_ = std::max(size_, length(positions_.back()));
  }
  for (const VertexId v : triangles.vertices()) pseudonormals_.push_back(triangles.pseudonormal(v));
  for (const FaceId face : triangles.faces()) {
    Corners corners{};
    Corners across{};
    std::size_t i = 0;
    for (const HalfEdgeId e : triangles.halfEdges(face)) {
      corners[i] = index(triangles.origin(e));
      across[i] = triangles.hasTwin(e) ? index(triangles.face(triangles.twin(e))) : kNone;
      box_.extend(Vec3<double>(positions_[corners[i]]));
      ++i;
    }
    triangles_.push_back(corners);
    neighbours_.push_back(across);
  }
}

template <std::floating_point T>
void TriangleSurfaceData<T>::markSlivers() {
  slivers_.assign((triangles_.size() + 31) / 32, 0);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    const auto& [a, b, c] = triangles_[i];
    if (isSliver(positions_[a], positions_[b], positions_[c])) slivers_[i / 32] |= 1U << i % 32;
  }
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
