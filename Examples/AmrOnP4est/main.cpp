// An octree mesh around a ship's hull on the ranks of an MPI program. See README.md.
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/DistributedVtu.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <cstdio>
#include <mpi.h>
#include <vector>

using namespace cutwater;

namespace {

/// A surface of yours; or, without one, a round hull of triangles. Called on rank 0 only.
MeshSDF<double> readHull(const char* file) {
  if (file == nullptr) return MeshSDF<double>(tessellation::capsule(0.4, 3, 64, 24));
  return MeshSDF<double>(readSurface(file).soup);
}

/// Cubes around it, and half its length of room on each side.
OctreeDomain<double> cubesAround(const Box<double>& box) {
  const auto size = box.size();
  const double width = maxComponent(size) / 8;
  const auto along = [&](double length) { return static_cast<std::int32_t>(length / width) + 9; };
  const Index3 roots{along(size.x), along(size.y), along(size.z)};
  const Vec3<double> half{roots.i * width / 2, roots.j * width / 2, roots.k * width / 2};
  return {box.center() - half, width, roots};
}

int run(const char* file, const char* output) {
  const MPI_Comm comm = MPI_COMM_WORLD;
  const SharedGeometry<double> shared(comm, [&] { return readHull(file); });
  const auto& hull = shared.mesh();

  const auto domain = cubesAround(hull.boundingBox());
  const double length = maxComponent(hull.boundingBox().size());
  const Refinement<double> rules{.cut = 3, .bands = {{.distance = length / 10, .level = 2}}};
  const DistributedOctree<double> mesh(hull, domain, rules, comm, {.cutWeight = 4});

  // This rank's cells, as those of an Octree.
  std::vector<double> distance(mesh.local().cells().size());
  fill(hull, mesh.local(), {.distance = distance});
  const VtkArray array{"distance", std::span<const double>(distance)};
  if (output != nullptr) writePvtu(output, mesh, std::span(&array, 1));

  const auto sum = mesh.checksum({.distance = distance});
  const auto forest = mesh.forestChecksum();
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  if (rank != 0) return 0;
  const Octree<double> same(hull, domain, rules);
  std::vector<double> distances(same.cells().size());
  fill(hull, same, {.distance = distances});
  const auto expected = checksum(same, {.distance = distances});
  std::printf(
      "%llu cells; p8est's checksum %08x; of cells and values %016llx, in one process %016llx\n",
      static_cast<unsigned long long>(mesh.cellCount()), forest,
      static_cast<unsigned long long>(sum), static_cast<unsigned long long>(expected));
  return sum == expected ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int status = 1;
  try {
    status = run(argc > 1 ? argv[1] : nullptr, argc > 2 ? argv[2] : nullptr);
  } catch (const Error& error) {  // the same on all ranks
    std::fprintf(stderr, "%s\n", error.what());
  }
  MPI_Finalize();
  return status;
}
