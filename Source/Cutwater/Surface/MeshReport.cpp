#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Surface/Detail/CanonicalCycle.hpp>
#include <Cutwater/Surface/Detail/IndexTable.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <array>

namespace cutwater {
namespace {

template <std::floating_point T>
class Checker {
 public:
  explicit Checker(const DcelMesh<T>& mesh) : mesh_(mesh) {}

  MeshReport run() {
    report_.faces = mesh_.faces().size();
    report_.vertices = mesh_.vertices().size();
    checkEdges();
    checkVertices();
    checkFaces();
    findDuplicates();
    summarise();
    return std::move(report_);
  }

 private:
  using Edge = typename DcelMesh<T>::Edge;

  /// The corner of e's face at one end of e, given by the half-edge that leaves it.
  [[nodiscard]] std::uint32_t cornerAt(VertexId end, HalfEdgeId e) const {
    return index(mesh_.origin(e) == end ? e : mesh_.next(e));
  }

  void checkEdges() {
    mesh_.visitEdges([this](const Edge& edge) { checkEdge(edge); });
    for (const HalfEdgeId e : mesh_.halfEdges()) {
      if (mesh_.origin(e) == mesh_.target(e)) fans_.unite(index(e), index(mesh_.next(e)));
    }
  }

  void checkEdge(const Edge& edge) {
    const HalfEdgeId first = edge.halfEdges.front();
    const EdgePlace place{first, mesh_.origin(first), mesh_.target(first)};
    std::ptrdiff_t balance = 0;
    for (const HalfEdgeId e : edge.halfEdges) {
      balance += mesh_.origin(e) == edge.lower ? 1 : -1;
      components_.unite(index(mesh_.face(first)), index(mesh_.face(e)));
    }
    const std::size_t uses = edge.halfEdges.size();
    ++report_.edges;
    if (uses == 1) report_.boundaryEdges.add(place);
    if (uses > 2) report_.nonManifoldEdges.add(place);
    if (uses == 2 && balance != 0) report_.misorientedEdges.add(place);
    if (uses % 2 != 0) ++report_.oddEdges;
    if (std::abs(balance) > 1) ++report_.unbalancedEdges;
    if (uses != 2) return;
    for (const VertexId end : {edge.lower, edge.upper}) {
      fans_.unite(cornerAt(end, edge.halfEdges[0]), cornerAt(end, edge.halfEdges[1]));
    }
  }

  void checkVertices() {
    for (const VertexId v : mesh_.vertices()) {
      const auto corners = mesh_.outgoing(v);
      if (corners.empty()) report_.unusedVertices.add(v);
      const auto fans = std::ranges::count_if(
          corners, [&](HalfEdgeId corner) { return fans_.isRoot(index(corner)); });
      if (fans > 1) report_.nonManifoldVertices.add(v);
    }
  }

  void checkFaces() {
    std::vector<FaceId> lastFace(mesh_.vertices().size(), kNoFace);
    hasDistinctCorners_.assign(report_.faces, true);
    for (const FaceId face : mesh_.faces()) {
      bool distinct = mesh_.vertices(face).size() >= 3;
      for (const VertexId v : mesh_.vertices(face)) {
        distinct = distinct && lastFace[index(v)] != face;
        lastFace[index(v)] = face;
      }
      hasDistinctCorners_[index(face)] = distinct;
      if (!distinct) report_.repeatedCornerFaces.add(face);
      if (!hasArea(face)) report_.zeroAreaFaces.add(face);
      report_.triangles += mesh_.triangles(face).size();
      if (components_.isRoot(index(face))) ++report_.components;
    }
  }

  [[nodiscard]] bool hasArea(FaceId face) const {
    if (mesh_.normal(face) != Vec3<T>{}) return true;
    // The halves of a bow tie may cancel, and an area may underflow.
    return std::ranges::any_of(mesh_.triangles(face), [this](const TriangleCorners& triangle) {
      std::array<Vec3<double>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = Vec3<double>(mesh_.position(triangle[i]));
      return polygonArea(corners).normal != Vec3<double>{};
    });
  }

  void findDuplicates() {
    const auto cycleOf = [this](std::uint32_t face) {
      return detail::CanonicalCycle(mesh_.vertices(FaceId{face}));
    };
    detail::IndexTable table;
    for (const FaceId face : mesh_.faces()) {
      if (!hasDistinctCorners_[index(face)]) continue;
      const auto cycle = cycleOf(index(face));
      const std::uint32_t earlier = table.findOrInsert(
          index(face), [&](std::uint32_t i) { return cycleOf(i).hash(); },
          [&](std::uint32_t i) { return cycleOf(i) == cycle; });
      if (earlier == index(face)) continue;
      const bool same = cycle.isForward() == cycleOf(earlier).isForward();
      (same ? report_.duplicateFaces : report_.oppositeFaces).add(face);
    }
  }

  void summarise() {
    const auto signedCount = [](std::size_t n) { return static_cast<long long>(n); };
    report_.eulerCharacteristic = signedCount(report_.vertices - report_.unusedVertices.count) -
                                  signedCount(report_.edges) + signedCount(report_.faces);
    if (report_.isClosedOriented() && report_.isManifold() && !report_.repeatedCornerFaces) {
      report_.genus = signedCount(report_.components) - report_.eulerCharacteristic / 2;
    }
    const auto [area, volume] = mesh_.measure();
    report_.area = area;
    report_.volume = volume;
  }

  const DcelMesh<T>& mesh_;
  MeshReport report_;
  detail::DisjointSets components_{mesh_.faces().size()};  ///< of faces
  detail::DisjointSets fans_{
      mesh_.halfEdges().size()};  ///< of corners: faces that turn about a vertex
  std::vector<bool> hasDistinctCorners_;
};

}  // namespace

template <std::floating_point T>
MeshReport check(const DcelMesh<T>& mesh) {
  return Checker<T>(mesh).run();
}

template MeshReport check(const DcelMesh<float>&);
template MeshReport check(const DcelMesh<double>&);

}  // namespace cutwater
