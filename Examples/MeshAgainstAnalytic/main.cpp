// Meshes of a torus against the torus itself: distances converge with the second power of the
// spacing. See README.md.
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Shapes/Torus.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

using namespace cutwater;

namespace {

/// The largest difference of distances at points in the box, and of normals where these are near.
struct Difference {
  double distance = 0;
  double degrees = 0;
};

Difference compare(const MeshSDF<double>& mesh, const Torus<double>& torus,
                   const Box<double>& box) {
  std::mt19937 random(1);
  Difference most;
  for (int i = 0; i < 20000; ++i) {
    Vec3<double> p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::uniform_real_distribution(box.lower[axis], box.upper[axis])(random);
    }
    const double exact = torus.signedDistance(p);
    most.distance = std::max(most.distance, std::abs(mesh.signedDistance(p) - exact));
    if (std::abs(exact) > 0.1) continue;
    const double cosine = dot(normalized(mesh.gradient(p)), torus.gradient(p));
    most.degrees =
        std::max(most.degrees, std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi);
  }
  return most;
}

}  // namespace

int main() {
  std::printf("spacing  triangles  distance off by  normal off by\n");
  const Torus<double> torus(1, 0.4);
  const auto box = torus.boundingBox().grown(0.5);
  double before = 0;
  bool converges = true;
  for (const double spacing : {0.16, 0.08, 0.04, 0.02}) {
    // [DOCS
    const MeshSDF<double> mesh(
        isosurface<double>(torus, nodesAround(torus.boundingBox(), spacing)));
    // DOCS]
    const auto [distance, degrees] = compare(mesh, torus, box);
    std::printf("%7.2f %10zu %16.2e %9.2f deg\n", spacing, mesh.triangleCount(), distance, degrees);
    // Half the spacing: a quarter of the difference, or nearly.
    converges = converges && (before == 0 || distance < 0.35 * before);
    before = distance;
  }
  return converges ? 0 : 1;
}
