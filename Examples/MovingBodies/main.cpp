// Bodies that move: one that turns as a whole, and one that bends. See README.md.
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

using namespace cutwater;

namespace {

/// The places of a tail's points, which swings to and fro in y, the more the farther from its root.
std::vector<Vec3<double>> bent(const PolygonSoup& tail, double time) {
  auto points = tail.points;
  for (auto& p : points) p.y += 0.1 * p.x * p.x * std::sin(time);
  return points;
}

/// Stands for a time step of a solver: whether it sees the bodies as if they had been built anew.
bool advance(int step, const MeshSDF<double>& rotor, const MeshSDF<double>& fin,
             const PolygonSoup& tail, const std::vector<double>& distances) {
  auto soup = tail;
  soup.points = bent(tail, 0.3 * step);
  const auto tip = rotor.placement().toWorld(Vec3<double>{1.5, 0, 0});
  std::size_t inside = 0;
  for (const double distance : distances) inside += distance < 0 ? 1 : 0;
  std::printf("step %d: %zu cells inside\n", step, inside);
  return inside > 0 && std::abs(rotor.signedDistance(tip) - 0.5) < 1e-12 &&
         fin.signedDistance(tip) == MeshSDF<double>(soup).signedDistance(tip);
}

}  // namespace

int main() {
  const PolygonSoup blade = tessellation::box({-1, -0.1, -0.3}, {1, 0.1, 0.3});
  const PolygonSoup tail = tessellation::box({0, -0.1, -0.2}, {2, 0.1, 0.2}, 16);
  const Level<double> level({-2, -2, -1}, {0.1, 0.1, 0.1});
  const GridPatch<double> gridPatch{level, {{0, 0, 0}, {59, 39, 19}}};
  std::vector<double> distances(gridPatch.indices.count());
  const auto view = GridView<double>::contiguous(distances.data(), gridPatch.indices);
  bool isRight = true;

  // [DOCS
  MeshSDF<double> rotor(blade);
  MeshSDF<double> fin(tail);
  for (int step = 0; step < 10; ++step) {
    // A rigid body: its place is set anew in each step, from its own frame, so no error adds up.
    RigidTransform<double> place;
    place.rotate(9 * step, 2);  // degrees, about the z axis
    place.translate({-0.5, 0, 0});
    rotor.setPlacement(place);

    // A body that deforms: the same connectivity, new places of the points.
    fin = fin.refitted(bent(tail, 0.3 * step));

    fill(rotor | translated(fin, {1, 0, 0}), gridPatch, view, {.band = 3});
    isRight = advance(step, rotor, fin, tail, distances) && isRight;
  }
  // DOCS]
  return isRight ? 0 : 1;
}
