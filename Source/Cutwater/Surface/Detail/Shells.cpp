#include <Cutwater/Surface/Detail/InsideOut.hpp>
#include <Cutwater/Surface/Detail/Shells.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>

namespace cutwater {

namespace {

std::size_t at(FaceId face) {
  return index(face);
}

template <std::floating_point T>
class ShellSearch {
 public:
  explicit ShellSearch(const DcelMesh<T>& mesh) : mesh_(mesh), turned_(mesh.faces().size()) {
    partners_.reserve(mesh.halfEdges().size());
    pairHalfEdges();
  }

  ShellOrientation run(NestedShells nested) {
    if (someRunTheSameWay_) orientPieces();
    takeTriangles();
    const auto positions = normalizedPositions<T>(mesh_.positions(), triangles_);
    auto shells = connectShells(triangles_, positions.size(), neighbours_);
    const auto openEdges = findOpenEdges(triangles_, positions.size(), neighbours_);
    result_.insideOut = insideOutShells(
        {.positions = positions, .triangles = triangles_, .shells = shells, .openEdges = openEdges},
        nested);
    if (result_.turnedFaces > 0) result_.disagreeing = turned_;
    if (result_.turnedFaces + result_.turnedShells() > 0) {
      const auto& whole = result_.insideOut;
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        if (t > 0 && faceOf_[t] == faceOf_[t - 1]) continue;
        const bool withShell = std::ranges::binary_search(whole, shells.shellOf[t]);
        turned_[faceOf_[t]] = turned_[faceOf_[t]] != withShell;
      }
      result_.turned = std::move(turned_);
    }
    for (auto& first : shells.firstTriangles) first = faceOf_[first];
    result_.firstFaces = std::move(shells.firstTriangles);
    return std::move(result_);
  }

 private:
  using Edge = typename DcelMesh<T>::Edge;

  /// Finds the other half-edge of edges with two faces, in either direction.
  void pairHalfEdges() {
    for (const HalfEdgeId e : mesh_.halfEdges()) partners_.push_back(mesh_.twin(e));
    mesh_.visitEdgesWithoutTwins([&](const Edge& edge) {
      if (edge.halfEdges.size() != 2) return;
      partners_[index(edge.halfEdges[0])] = edge.halfEdges[1];
      partners_[index(edge.halfEdges[1])] = edge.halfEdges[0];
      someRunTheSameWay_ = true;
    });
  }

  /// Orients faces connected across edges with two faces consistently, as far as possible. Visits a
  /// face's neighbours in ascending order, whichever way the face is turned, so that a piece that
  /// cannot be oriented is left unchanged the next time.
  void orientPieces() {
    std::vector<bool> seen(mesh_.faces().size());
    std::vector<HalfEdgeId> edges;
    for (const FaceId seed : mesh_.faces()) {
      if (seen[at(seed)]) continue;
      seen[at(seed)] = true;
      std::vector<FaceId> piece{seed};
      bool contradicts = false;
      for (std::size_t done = 0; done < piece.size(); ++done) {
        const FaceId face = piece[done];
        takePairedEdges(face, edges);
        for (const HalfEdgeId e : edges) {
          const HalfEdgeId partner = partners_[index(e)];
          const FaceId next = mesh_.face(partner);
          const bool sameWay = mesh_.origin(e) == mesh_.origin(partner);
          const bool wanted = turned_[at(face)] != sameWay;
          if (!seen[at(next)]) {
            seen[at(next)] = true;
            turned_[at(next)] = wanted;
            piece.push_back(next);
          } else if (turned_[at(next)] != wanted) {
            contradicts = true;
          }
        }
      }
      if (contradicts) ++result_.unorientable;
      letMajorityDecide(piece);
    }
  }

  void takePairedEdges(FaceId face, std::vector<HalfEdgeId>& edges) const {
    edges.clear();
    for (const HalfEdgeId e : mesh_.halfEdges(face)) {
      if (partners_[index(e)] != kNoHalfEdge) edges.push_back(e);
    }
    std::ranges::sort(edges, {}, [&](HalfEdgeId e) { return mesh_.face(partners_[index(e)]); });
  }

  void letMajorityDecide(std::span<const FaceId> piece) {
    const auto isTurned = [&](FaceId face) { return bool{turned_[at(face)]}; };
    auto count = static_cast<std::size_t>(std::ranges::count_if(piece, isTurned));
    if (2 * count > piece.size()) {
      for (const FaceId face : piece) turned_[at(face)] = !turned_[at(face)];
      count = piece.size() - count;
    }
    result_.turnedFaces += count;
  }

  /// Takes the faces' triangles in consistent orientation; takes their neighbours only if no face
  /// changes and all faces are triangles.
  void takeTriangles() {
    triangles_.reserve(mesh_.faces().size());
    faceOf_.reserve(mesh_.faces().size());
    bool allAreTriangles = true;
    for (const FaceId face : mesh_.faces()) {
      for (const auto& [a, b, c] : mesh_.triangles(face)) {
        triangles_.push_back({index(a), index(b), index(c)});
        if (turned_[at(face)]) std::swap(triangles_.back()[1], triangles_.back()[2]);
        faceOf_.push_back(index(face));
      }
      allAreTriangles =
          allAreTriangles && mesh_.vertices(face).size() == 3 && mesh_.triangles(face).size() == 1;
    }
    if (someRunTheSameWay_ || !allAreTriangles) return;
    neighbours_.reserve(triangles_.size());
    for (const FaceId face : mesh_.faces()) {
      auto& own = neighbours_.emplace_back();
      std::size_t i = 0;
      for (const HalfEdgeId e : mesh_.halfEdges(face)) {
        own[i++] = mesh_.hasTwin(e) ? index(mesh_.face(mesh_.twin(e))) : kNone;
      }
    }
  }

  const DcelMesh<T>& mesh_;
  std::vector<HalfEdgeId> partners_;
  bool someRunTheSameWay_ = false;
  std::vector<bool> turned_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> faceOf_;  // per triangle; ascending
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  ShellOrientation result_;
};

}  // namespace

template <std::floating_point T>
ShellOrientation orientShells(const DcelMesh<T>& mesh, NestedShells nested) {
  return ShellSearch<T>(mesh).run(nested);
}

template ShellOrientation orientShells(const DcelMesh<float>&, NestedShells);
template ShellOrientation orientShells(const DcelMesh<double>&, NestedShells);

}  // namespace cutwater
