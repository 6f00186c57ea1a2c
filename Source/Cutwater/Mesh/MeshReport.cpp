#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace cutwater {
namespace {

/// Union-find with path halving; the least member stands for its set.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  /// Right once all has been united: every set has exactly one.
  [[nodiscard]] bool isRoot(std::uint32_t a) const { return parent_[a] == a; }

 private:
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

  std::vector<std::uint32_t> parent_;
};

/// A cycle of distinct corners from its least one, towards the lesser of that one's neighbours: the
/// same for every rotation and for both orientations.
class CanonicalCycle {
 public:
  explicit CanonicalCycle(std::span<const VertexId> corners)
      : corners_(corners),
        first_(static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin())) {
    forward_ = at(1) < at(size() - 1);
  }

  [[nodiscard]] std::size_t size() const { return corners_.size(); }
  [[nodiscard]] bool isForward() const { return forward_; }
  /// Corner i of the cycle.
  [[nodiscard]] VertexId operator[](std::size_t i) const {
    return forward_ ? at(i) : at((size() - i) % size());
  }
  [[nodiscard]] std::size_t hash() const {
    std::uint64_t h = size();
    for (std::size_t i = 0; i < size(); ++i) {  // the mixer of SplitMix64, Steele et al. 2014
      h += 0x9e3779b97f4a7c15U + index((*this)[i]);
      h = (h ^ (h >> 30U)) * 0xbf58476d1ce4e5b9U;
      h = (h ^ (h >> 27U)) * 0x94d049bb133111ebU;
      h ^= h >> 31U;
    }
    return h;
  }
  [[nodiscard]] bool operator==(const CanonicalCycle& other) const {
    if (size() != other.size()) return false;
    for (std::size_t i = 0; i < size(); ++i) {
      if ((*this)[i] != other[i]) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] VertexId at(std::size_t i) const { return corners_[(first_ + i) % size()]; }

  std::span<const VertexId> corners_;
  std::size_t first_;
  bool forward_ = true;
};

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

  /// The corner of e's face at one end of e, as the half-edge that leaves it.
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
    // The halves of a bow tie may cancel; an area may be too small for its number.
    return std::ranges::any_of(mesh_.triangles(face), [this](const TriangleCorners& triangle) {
      std::array<Vec3<double>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = Vec3<double>(mesh_.position(triangle[i]));
      return polygonArea(corners).normal != Vec3<double>{};
    });
  }

  /// A hash table of faces with open addressing, at most half full.
  void findDuplicates() {
    std::vector<FaceId> table(std::bit_ceil(2 * report_.faces + 1), kNoFace);
    const std::size_t mask = table.size() - 1;
    for (const FaceId face : mesh_.faces()) {
      if (!hasDistinctCorners_[index(face)]) continue;
      const CanonicalCycle cycle(mesh_.vertices(face));
      for (std::size_t slot = cycle.hash() & mask;; slot = (slot + 1) & mask) {
        if (table[slot] == kNoFace) {
          table[slot] = face;
          break;
        }
        const CanonicalCycle earlier(mesh_.vertices(table[slot]));
        if (!(cycle == earlier)) continue;
        const bool same = cycle.isForward() == earlier.isForward();
        (same ? report_.duplicateFaces : report_.oppositeFaces).add(face);
        break;
      }
    }
  }

  void summarise() {
    const auto signedCount = [](std::size_t n) { return static_cast<long long>(n); };
    report_.eulerCharacteristic = signedCount(report_.vertices - report_.unusedVertices.count) -
                                  signedCount(report_.edges) + signedCount(report_.faces);
    if (report_.isClosedOriented() && report_.isManifold() && !report_.repeatedCornerFaces) {
      report_.genus = signedCount(report_.components) - report_.eulerCharacteristic / 2;
    }
    report_.area = mesh_.totalArea();
    report_.volume = mesh_.signedVolume();
  }

  const DcelMesh<T>& mesh_;
  MeshReport report_;
  DisjointSets components_{mesh_.faces().size()};  ///< of faces
  DisjointSets fans_{mesh_.halfEdges().size()};    ///< of corners: faces that turn about a vertex
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
