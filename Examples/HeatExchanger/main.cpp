// A gyroid heat exchanger: two fluids cross each other, each in a channel of its own. See
// README.md.
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/PatchColors.hpp>
#include <Cutwater/Render/Png.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace cutwater;

namespace {

constexpr double kCell = 10;  // mm

/// So many cells along x and y, and three quarters of that along z.
Box<double> blockOf(int cells) {
  const double side = kCell * cells;
  return {{0, 0, 0}, {side, side, 0.75 * side}};
}

/// In cubes of a quarter of a cell, and smaller ones where the surface may be.
Octree<double> cubesAround(const Solid<double>& solid, int cells, int level) {
  const OctreeDomain<double> domain({0, 0, 0}, kCell / 4, {4 * cells, 4 * cells, 3 * cells});
  return Octree<double>(solid, domain, Refinement<double>{.cut = level});
}

/// Whether cubes that are certainly in the fluid lead across their faces from one end of the block
/// to the other.
bool isPassable(const Solid<double>& fluid, int cells, int axis) {
  constexpr int kLevel = 2;
  const auto mesh = cubesAround(~fluid, cells, kLevel);
  const FluidRegions<double> regions(mesh);
  // Cubes at the very ends are cut there.
  const double smallest = kCell / 4 / (1 << kLevel);
  const auto block = mesh.domain().box();
  bool begins = false;
  bool ends = false;
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    const auto& cube = mesh.cells()[i];
    if (cube.kind != BoxClass::Outside || regions.regionOf(i) != 0) continue;
    const auto box = mesh.box(cube);
    begins = begins || box.lower[axis] <= block.lower[axis] + smallest;
    ends = ends || box.upper[axis] >= block.upper[axis] - smallest;
  }
  return begins && ends;
}

/// Whether it is certain that no point is within this distance of both fluids.
bool areApart(const TwoFluids<double>& parts, int cells, double distance) {
  const auto nearBoth = offset(parts.a, distance) & offset(parts.b, distance);
  const auto mesh = cubesAround(nearBoth, cells, 5);
  return mesh.count(BoxClass::Outside) == mesh.cells().size();
}

/// Without where the fluid comes in and goes out: these triangles are on the block's own sides.
double wettedArea(const PolygonSoup& fluid) {
  constexpr std::uint32_t kOfBlock = 0;
  double area = 0;
  for (std::size_t i = 0; i < fluid.polygonCount(); ++i) {
    if (fluid.patches[i] == kOfBlock) continue;
    const auto corners = fluid.polygon(i);
    const auto& first = fluid.points[corners[0]];
    area += 0.5 * length(cross(fluid.points[corners[1]] - first, fluid.points[corners[2]] - first));
  }
  return area;
}

/// Tells of a part, and writes its surface to the folder, if there is one. False if its mesh is not
/// as it should be.
bool report(const std::string& name, const Solid<double>& part, const std::string& folder) {
  const auto block = part.boundingBox();
  const auto bounds = solidVolume(part, block, {.fraction = 0.2});
  const auto mesh = isosurface<double>(part, nodesAround(block, 0.4), {.featureAngle = 40});
  const auto found = check(DcelMesh<double>(mesh));
  std::printf("%s: certainly %.0f to %.0f mm^3, about %.0f, meshed %.0f; ", name.c_str(),
              bounds.volume.lower, bounds.volume.upper, bounds.estimate, found.volume);
  if (name != "wall") std::printf("wets %.0f mm^2; ", wettedArea(mesh));
  std::printf("%s\n", found.summary().c_str());
  if (!folder.empty()) writeSurface(std::filesystem::path(folder) / (name + ".stl"), mesh);
  return found.isClean() && found.components == 1 && bounds.volume.contains(found.volume);
}

void paste(const Image& part, Image& sheet, int x0, int y0) {
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) sheet.at(x0 + x, y0 + y) = part.at(x, y);
  }
}

Image shown(const Solid<double>& solid, const std::string& title, int size,
            std::optional<Rgb> color = {}) {
  RenderOptions options;
  options.view = View::fromAngles(-52, 27);
  options.color = color;
  options.width = options.height = size;
  options.title = title;
  options.unit = "mm";
  return render(solid, options);
}

/// The solid cut open, beside the fluids in the colours of their sides, patches 1 and 3.
Image picture(const TwoFluids<double>& parts, const Box<double>& block, int width) {
  Image sheet(width, width * 2 / 3);
  const int large = sheet.height();
  const int small = large / 2;
  const auto middle = 0.5 * (block.lower + block.upper);
  const Cuboid<double> quarter({middle.x, -1, middle.z},
                               {block.upper.x + 1, middle.y, block.upper.z + 1});
  paste(shown(parts.wall - named(quarter, "cut"), "A gyroid heat exchanger", large), sheet, 0, 0);
  paste(shown(parts.a, "Fluid A, along x", small, patchColor(1)), sheet, large, 0);
  paste(shown(parts.b, "Fluid B, along y", small, patchColor(3)), sheet, large, small);
  return sheet;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "";
  const int width = std::max(argc > 2 ? std::stoi(argv[2]) : 1600, 480);  // three pictures
  const int cells = argc > 3 ? std::stoi(argv[3]) : 2;
  const auto block = blockOf(cells);
  // [DOCS
  // The wall |F| < 0.35 of a gyroid of 10 mm cells, in a block: A flows along x, B along y.
  auto sides = TpmsChannels<double>::of({TpmsPattern::gyroid(), kCell}, 0.35);
  sides = {named(sides.a, "side of A"), named(sides.b, "side of B")};
  const auto parts =
      twoFluidsIn<double>(block, sides, {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.5});
  // DOCS]
  bool isRight = report("wall", parts.wall, folder);
  isRight = report("fluid-a", parts.a, folder) && isRight;
  isRight = report("fluid-b", parts.b, folder) && isRight;
  const bool isOpen = isPassable(parts.a, cells, 0) && isPassable(parts.b, cells, 1);
  const bool isApart = areApart(parts, cells, 0.2);
  std::printf("both lead from end to end: %s; nowhere nearer to each other than 0.4 mm: %s\n",
              isOpen ? "yes" : "no", isApart ? "yes" : "no");
  if (!folder.empty()) {
    writePng(std::filesystem::path(folder) / "heat-exchanger.png", picture(parts, block, width));
  }
  return isRight && isOpen && isApart ? 0 : 1;
}
