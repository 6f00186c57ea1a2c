// A surface from a file, its signed distance, and a picture of it cut open. See README.md.

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Sdf/Solid.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include <cstdio>
#include <string>

using namespace cutwater;

int main(int argc, char** argv) {
  const std::string path = argc > 2 ? argv[2] : "ring.off";
  if (argc < 3) writeSurface(path, tessellation::torus(3, 1, 96, 48));

  // [DOCS
  const SurfaceFile file = readSurface(path);  // STL, OBJ, PLY, OFF or VTK, also compressed
  const MeshSDF<double> mesh(file.soup);       // its tree, and how its signs are decided
  const Solid<double> solid = mesh;            // a value: to be moved, combined, handed on

  const Box<double> box = solid.boundingBox();
  const double distance = solid.signedDistance(box.center());  // negative would be inside
  const SurfacePoint<double> nearest = solid.closestPoint(box.center());
  const BoxClass whole = solid.classify(box);  // Cut: it touches the surface

  RenderOptions options;
  options.cuts = {CutPlane::through(box.center(), {1, -1, 0})};
  const Image picture = render(solid, options);
  // DOCS]
  if (argc > 1) writePng(argv[1], picture);

  const auto& p = nearest.point;
  std::printf("%zu triangles, closed: %s\n", mesh.triangleCount(),
              mesh.signReport().isClosed() ? "yes" : "no");
  std::printf("from the middle of its box: distance %g, to (%g, %g, %g)\n", distance, p.x, p.y,
              p.z);
  if (argc > 2) return 0;
  // To the ring itself it is 2; the middles of edges are nearer by 2 - 2 cos(pi / 96) = 0.00107.
  const bool right = distance > 1.9989 && distance <= 2 && whole == BoxClass::Cut;
  return right && mesh.signReport().isSound() ? 0 : 1;
}
