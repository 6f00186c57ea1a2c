// Four nodes and the six beams between them, of random sizes. See README.md.
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

using namespace cutwater;

int main(int argc, char** argv) {
  std::mt19937 random(argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 2);
  const auto number = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / 0x1p32;
  };

  // [DOCS
  BeamGraph graph;
  for (const auto& corner : {Vec3{1.0, 1.0, 1.0}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}) {
    graph.nodes.push_back(corner + Vec3{number(-0.5, 0.5), number(-0.5, 0.5), number(-0.5, 0.5)});
  }
  const std::array<double, 4> radii{number(0.05, 0.5), number(0.05, 0.5), number(0.05, 0.5),
                                    number(0.05, 0.5)};
  // Each beam is the convex hull of a ball about either end.
  for (std::uint32_t a = 0; a < 4; ++a) {
    for (std::uint32_t b = a + 1; b < 4; ++b) {
      graph.beams.push_back({.nodes = {a, b}, .radii = {radii[a], radii[b]}});
    }
  }
  const BeamLattice<double> tetrahedron(graph);
  // DOCS]

  // The same by six shapes of their own.
  double largest = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p{number(-2, 2), number(-2, 2), number(-2, 2)};
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [nodes, r, body, caps] : graph.beams) {
      const ConeSphere<double> beam(graph.nodes[nodes[0]], graph.nodes[nodes[1]], r[0], r[1]);
      nearest = std::min(nearest, beam.signedDistance(p));
    }
    largest = std::max(largest, std::abs(tetrahedron.signedDistance(p) - nearest));
  }
  const auto owner = tetrahedron.closestPoint({0, 0, 0}).owner;
  std::printf("the middle is %.6f from beam %u; six shapes differ by %g at most\n",
              tetrahedron.signedDistance({0, 0, 0}), owner.face, largest);

  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-65, 20);
    options.title = "Six beams between four balls";
    writePng(argv[1], render(tetrahedron, options));
  }
  return largest == 0 ? 0 : 1;
}
