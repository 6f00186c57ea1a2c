// A sandwich pipe: two walls along a curve, with a lattice between them. See README.md.
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Plane.hpp>

#include <cstdio>
#include <cstdlib>

using namespace cutwater;

namespace {

/// All points within a radius of the spine and, beyond its ends, of what goes on straight there.
Solid<double> tube(const Spine& spine, double radius) {
  constexpr std::uint32_t kBeams = 60;
  BeamGraph graph;
  for (std::uint32_t i = 0; i <= kBeams; ++i) {
    graph.nodes.push_back(spine.frameAt(spine.length() * (1.2 * i / kBeams - 0.1)).point);
    if (i > 0) graph.beams.push_back({{i - 1, i}, {radius, radius}});
  }
  return named(BeamLattice<double>(graph), "walls");
}

/// All that lies between the planes through the ends of the spine.
Solid<double> betweenEnds(const Spine& spine) {
  const auto begin = spine.frameAt(0);
  const auto end = spine.frameAt(spine.length());
  return named(Plane<double>(begin.point, -begin.tangent), "ends") &
         named(Plane<double>(end.point, end.tangent), "ends");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Vec3<double>> points{{0, 0, 0}, {0, 0, 50}, {35, 0, 85}, {85, 0, 85}};
  const Spine spine(points, {0, 1, 0});
  const PipeMapping pipe({.innerRadius = 11, .outerRadius = 19, .length = spine.length()});
  const HexahedralCells cells({1, 16, 18}, AlongSpine(spine, pipe));
  const auto graph = beamsOf(UnitCell::octet(), cells, 0.6);
  const BeamLattice<double> lattice(graph);

  // Between the outermost and the innermost tube all but the hollow is solid, and in that the
  // lattice.
  const auto hollow = tube(spine, 19) - tube(spine, 11);
  const auto body = (named(lattice, "lattice") | ~hollow) & tube(spine, 20) - tube(spine, 10) &
                    betweenEnds(spine);

  RenderOptions options;
  options.view = View::fromAngles(-60, 20);
  options.cuts = {CutPlane::through({0, 0, 0}, {0, -1, 0})};
  options.width = argc > 2 ? std::atoi(argv[2]) : 1200;
  options.height = options.width * 5 / 8;
  options.title = "Sandwich pipe with a conformal lattice";
  options.unit = "mm";
  const Image picture = render(body, options);
  if (argc > 1) writePng(argv[1], picture);

  std::size_t drawn = 0;
  for (const auto& pixel : picture.pixels()) drawn += pixel == Rgb{255, 255, 255} ? 0 : 1;
  std::printf("%.1f mm of pipe, %zu nodes, %zu beams\n", spine.length(), graph.nodes.size(),
              graph.beams.size());
  return drawn > picture.pixels().size() / 10 ? 0 : 1;
}
