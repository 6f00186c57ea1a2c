// An MPI program of somebody else's: a distributed mesh, on as many ranks as it is started on.
#include <Cutwater/P4est/DistributedVtu.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cstdio>

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int status = 1;
  {
    const cutwater::OctreeDomain<double> domain({0, 0, 0}, 0.5, {4, 4, 4});
    const cutwater::Sphere<double> ball({1, 1, 1}, 0.7);
    const cutwater::DistributedOctree<double> mesh(ball, domain, {.cut = 3}, MPI_COMM_WORLD);
    const cutwater::Octree<double> alone(ball, domain, {.cut = 3});
    status = mesh.checksum({}) == checksum<double>(alone, {}) ? 0 : 1;
    std::printf("%llu cells\n", static_cast<unsigned long long>(mesh.cellCount()));
  }
  MPI_Finalize();
  return status;
}
