#pragma once

#include <Cutwater/Surface/DcelMesh.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cutwater {

/// How often something was found, and the first few places.
template <typename Place>
struct Findings {
  static constexpr std::size_t kExamples = 8;

  std::size_t count = 0;        ///< in total
  std::vector<Place> examples;  ///< at most kExamples

  /// Adds one finding.
  void add(const Place& place) {
    if (count++ < kExamples) examples.push_back(place);
  }
  /// Appends later findings.
  void add(const Findings& later) {
    count += later.count;
    for (const auto& place : later.examples) {
      if (examples.size() < kExamples) examples.push_back(place);
    }
  }
  [[nodiscard]] explicit operator bool() const { return count > 0; }
};

/// One half-edge of an edge, with its ends.
struct EdgePlace {
  HalfEdgeId halfEdge;
  VertexId origin;
  VertexId target;
};

/// What is wrong with a surface mesh, and what kind of surface it is. Faces are numbered like the
/// polygons of the soup, vertices like its points, from 0.
struct MeshReport {
  std::size_t faces = 0;
  std::size_t triangles = 0;  ///< after triangulation
  std::size_t edges = 0;      ///< undirected, between distinct vertices
  std::size_t vertices = 0;   ///< unused ones included

  Findings<EdgePlace> boundaryEdges;       ///< one face only: the surface is open here
  Findings<EdgePlace> nonManifoldEdges;    ///< more than two faces
  Findings<EdgePlace> misorientedEdges;    ///< two faces that run along the edge the same way
  std::size_t oddEdges = 0;                ///< with an odd number of faces, boundary edges included
  std::size_t unbalancedEdges = 0;         ///< see isOriented(); mis-oriented edges included
  Findings<VertexId> nonManifoldVertices;  ///< faces in several fans that touch at the vertex only
  Findings<VertexId> unusedVertices;
  Findings<FaceId> repeatedCornerFaces;  ///< a corner comes twice, or there are fewer than three
  Findings<FaceId> zeroAreaFaces;
  /// Faces with the same cycle of corners as an earlier face, and the same orientation ...
  Findings<FaceId> duplicateFaces;
  Findings<FaceId> oppositeFaces;  ///< ... or the opposite one

  std::size_t components = 0;         ///< sets of faces connected across edges
  long long eulerCharacteristic = 0;  ///< used vertices - edges + faces
  /// The number of handles, summed over the components; for closed, oriented manifolds only.
  std::optional<long long> genus;
  double area = 0;
  double volume = 0;  ///< signed; meaningful for closed meshes only

  /// No edge with an odd number of faces.
  [[nodiscard]] bool isClosed() const { return oddEdges == 0 && faces > 0; }
  /// Along each edge, as many faces run one way as the other, apart from an odd one.
  [[nodiscard]] bool isOriented() const { return unbalancedEdges == 0; }
  [[nodiscard]] bool isManifold() const { return !nonManifoldEdges && !nonManifoldVertices; }
  /// Every half-edge has a twin (except those from a vertex to itself), as signs by pseudonormals
  /// require. Fans may still touch at a vertex: see isManifold().
  [[nodiscard]] bool isClosedOriented() const {
    return faces > 0 && !boundaryEdges && !nonManifoldEdges && !misorientedEdges;
  }
  /// Closed and oriented, but with the normals pointing into the solid.
  [[nodiscard]] bool isInsideOut() const { return isClosedOriented() && volume < 0; }
  /// There are no findings, and the mesh is not inside out.
  [[nodiscard]] bool isClean() const;

  /// One line: "closed, oriented, manifold; 12 triangles, 1 component" or
  /// "not closed; 3 open edges, 1 duplicate face; 11 triangles, 1 component".
  [[nodiscard]] std::string summary() const;
  /// One line per property and per kind of defect with its first places, each ended by '\n'.
  [[nodiscard]] std::string table() const;
};

/// Looks for all defects, in linear time. Defects are reported, never thrown.
template <std::floating_point T>
[[nodiscard]] MeshReport check(const DcelMesh<T>& mesh);

extern template MeshReport check(const DcelMesh<float>&);
extern template MeshReport check(const DcelMesh<double>&);

}  // namespace cutwater
