#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Surface/MeshRanges.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// A surface mesh as a doubly connected edge list: every face is a cycle of half-edges, every
/// half-edge stores its origin, its face and its twin.
///
/// Any soup is accepted, with polygons of one corner or more, degenerate, non-manifold or
/// mis-oriented faces, and unused vertices. A half-edge has a twin only where exactly one half-edge
/// runs the opposite way and none the same way; check() (MeshReport.hpp) reports where that fails.
/// The half-edges of a face are contiguous, so next() and prev() are arithmetic. All data is in
/// flat arrays of 32-bit indices, about 75 bytes per triangle plus 24 (float) or 48 (double) of
/// geometry.
///
/// Immutable. All functions are thread-safe, and only those that visit edges allocate memory.
/// Positions are rounded to T first: all geometry is that of the rounded mesh, computed in double.
///
///     for (FaceId face : mesh.faces(vertex)) sum += mesh.normal(face);
template <std::floating_point T>
class DcelMesh {
 public:
  /// Builds the mesh in linear time, whatever the valence of its vertices.
  /// @throws Error(Argument) if the soup's arrays contradict each other, a polygon has no corners,
  /// a corner is not the index of a point, or a coordinate is not finite as a T or its square not
  /// as a double; Error(Limit) for more than 2^32 - 2 points or corners.
  explicit DcelMesh(const PolygonSoup& soup);

  // The whole mesh.
  /// All handles of one kind, in ascending order.
  [[nodiscard]] IdRange<VertexId> vertices() const { return {0, size32(positions_)}; }
  [[nodiscard]] IdRange<HalfEdgeId> halfEdges() const { return {0, size32(origins_)}; }
  [[nodiscard]] IdRange<FaceId> faces() const { return {0, size32(patches_)}; }
  [[nodiscard]] std::span<const Vec3<T>> positions() const { return positions_; }
  [[nodiscard]] std::span<const std::string> patchNames() const { return patchNames_; }
  /// The box around the corners of all faces; unused vertices may be anywhere.
  [[nodiscard]] Box<T> boundingBox() const;

  // One half-edge.
  /// The half-edge's face, which lies to its left seen from outside, and its two ends.
  [[nodiscard]] FaceId face(HalfEdgeId e) const { return faceOf_[index(e)]; }
  [[nodiscard]] VertexId origin(HalfEdgeId e) const { return origins_[index(e)]; }
  [[nodiscard]] VertexId target(HalfEdgeId e) const { return origin(next(e)); }
  /// The half-edge that runs the other way in the neighbouring face, or kNoHalfEdge.
  [[nodiscard]] HalfEdgeId twin(HalfEdgeId e) const { return twins_[index(e)]; }
  [[nodiscard]] bool hasTwin(HalfEdgeId e) const { return twin(e) != kNoHalfEdge; }
  [[nodiscard]] HalfEdgeId next(HalfEdgeId e) const {
    const std::uint32_t face = index(this->face(e));
    const std::uint32_t following = index(e) + 1;
    return HalfEdgeId{following == faceOffsets_[face + 1] ? faceOffsets_[face] : following};
  }
  [[nodiscard]] HalfEdgeId prev(HalfEdgeId e) const {
    const std::uint32_t face = index(this->face(e));
    return HalfEdgeId{(index(e) == faceOffsets_[face] ? faceOffsets_[face + 1] : index(e)) - 1};
  }

  // Around a face.
  /// Counter-clockwise seen from outside; vertex i is the origin of half-edge i.
  [[nodiscard]] IdRange<HalfEdgeId> halfEdges(FaceId face) const {
    return {faceOffsets_[index(face)], faceOffsets_[index(face) + 1]};
  }
  [[nodiscard]] std::span<const VertexId> vertices(FaceId face) const {
    return slice(origins_, faceOffsets_, index(face));
  }
  /// The faces across the half-edges that have a twin, in their order; a face that shares two edges
  /// appears twice.
  [[nodiscard]] auto neighbours(FaceId face) const {
    const auto across = [this](HalfEdgeId e) { return hasTwin(e) ? this->face(twin(e)) : kNoFace; };
    return MappedRange(halfEdges(face).begin(), halfEdges(face).end(), across);
  }
  /// The face as triangles with its orientation: the face itself if it is a triangle; see
  /// triangulate(). Empty if the face has fewer than three distinct corners.
  [[nodiscard]] std::span<const TriangleCorners> triangles(FaceId face) const {
    return slice(triangles_, triangleOffsets_, index(face));
  }
  [[nodiscard]] std::uint32_t patch(FaceId face) const { return patches_[index(face)]; }

  // Around a vertex, in ascending order of half-edges; complete at non-manifold vertices, too.
  /// The half-edges that begin at the vertex, and their faces.
  [[nodiscard]] std::span<const HalfEdgeId> outgoing(VertexId vertex) const {
    return slice(outgoing_, outgoingOffsets_, index(vertex));
  }
  [[nodiscard]] auto faces(VertexId vertex) const {
    const auto its = outgoing(vertex);
    const auto faceOf = [this](HalfEdgeId e) { return face(e); };
    return MappedRange(its.begin(), its.end(), faceOf);
  }
  [[nodiscard]] const Vec3<T>& position(VertexId vertex) const { return positions_[index(vertex)]; }

  /// All half-edges between two distinct vertices, in either direction.
  struct Edge {
    VertexId lower;
    VertexId upper;
    std::span<const HalfEdgeId> halfEdges;  ///< valid during the visit
  };
  /// Visits every undirected edge once, by lower vertex, then in order of appearance. Linear time.
  void visitEdges(FunctionRef<void(const Edge&)> visit) const;
  /// The same, but only for edges without twins: rims, and edges of more than two faces or of two
  /// that run the same way.
  void visitEdgesWithoutTwins(FunctionRef<void(const Edge&)> visit) const;

  // Geometry. Lengths in the units of the positions.

  /// The unit normal by Newell's method: for a non-planar face, that of the best plane; zero for a
  /// face without area. Also the face's pseudonormal.
  [[nodiscard]] Vec3<T> normal(FaceId face) const { return normals_[index(face)]; }
  /// The sum of the areas of its triangles.
  [[nodiscard]] T area(FaceId face) const;
  /// The centroid of the area; the mean of the corners if there is no area.
  [[nodiscard]] Vec3<T> centroid(FaceId face) const;
  /// The angle-weighted pseudonormal (Baerentzen & Aanaes 2005): a unit vector, or zero where no
  /// face has area or the faces cancel.
  [[nodiscard]] Vec3<T> pseudonormal(VertexId vertex) const {
    return pseudonormals_[index(vertex)];
  }
  /// The direction of the sum of the two faces' unit normals: a unit vector, or zero; the normal of
  /// the one face where there is no twin.
  [[nodiscard]] Vec3<T> pseudonormal(HalfEdgeId e) const;
  /// The sum over all triangles; linear time.
  [[nodiscard]] double totalArea() const;
  /// By the divergence theorem: positive where faces are counter-clockwise seen from outside.
  /// Meaningful for closed meshes only. Linear time.
  [[nodiscard]] double signedVolume() const;
  /// Both the area and the volume.
  [[nodiscard]] SurfaceMeasure measure() const;

 private:
  template <typename V>
  static std::uint32_t size32(const V& values) {
    return static_cast<std::uint32_t>(values.size());
  }
  template <typename V>
  static std::span<const V> slice(const std::vector<V>& values,
                                  const std::vector<std::uint32_t>& offsets, std::uint32_t i) {
    return std::span(values).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }

  void takeFaces(const PolygonSoup& soup);
  void collectOutgoing();
  void pairTwins();
  void pairTwinsAt(VertexId vertex);
  void takeTriangles(const PolygonSoup& soup);
  void computeNormals();
  [[nodiscard]] std::array<Vec3<double>, 3> corners(const TriangleCorners& triangle) const;

  std::vector<Vec3<T>> positions_;
  std::vector<std::uint32_t> faceOffsets_;  ///< face i has half-edges [faceOffsets_[i], ... [i+1])
  std::vector<VertexId> origins_;           ///< per half-edge
  std::vector<HalfEdgeId> twins_;           ///< per half-edge
  std::vector<FaceId> faceOf_;              ///< per half-edge
  std::vector<std::uint32_t> outgoingOffsets_;  ///< per vertex, into outgoing_
  std::vector<HalfEdgeId> outgoing_;
  std::vector<std::uint32_t> triangleOffsets_;  ///< per face, into triangles_
  std::vector<TriangleCorners> triangles_;
  std::vector<std::uint32_t> patches_;
  std::vector<std::string> patchNames_;
  std::vector<Vec3<T>> normals_;        ///< per face
  std::vector<Vec3<T>> pseudonormals_;  ///< per vertex
};

extern template class DcelMesh<float>;
extern template class DcelMesh<double>;

}  // namespace cutwater
