#pragma once

#include <Cutwater/Mesh/MeshSDF.hpp>

#include <cmath>
#include <vector>

#include "Fuzz.hpp"
#include "Support/Brick.hpp"

namespace cutwater::test {

/// Corners and centre of the mesh's box, the first points of its triangles, and places between and
/// beyond them.
template <typename T>
std::vector<Vec3<T>> probesOf(const MeshSDF<T>& mesh) {
  constexpr std::size_t kMost = 6;
  std::vector<Vec3<T>> probes;
  const auto box = mesh.surfaceBox();
  if (isFinite(box.lower) && isFinite(box.upper)) {
    probes = {box.lower, T(0.5) * box.lower + T(0.5) * box.upper, T(1.5) * box.upper};
  }
  for (std::uint32_t id = 0; id < mesh.triangleCount() && probes.size() < kMost; ++id) {
    const auto t = mesh.triangle(id);
    probes.push_back(t[0]);
    probes.push_back(T(0.25) * t[0] + T(0.25) * t[1] + T(0.5) * t[2]);
  }
  return probes;
}

/// Whether squares of the coordinates neither overflow nor vanish; of others there is an answer,
/// but it is not as close.
template <typename T>
bool isOfOrdinarySize(const MeshSDF<T>& mesh) {
  constexpr bool kSingle = sizeof(T) == sizeof(float);
  const auto box = mesh.surfaceBox();
  const T size = std::max(maxComponent(abs(box.lower)), maxComponent(abs(box.upper)));
  return T(kSingle ? 1e-18 : 1e-150) < size && size < T(kSingle ? 1e18 : 1e150);
}

/// What is promised of every mesh, whatever its triangles and however far they are from being a
/// surface.
template <typename T>
void expectPromises(const MeshSDF<T>& mesh) {
  const bool isOrdinary = isOfOrdinarySize(mesh);
  const auto probes = probesOf(mesh);
  std::vector<T> values(probes.size());
  mesh.signedDistances(probes, values, {.threads = 1});
  const auto brick = brickBetween(probes.front(), probes.back());
  std::vector<T> brickValues(brick.size());
  mesh.signedDistances(brick, brickValues, {.threads = 1});
  for (std::size_t i = 0; i < brick.size(); i += 7) {
    const bool isSame = brickValues[i] == mesh.signedDistance(brick[i]);
    expect(isSame || !isOrdinary || !isFinite(brick[i]), "neighbours have the same bits");
  }
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto p = probes[i];
    const auto q = probes[(i + 1) % probes.size()];
    if (!isFinite(p) || !isFinite(q)) continue;
    const T value = mesh.signedDistance(p);
    expect(!std::isnan(value), "a finite point has a value");
    expect(value == values[i], "batches have the same bits");
    const auto nearest = mesh.closestPoint(p);
    expect(nearest.distance == value, "closestPoint() tells the value");
    expect(!isOrdinary || nearest.triangle < mesh.triangleCount(),
           "the closest point is on a triangle");
    const Box<T> box{min(p, q), max(p, q)};
    BoxHint hint;
    const auto bounds = mesh.bounds(box, &hint);
    expect(!isOrdinary || (bounds.lower <= value && value <= bounds.upper),
           "bounds hold the value");
    const auto boxClass = mesh.classify(box, &hint);
    expect(boxClass == mesh.classify(box), "hints change no answer");
    expect(boxClass != BoxClass::Inside || value < 0, "a box that is inside is");
    expect(boxClass != BoxClass::Outside || value >= 0, "a box that is outside is");
    T last = 0;
    const auto count = mesh.crossings({p, q}, [&](const Crossing<T>& crossing) {
      expect(last <= crossing.parameter && crossing.parameter <= 1, "crossings are in order");
      last = crossing.parameter;
      return true;
    });
    const bool changes = (value < 0) != (mesh.signedDistance(q) < 0);
    expect((count.found % 2 == 1) == changes, "an odd number of crossings changes the side");
    mesh.facetsIn(box, [](const SurfaceFacet<T>&) { return true; });
  }
}

}  // namespace cutwater::test
