// An octree mesh around a ship's hull in one process, and what is known of it. See README.md.
#include <Cutwater/Grid/OctreeFill.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>
#include <Cutwater/Io/VtkFiles.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace cutwater;

int main(int argc, char** argv) {
  // A surface of yours; or, without one, a round hull of triangles.
  const auto soup = argc > 1 ? readSurface(argv[1]).soup : tessellation::capsule(0.4, 3, 64, 24);
  const MeshSDF<double> hull(soup);

  // Cubes around it, and half its length of room on each side.
  const auto box = hull.boundingBox();
  const double length = maxComponent(box.size());
  const double width = length / 8;
  const auto cubes = [&](double size) { return static_cast<std::int32_t>(size / width) + 9; };
  const auto size = box.size();
  const Index3 roots{cubes(size.x), cubes(size.y), cubes(size.z)};
  const Vec3<double> half{roots.i * width / 2, roots.j * width / 2, roots.k * width / 2};
  const OctreeDomain<double> domain(box.center() - half, width, roots);

  // Four levels more at the surface, two within a tenth of its length; edges one level finer.
  const Refinement<double> rules{.cut = 4,
                                 .bands = {{.distance = length / 10, .level = 2}},
                                 .edges = Refinement<double>::Angle{.degrees = 30, .level = 5}};
  const Octree<double> mesh(hull, domain, rules);

  std::vector<double> distance(mesh.cells().size());
  fill(hull, mesh, {.distance = distance});
  const VtkArray array{"distance", std::span<const double>(distance)};
  if (argc > 2) writeVtu(argv[2], mesh, std::span(&array, 1));

  const auto volume = solidVolume(mesh);
  const auto lost = unresolvedFeatures(hull, mesh);
  const FluidRegions<double> fluid(mesh);
  std::printf("%zu cells, %zu of them cut; the solid's volume is within %.6g and %.6g\n",
              mesh.cells().size(), mesh.count(BoxClass::Cut), volume.lower, volume.upper);
  std::printf("regions of fluid: %zu; in %zu cells corners do not tell all\n",
              fluid.regions().size(), lost.size());

  // No cell that is called inside or outside is cut: its centre is farther than the surface.
  for (std::size_t n = 0; n < mesh.cells().size(); ++n) {
    const auto kind = mesh.cells()[n].kind;
    if (kind == BoxClass::Inside && !(distance[n] < 0)) return 1;
    if (kind == BoxClass::Outside && !(distance[n] > 0)) return 1;
  }
  return volume.lower < volume.upper ? 0 : 1;
}
