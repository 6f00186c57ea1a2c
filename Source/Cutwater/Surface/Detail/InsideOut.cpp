#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Surface/Detail/InsideOut.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cutwater {

namespace {

struct Shell {
  bool closed = true;  // each edge is passed equally often in both directions
  bool turned = false;
  double triangles = 0;
  double volume = 0;
  double area = 0;
  double volumeScale = 0;  // sum of the products of lengths in the volume's terms
  // For unbalanced edges: the sum of their corners, the number of these, and the edges' length.
  Vec3<double> corners;
  double cornerCount = 0;
  double rim = 0;
};

/// Finds the shells that contain a vertex of a given shell, by the parity of their crossings along
/// a segment that leads out of the mesh.
class Containment {
 public:
  explicit Containment(const AgreeingTriangles& mesh)
      : shellOf_(mesh.shells.shellOf), lowest_(mesh.shells.firstTriangles.size(), kNone) {
    const auto boxes = triangleBoxes<double>(mesh.positions, mesh.triangles);
    for (const auto& box : boxes) surface_.box.extend(box);
    surface_.positions = mesh.positions;
    surface_.triangles = mesh.triangles;
    tree_ = buildBvh<16, 4>(boxes);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      auto& lowest = lowest_[shellOf_[t]];
      for (const auto vertex : mesh.triangles[t]) lowest = std::min(lowest, vertex);
    }
  }

  /// Visits the shells that contain the given one.
  template <typename Visit>
  void visitAround(std::uint32_t own, Visit&& visit) const {
    const auto exit = exitOf(surface_.box, surface_.positions[lowest_[own]]);
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
  std::vector<std::uint32_t> lowest_;  // vertex of each shell, independent of face orientation
  TriangleSurface<double> surface_;
  BvhArrays<16, 4> tree_;
};

class InsideOutSearch {
 public:
  InsideOutSearch(const AgreeingTriangles& mesh, NestedShells nested)
      : mesh_(mesh), nested_(nested), shells_(mesh.shells.firstTriangles.size()) {}

  std::vector<std::uint32_t> run() {
    noteRims();
    measure();
    correctSmallVolumes();
    turnShells();
    std::vector<std::uint32_t> turned;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].turned) turned.push_back(s);
    }
    return turned;
  }

 private:
  void noteRims() {
    for (const auto& edge : mesh_.openEdges) {
      const auto& lower = mesh_.positions[edge.lower];
      const auto& upper = mesh_.positions[edge.upper];
      auto& shell = shells_[mesh_.shells.shellOf[edge.triangle]];
      shell.closed = false;
      shell.corners += lower + upper;
      shell.cornerCount += 2;
      shell.rim += length(upper - lower);
    }
  }

  /// Computes the shells' volumes. Open ones are closed by fans from the middle of their boundary,
  /// which contribute nothing as seen from there.
  void measure() {
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      auto& shell = shells_[mesh_.shells.shellOf[t]];
      const auto [first, ab, ac] = edgesOf(t);
      const auto a = first - (shell.closed ? start(t) : shell.corners / shell.cornerCount);
      const auto normal = cross(ab, ac);
      shell.volume += dot(a, normal) / 6;
      shell.volumeScale += length(a) * length(ab) * length(ac) / 6;
      shell.area += length(normal) / 2;
      ++shell.triangles;
    }
  }

  /// Recomputes volumes that are within rounding of zero; sheets get none.
  void correctSmallVolumes() {
    std::vector<bool> thin(shells_.size());
    bool someAreThin = false;
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      const auto& shell = shells_[s];
      // A dozen roundings in each term, and one per addition.
      const double rounding = 0x1p-53 * (16 + shell.triangles) * shell.volumeScale;
      thin[s] = shell.closed && std::abs(shell.volume) <= rounding;
      someAreThin = someAreThin || thin[s];
    }
    if (someAreThin) measureThin(thin);
    for (auto& shell : shells_) {
      const double sphere = shell.area * std::sqrt(shell.area / std::numbers::pi) / 6;
      const bool isSheet =
          shell.rim * shell.rim > shell.area && std::abs(shell.volume) < 0.1 * sphere;
      if (isSheet) shell.volume = 0;
    }
  }

  /// Uses twice the precision, for plates a few ulps thick.
  void measureThin(const std::vector<bool>& thin) {
    std::vector<DoubleDouble> volumes(shells_.size());
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto s = mesh_.shells.shellOf[t];
      if (!thin[s]) continue;
      const auto& [v0, v1, v2] = mesh_.triangles[t];
      const auto& a = mesh_.positions[v0];
      const auto normal = cross(DoubleDouble3::difference(mesh_.positions[v1], a),
                                DoubleDouble3::difference(mesh_.positions[v2], a));
      volumes[s] += dot(DoubleDouble3::difference(a, start(t)), normal);
    }
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (thin[s]) shells_[s].volume = static_cast<double>(volumes[s]) / 6;
    }
  }

  void turnShells() {
    if (shells_.size() == 1 || nested_ == NestedShells::Solids) {
      for (auto& shell : shells_) shell.turned = shell.volume < 0;
    } else if (nested_ == NestedShells::Cavities) {
      turnByDepth();
    } else {
      turnWithTheirCavities();
    }
  }

  void turnByDepth() {
    const Containment containment(mesh_);
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      bool isCavity = false;
      containment.visitAround(s, [&](std::uint32_t outer) {
        if (shells_[outer].closed) isCavity = !isCavity;
      });
      shells_[s].turned = isCavity ? shells_[s].volume > 0 : shells_[s].volume < 0;
    }
  }

  void turnWithTheirCavities() {
    std::vector<std::uint32_t> suspects;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].volume < 0) suspects.push_back(s);
    }
    if (suspects.empty()) return;
    const Containment containment(mesh_);
    for (const auto s : suspects) {
      bool isCavity = false;
      containment.visitAround(
          s, [&](std::uint32_t outer) { isCavity = isCavity || shells_[outer].closed; });
      shells_[s].turned = !isCavity;
    }
    const auto wasTurned = [](const Shell& shell) { return shell.turned; };
    if (std::ranges::none_of(shells_, wasTurned)) return;
    std::vector<std::uint32_t> within;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      if (shells_[s].turned) continue;
      containment.visitAround(s, [&](std::uint32_t outer) {
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

  /// A vertex of the triangle's shell.
  [[nodiscard]] const Vec3<double>& start(std::size_t triangle) const {
    const auto first = mesh_.shells.firstTriangles[mesh_.shells.shellOf[triangle]];
    return mesh_.positions[mesh_.triangles[first][0]];
  }
  /// The first corner, and the vectors from there to the others.
  [[nodiscard]] std::array<Vec3<double>, 3> edgesOf(std::size_t triangle) const {
    const auto& [v0, v1, v2] = mesh_.triangles[triangle];
    const auto& a = mesh_.positions[v0];
    return {a, mesh_.positions[v1] - a, mesh_.positions[v2] - a};
  }

  const AgreeingTriangles& mesh_;
  NestedShells nested_;
  std::vector<Shell> shells_;
};

}  // namespace

std::vector<std::uint32_t> insideOutShells(const AgreeingTriangles& surface, NestedShells nested) {
  return InsideOutSearch(surface, nested).run();
}

}  // namespace cutwater
