// A ball filled with a lattice that is dense at its surface and light inside. See README.md.
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <cstdio>
#include <numbers>

using namespace cutwater;

int main(int argc, char** argv) {
  const double radius = 20;
  const Sphere<double> ball({0, 0, 0}, radius);
  const auto thickness =
      Thickness<double>::byDistanceTo(ball, {.start = 1.0, .end = 0.25, .over = 12});
  const PeriodicLattice<double> lattice(UnitCell::octet(), {6, 6, 6}, thickness);
  const Solid<double> infill = ball & lattice;

  // The volume, enclosed by cells that are certainly inside and those not certainly outside.
  const OctreeDomain<double> domain({-21, -21, -21}, 42, {1, 1, 1});
  const Octree<double> mesh(infill, domain, {.cut = 8});
  const auto volume = solidVolume(mesh);
  const double whole = 4.0 / 3 * std::numbers::pi * radius * radius * radius;

  RenderOptions options;
  options.view = View::fromAngles(-60, 25);
  options.cuts = {CutPlane::through({0, 0, 0}, {0, -1, 0})};
  options.width = 960;
  options.height = 600;
  options.title = "Graded octet lattice in a ball";
  options.unit = "mm";
  const Image picture = render(infill, options);
  if (argc > 1) writePng(argv[1], picture);

  std::printf("porosity between %.3f and %.3f\n", 1 - volume.upper / whole,
              1 - volume.lower / whole);
  return volume.lower > 0 && volume.upper < whole ? 0 : 1;
}
