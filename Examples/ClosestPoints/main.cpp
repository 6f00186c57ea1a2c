// Which part of a surface is nearest, where, and how far away: many points at once. See README.md.
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

using namespace cutwater;

namespace {

/// A can in three patches: its polygons are the side's, then the bottom's and the top's.
PolygonSoup can() {
  auto soup = tessellation::cylinder(1, 3, 64);
  soup.patchNames = {"side", "bottom", "top"};
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto z = [&](std::size_t corner) { return soup.points[soup.polygon(i)[corner]].z; };
    if (z(0) == z(1) && z(1) == z(2)) soup.patches[i] = z(0) > 1 ? 2 : 1;
  }
  return soup;
}

}  // namespace

int main(int argc, char** argv) {
  const auto soup = argc > 1 ? readSurface(argv[1]).soup : can();

  // [DOCS
  const MeshSDF<double> mesh(soup);
  const auto box = mesh.boundingBox().grown(0.2 * length(mesh.boundingBox().size()));
  std::mt19937 random(1);
  std::vector<Vec3<double>> points(100000);
  for (auto& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = std::uniform_real_distribution(box.lower[axis], box.upper[axis])(random);
    }
  }
  std::vector<SurfacePoint<double>> nearest(points.size());
  mesh.closestPoints(points, nearest);  // on all cores; each as mesh.closestPoint() has it
  // DOCS]

  const auto names = mesh.patchNames();
  std::vector<std::size_t> counts(names.size());
  bool isRight = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& found = nearest[i];
    ++counts[found.owner.patch];
    // The distance is that to the point, and its sign that of the side on which the normal is.
    const auto away = points[i] - found.point;
    const double off = std::abs(std::abs(found.distance) - length(away));
    isRight = isRight && off <= found.tolerance && dot(away, found.normal) * found.distance >= 0;
  }
  for (std::size_t patch = 0; patch < names.size(); ++patch) {
    std::printf("%-10s is nearest to %5.1f %% of the points\n", names[patch].c_str(),
                100 * double(counts[patch]) / double(points.size()));
  }
  const auto farthest =
      std::max_element(nearest.begin(), nearest.end(),
                       [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const auto& p = points[static_cast<std::size_t>(farthest - nearest.begin())];
  std::printf("farthest outside: (%.3f, %.3f, %.3f), %.3f from \"%s\"\n", p.x, p.y, p.z,
              farthest->distance, names[farthest->owner.patch].c_str());
  return isRight ? 0 : 1;
}
