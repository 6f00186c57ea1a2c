// A hull with a thin skin, filled by octet trusses, drawn cut open. See README.md.
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <cstdio>

using namespace cutwater;

int main(int argc, char** argv) {
  // A surface of yours; or, without one, a round hull of triangles.
  const auto soup = argc > 2 ? readSurface(argv[2]).soup : tessellation::capsule(0.4, 3, 64, 24);
  // [DOCS
  const MeshSDF<double> hull(soup);
  const auto size = hull.boundingBox().size();
  const double cell = std::min({size.x, size.y, size.z}) / 4;
  const PeriodicLattice<double> octet(UnitCell::octet(), {cell, cell, cell}, 0.05 * cell);

  // A skin from the surface inwards, and the trusses as far as that.
  const double skin = 0.05 * cell;
  const auto light = named(hull - offset(hull, -skin), "skin") | named(hull & octet, "octet");
  // DOCS]

  // How much of space the trusses fill is known from one of their cells.
  const auto filled = solidVolume(octet, {{0, 0, 0}, {cell, cell, cell}}).solidFraction();
  std::printf("cells of %.3g; their struts fill %.4f to %.4f of them\n", cell, filled.lower,
              filled.upper);

  if (argc > 1) {
    // Cut open lengthwise, seen from there; the forward third of it.
    const auto box = hull.boundingBox();
    RenderOptions options;
    options.view = View::fromAngles(-50, 20);
    options.cuts = {CutPlane::across(1, box.center().y, CutPlane::Keep::Upper)};
    options.show = Box<double>{{box.lower.x + 2 * size.x / 3, box.lower.y, box.lower.z}, box.upper};
    options.legend = false;
    options.title = "A hull filled with octet trusses";
    writePng(argv[1], render(light, options));
  }
  return 0 < filled.lower && filled.upper < 0.2 ? 0 : 1;
}
