#include <Cutwater/Bvh/BvhBuilder.hpp>
#include <Cutwater/Core/DoubleDouble.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/Shells.hpp>
#include <Cutwater/Mesh/SurfaceLocation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace cutwater {

namespace {

std::size_t at(FaceId face) {
  return index(face);
}

struct Shell {
  std::vector<FaceId> faces;
  bool closed = true;  // as many faces run one way along each edge as the other
  bool turned = false;
  double volume = 0;
  // Of unbalanced edges: the sum of their corners, the number of those, and the edges' length.
  Vec3<double> corners;
  double cornerCount = 0;
  double rim = 0;
};

/// Which shells contain a vertex of a given shell: the parity of their passages along a segment
/// that leads out of the mesh.
template <std::floating_point T>
class Containment {
 public:
  Containment(const DcelMesh<T>& mesh, std::span<const Vec3<double>> positions,
              std::span<const std::uint32_t> shellOf)
      : shellOf_(shellOf), positions_(positions) {
    for (const FaceId face : mesh.faces()) {
      const auto v = mesh.vertices(face);
      triangles_.push_back({index(v[0]), index(v[1]), index(v[2])});
    }
    const auto boxes = triangleBoxes<double>(positions_, triangles_);
    for (const auto& box : boxes) surface_.box.extend(box);
    surface_.positions = positions_;
    surface_.triangles = triangles_;
    tree_ = buildBvh<16, 4>(boxes);
  }

  /// Visits the shells that contain the one with this face.
  template <typename Visit>
  void visitAround(FaceId inner, Visit&& visit) const {
    const auto own = shellOf_[at(inner)];
    const auto exit = exitOf(surface_.box, positions_[triangles_[at(inner)][0]]);
    const auto tree = tree_.tree();
    const auto along = [&](const Segment<double>& segment, TriangleVisitor visitor) {
      tree.along(segment, visitor);
    };
    std::vector<std::uint32_t> passed;
    const auto note = [&](std::uint32_t triangle, int) {
      if (shellOf_[triangle] != own) passed.push_back(shellOf_[triangle]);
      return 1.0;
    };
    visitPassages<double>(surface_, exit, along, note);
    std::ranges::sort(passed);
    for (auto first = passed.begin(); first != passed.end();) {
      const auto last = std::upper_bound(first, passed.end(), *first);
      if ((last - first) % 2 != 0) visit(*first);
      first = last;
    }
  }

 private:
  std::span<const std::uint32_t> shellOf_;
  std::span<const Vec3<double>> positions_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  TriangleSurface<double> surface_;
  BvhArrays<16, 4> tree_;
};

template <std::floating_point T>
class ShellSearch {
 public:
  explicit ShellSearch(const DcelMesh<T>& mesh)
      : mesh_(mesh),
        positions_(normalizedPositions(mesh.positions())),
        shellOf_(mesh.faces().size(), kNone),
        turned_(mesh.faces().size()) {
    partners_.reserve(mesh.halfEdges().size());
    pairHalfEdges();
  }

  ShellOrientation run() {
    if (someRunTheSameWay_) orientPieces();
    collectShells();
    for (auto& shell : shells_) measure(shell);
    turnShells();
    for (const auto& shell : shells_) {
      result_.firstFaces.push_back(index(shell.faces.front()));
      if (!shell.turned) continue;
      ++result_.turnedShells;
      for (const FaceId face : shell.faces) turned_[at(face)] = !turned_[at(face)];
    }
    if (result_.turnedFaces + result_.turnedShells > 0) result_.turned = std::move(turned_);
    return std::move(result_);
  }

 private:
  using Edge = typename DcelMesh<T>::Edge;

  /// The other half-edge of edges with two faces, whichever way it runs.
  void pairHalfEdges() {
    for (const HalfEdgeId e : mesh_.halfEdges()) partners_.push_back(mesh_.twin(e));
    mesh_.visitEdgesWithoutTwins([&](const Edge& edge) {
      if (edge.halfEdges.size() != 2) return;
      partners_[index(edge.halfEdges[0])] = edge.halfEdges[1];
      partners_[index(edge.halfEdges[1])] = edge.halfEdges[0];
      someRunTheSameWay_ = true;
    });
  }

  /// Faces connected across edges with two faces agree which way to look, as far as they can.
  void orientPieces() {
    std::vector<bool> seen(mesh_.faces().size());
    for (const FaceId seed : mesh_.faces()) {
      if (seen[at(seed)]) continue;
      seen[at(seed)] = true;
      std::vector<FaceId> piece{seed};
      bool contradicts = false;
      for (std::size_t done = 0; done < piece.size(); ++done) {
        const FaceId face = piece[done];
        for (const HalfEdgeId e : mesh_.halfEdges(face)) {
          const HalfEdgeId partner = partners_[index(e)];
          if (partner == kNoHalfEdge) continue;
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

  void letMajorityDecide(std::span<const FaceId> piece) {
    const auto isTurned = [&](FaceId face) { return bool{turned_[at(face)]}; };
    auto count = static_cast<std::size_t>(std::ranges::count_if(piece, isTurned));
    if (2 * count > piece.size()) {
      for (const FaceId face : piece) turned_[at(face)] = !turned_[at(face)];
      count = piece.size() - count;
    }
    result_.turnedFaces += count;
  }

  /// Faces connected across any edges.
  void collectShells() {
    std::vector<std::uint32_t> parent(mesh_.faces().size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t face) {
      while (parent[face] != face) face = parent[face] = parent[parent[face]];
      return face;
    };
    const auto join = [&](HalfEdgeId one, HalfEdgeId other) {
      const auto first = root(index(mesh_.face(one)));
      const auto second = root(index(mesh_.face(other)));
      parent[std::max(first, second)] = std::min(first, second);
    };
    for (const HalfEdgeId e : mesh_.halfEdges()) {
      if (mesh_.hasTwin(e) && e < mesh_.twin(e)) join(e, mesh_.twin(e));
    }
    mesh_.visitEdgesWithoutTwins([&](const Edge& edge) {
      for (const HalfEdgeId e : edge.halfEdges) join(edge.halfEdges[0], e);
    });
    for (const FaceId face : mesh_.faces()) {
      const auto first = root(index(face));
      if (first == index(face)) {
        shellOf_[first] = static_cast<std::uint32_t>(shells_.size());
        shells_.emplace_back();
      }
      shellOf_[at(face)] = shellOf_[first];
      shells_[shellOf_[first]].faces.push_back(face);
    }
    const auto note = [&](const Edge& edge) { noteBoundary(edge); };
    // Faces with twins agree, but where they contradict each other.
    result_.unorientable == 0 ? mesh_.visitEdgesWithoutTwins(note) : mesh_.visitEdges(note);
  }

  void noteBoundary(const Edge& edge) {
    int balance = 0;
    for (const HalfEdgeId e : edge.halfEdges) {
      balance += (mesh_.origin(e) == edge.lower) != turned_[at(mesh_.face(e))] ? 1 : -1;
    }
    if (balance == 0) return;
    auto& shell = shells_[shellOf_[at(mesh_.face(edge.halfEdges[0]))]];
    shell.closed = false;
    shell.corners += position(edge.lower) + position(edge.upper);
    shell.cornerCount += 2;
    shell.rim += length(position(edge.upper) - position(edge.lower));
  }

  /// The volume of the shell; of an open one, closed by fans from the middle of its boundary: they
  /// contribute nothing, seen from there.
  void measure(Shell& shell) const {
    const auto middle = shell.closed ? position(mesh_.vertices(shell.faces.front())[0])
                                     : shell.corners / shell.cornerCount;
    double area = 0;
    double sizes = 0;
    for (const FaceId face : shell.faces) {
      const auto v = mesh_.vertices(face);
      const auto a = position(v[0]) - middle;
      const auto ab = position(v[1]) - position(v[0]);
      const auto ac = position(v[2]) - position(v[0]);
      const auto normal = cross(ab, ac);
      shell.volume += dot(a, normal) / (turned_[at(face)] ? -6 : 6);
      sizes += length(a) * length(ab) * length(ac) / 6;
      area += length(normal) / 2;
    }
    // A dozen roundings within each term, and one per sum.
    const double rounding = 0x1p-53 * (16 + static_cast<double>(shell.faces.size())) * sizes;
    if (shell.closed && std::abs(shell.volume) <= rounding) shell.volume = volumeOfThin(shell);
    const double sphere = area * std::sqrt(area / std::numbers::pi) / 6;
    const bool isSheet = shell.rim * shell.rim > area && std::abs(shell.volume) < 0.1 * sphere;
    if (isSheet) shell.volume = 0;
  }

  /// In twice the precision, for plates a few ulps thick.
  double volumeOfThin(const Shell& shell) const {
    DoubleDouble sum;
    for (const FaceId face : shell.faces) {
      const auto v = mesh_.vertices(face);
      const auto a = DoubleDouble3::difference(position(v[0]),
                                               position(mesh_.vertices(shell.faces.front())[0]));
      const auto normal = cross(DoubleDouble3::difference(position(v[1]), position(v[0])),
                                DoubleDouble3::difference(position(v[2]), position(v[0])));
      sum += turned_[at(face)] ? -dot(a, normal) : dot(a, normal);
    }
    return static_cast<double>(sum) / 6;
  }

  const Vec3<double>& position(VertexId vertex) const { return positions_[index(vertex)]; }

  void turnShells() {
    std::vector<std::uint32_t> suspects;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].volume < 0) suspects.push_back(s);
    }
    if (suspects.empty()) return;
    if (shells_.size() == 1) {
      shells_[0].turned = true;
      return;
    }
    const Containment<T> containment(mesh_, positions_, shellOf_);
    for (const auto s : suspects) {
      bool isCavity = false;
      containment.visitAround(shells_[s].faces.front(), [&](std::uint32_t outer) {
        isCavity = isCavity || shells_[outer].closed;
      });
      shells_[s].turned = !isCavity;
    }
    const auto wasTurned = [](const Shell& shell) { return shell.turned; };
    if (std::ranges::none_of(shells_, wasTurned)) return;
    std::vector<std::uint32_t> within;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].turned) continue;
      containment.visitAround(shells_[s].faces.front(), [&](std::uint32_t outer) {
        if (shells_[outer].closed && shells_[outer].turned && !isListed(within, s)) {
          within.push_back(s);
        }
      });
    }
    for (const auto s : within) shells_[s].turned = true;
  }

  static bool isListed(const std::vector<std::uint32_t>& list, std::uint32_t id) {
    return !list.empty() && list.back() == id;
  }

  const DcelMesh<T>& mesh_;
  std::vector<Vec3<double>> positions_;  // scaled: volumes neither over- nor underflow
  std::vector<HalfEdgeId> partners_;
  bool someRunTheSameWay_ = false;
  std::vector<std::uint32_t> shellOf_;
  std::vector<bool> turned_;
  std::vector<Shell> shells_;
  ShellOrientation result_;
};

}  // namespace

template <std::floating_point T>
ShellOrientation orientShells(const DcelMesh<T>& mesh) {
  return ShellSearch<T>(mesh).run();
}

template ShellOrientation orientShells(const DcelMesh<float>&);
template ShellOrientation orientShells(const DcelMesh<double>&);

}  // namespace cutwater
