// A solid made of formulas becomes a closed mesh, to print or to mesh around. See README.md.
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/RoundedBox.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace cutwater;

namespace {

/// The farthest that a middle of a triangle or of an edge is from the solid's surface.
double farthest(const Solid<double>& solid, const PolygonSoup& mesh) {
  std::vector<Vec3<double>> middles;
  for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
    const auto corners = mesh.polygon(i);
    const auto& a = mesh.points[corners[0]];
    const auto& b = mesh.points[corners[1]];
    const auto& c = mesh.points[corners[2]];
    middles.insert(middles.end(), {(1.0 / 3) * (a + b + c), 0.5 * (a + b), 0.5 * (b + c)});
  }
  std::vector<SurfacePoint<double>> nearest(middles.size());
  solid.closestPoints(middles, nearest);
  double result = 0;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    result = std::max(result, length(nearest[i].point - middles[i]));
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  // [DOCS
  // A bearing block: foot and housing flow into each other, with holes for the shaft and two bolts.
  const RoundedBox<double> foot({-3, -1.2, 0}, {3, 1.2, 0.6}, 0.15);
  const Cylinder<double> housing({0, -1, 1.8}, {0, 1, 1.8}, 1.3);
  const auto body = smoothUnion(foot, housing, {.reach = 0.8});
  const Cylinder<double> shaft({0, -2, 1.8}, {0, 2, 1.8}, 0.8);
  const Cylinder<double> bolt({2.3, 0, -1}, {2.3, 0, 2}, 0.35);
  const auto block = body - shaft - bolt - mirrored(bolt, {1, 0, 0});

  const double spacing = 0.04;
  const auto mesh =
      isosurface<double>(block, nodesAround(block.boundingBox(), spacing), {.featureAngle = 30});
  if (argc > 1) writeSurface(argv[1], mesh);
  // DOCS]

  const MeshSDF<double> printed(mesh);
  const auto certain = solidVolume(block, block.boundingBox(), {.fraction = 0.02});
  const double volume = measure(mesh).volume;
  const double distance = farthest(block, mesh);
  std::printf("%zu triangles, closed: %s; at most %.3f cells from the solid's surface\n",
              mesh.polygonCount(), printed.signReport().isClosed() ? "yes" : "no",
              distance / spacing);
  std::printf("volume %.3f, certainly %.3f to %.3f\n", volume, certain.volume.lower,
              certain.volume.upper);
  if (argc > 2) {
    RenderOptions options;
    options.view = View::fromAngles(-60, 25);
    options.title = "A bearing block, meshed";
    writePng(argv[2], render(printed, options));
  }
  const bool isRight = printed.signReport().isClosed() && distance < 0.1 * spacing &&
                       certain.volume.contains(volume);
  return isRight ? 0 : 1;
}
