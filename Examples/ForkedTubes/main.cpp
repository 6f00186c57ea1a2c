// A tube that forks again and again, open at its ends, drawn cut in half. See README.md.
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace cutwater;

namespace {

/// What tubes are made of: their outsides less their bores, and these alone are the fluid.
struct Tubes {
  BeamGraph outsides;
  BeamGraph bores;
};

void addBeam(BeamGraph& graph, const Vec3<double>& a, const Vec3<double>& b, BeamGraph::Beam beam) {
  const auto first = static_cast<std::uint32_t>(graph.nodes.size());
  graph.nodes.insert(graph.nodes.end(), {a, b});
  beam.nodes = {first, first + 1};
  graph.beams.push_back(beam);
}

/// From a, along a unit vector, and on from there in two tubes, until so many generations are
/// there.
void grow(Tubes& tubes, const Vec3<double>& a, const Vec3<double>& along, const Vec3<double>& side,
          double bore, int generations) {
  // [DOCS
  const auto b = a + 6 * bore * along;
  const bool isFirst = tubes.bores.beams.empty();
  const bool isLast = generations == 1;
  // Outsides end flat where they are open, and bores reach beyond.
  addBeam(tubes.outsides, a, b,
          {.nodes = {},
           .radii = {1.25 * bore, 1.25 * bore},
           .body = BeamBody::Frustum,
           .caps = {isFirst ? BeamCap::Butt : BeamCap::Sphere,
                    isLast ? BeamCap::Butt : BeamCap::Sphere}});
  addBeam(tubes.bores, isFirst ? a - bore * along : a, isLast ? b + bore * along : b,
          {.nodes = {}, .radii = {bore, bore}});
  if (isLast) return;
  // Murray (1926): the cubes of the branches' radii add up to that of their stem.
  const double thinner = bore / std::cbrt(2.0);
  for (const double turn : {-0.65, 0.65}) {
    const auto branch = std::cos(turn) * along + std::sin(turn) * side;
    grow(tubes, b, branch, cross(along, side), thinner, generations - 1);
  }
  // DOCS]
}

}  // namespace

int main(int argc, char** argv) {
  const int generations = argc > 2 ? std::atoi(argv[2]) : 6;
  Tubes tubes;
  grow(tubes, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1, generations);
  const BeamLattice<double> outsides(tubes.outsides);
  const BeamLattice<double> bores(tubes.bores);
  const auto walls = outsides - named(bores, "bore");

  // The fluid between the flat ends.
  const auto fluid =
      solidVolume(outsides & bores, outsides.boundingBox(), {.fraction = 0, .relative = 0.3});
  std::printf("%zu tubes; they hold about %.1f of fluid, certainly %.1f to %.1f\n",
              tubes.bores.beams.size(), fluid.estimate, fluid.volume.lower, fluid.volume.upper);
  if (argc > 1) {
    RenderOptions options;
    options.view = View::fromAngles(-70, 18);
    options.cuts = {CutPlane::through({0, 0, 0}, {0, -1, 0})};
    options.title = "Tubes that fork";
    writePng(argv[1], render(named(outsides, "wall") - named(bores, "bore"), options));
  }
  // The first tube is open at its end, closed at its side, and all bores are one.
  const bool isOpen = walls.signedDistance({0, 0, 0}) > 0 && walls.signedDistance({1.1, 0, 3}) < 0;
  return isOpen && fluid.isWithinTolerance ? 0 : 1;
}
