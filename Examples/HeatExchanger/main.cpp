// A gyroid heat exchanger: two fluids cross each other, each in a channel of its own. See
// README.md.
#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Grid/OctreeRegions.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Io/Png.hpp>
#include <Cutwater/Mesh/DcelMesh.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>
#include <Cutwater/Mesh/WriteSurface.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Render/Render.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Tpms/TwoFluids.hpp>

#include <cstdio>
#include <filesystem>
#include <string>

using namespace cutwater;

namespace {

constexpr Box<double> kBlock{{0, 0, 0}, {40, 40, 30}};  // mm
constexpr double kCell = 10;

/// Whether cubes that are certainly in the fluid lead across their faces from one end of the block
/// to the other.
bool isPassable(const Solid<double>& fluid, int axis) {
  constexpr int kLevel = 4;
  const OctreeDomain<double> domain(kBlock.lower, kCell, {4, 4, 3});
  const Octree<double> mesh(~fluid, domain, {.cut = kLevel});
  const FluidRegions<double> regions(mesh);
  // Cubes at the very ends are cut there.
  const double smallest = kCell / (1 << kLevel);
  bool begins = false;
  bool ends = false;
  for (std::size_t i = 0; i < mesh.cells().size(); ++i) {
    const auto& cube = mesh.cells()[i];
    if (cube.kind != BoxClass::Outside || regions.regionOf(i) != 0) continue;
    const auto box = mesh.box(cube);
    begins = begins || box.lower[axis] <= kBlock.lower[axis] + smallest;
    ends = ends || box.upper[axis] >= kBlock.upper[axis] - smallest;
  }
  return begins && ends;
}

/// Whether it is certain that no point is within this distance of both fluids.
bool areApart(const TwoFluids<double>& parts, double distance) {
  const auto nearBoth = offset(parts.a, distance) & offset(parts.b, distance);
  return solidVolume(nearBoth, kBlock, {.fraction = 1e-9}).volume.upper == 0;
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
  const auto certain = solidVolume(part, kBlock, {.fraction = 0.03}).volume;
  const auto mesh = isosurface<double>(part, nodesAround(kBlock, 0.5), {.featureAngle = 40});
  const auto found = check(DcelMesh<double>(mesh));
  std::printf("%-7s certainly %5.0f to %5.0f mm^3, meshed %5.0f mm^3; ", name.c_str(),
              certain.lower, certain.upper, found.volume);
  if (name != "wall") std::printf("wets %.0f mm^2; ", wettedArea(mesh));
  std::printf("%s\n", found.summary().c_str());
  if (!folder.empty()) writeSurface(std::filesystem::path(folder) / (name + ".stl"), mesh);
  return found.isClean() && found.components == 1 && certain.contains(found.volume);
}

void paste(const Image& part, Image& sheet, int x0, int y0) {
  for (int y = 0; y < part.height(); ++y) {
    for (int x = 0; x < part.width(); ++x) sheet.at(x0 + x, y0 + y) = part.at(x, y);
  }
}

/// The solid cut open, beside both fluids, and one of them alone.
Image picture(const TwoFluids<double>& parts, int width) {
  Image sheet(width, width * 5 / 8);
  const auto show = [&](const Solid<double>& solid, const char* title, int size) {
    RenderOptions options;
    options.view = View::fromAngles(-52, 27);
    options.width = options.height = size;
    options.title = title;
    options.unit = "mm";
    options.axes = options.legend = size > sheet.height() / 2;
    return render(solid, options);
  };
  const Cuboid<double> quarter({20, -1, 15}, {41, 20, 31});
  paste(show(named(parts.wall, "solid") - named(quarter, "cut"), "A gyroid heat exchanger",
             sheet.height()),
        sheet, 0, 0);
  const int half = sheet.height() / 2;
  const auto a = named(parts.a, "A");
  const auto b = named(parts.b, "B");
  paste(show(a | b, "Both fluids", half), sheet, sheet.height(), 0);
  paste(show(a, "Fluid A alone", half), sheet, sheet.height(), half);
  return sheet;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "";
  // [DOCS
  // The wall |F| < 0.35 of a gyroid of 10 mm cells, in a block: A flows along x, B along y.
  auto sides = TpmsChannels<double>::of({TpmsPattern::gyroid(), kCell}, 0.35);
  sides = {named(sides.a, "side of A"), named(sides.b, "side of B")};
  const auto parts =
      twoFluidsIn<double>(kBlock, sides, {.axisOfA = 0, .axisOfB = 1, .capThickness = 0.8});
  // DOCS]
  bool isRight = report("wall", parts.wall, folder);
  isRight = report("fluid-a", parts.a, folder) && isRight;
  isRight = report("fluid-b", parts.b, folder) && isRight;
  const bool isOpen = isPassable(parts.a, 0) && isPassable(parts.b, 1);
  const bool isApart = areApart(parts, 0.2);
  std::printf("both lead from end to end: %s; nowhere nearer to each other than 0.4 mm: %s\n",
              isOpen ? "yes" : "no", isApart ? "yes" : "no");
  if (!folder.empty()) {
    const int width = argc > 2 ? std::stoi(argv[2]) : 1600;
    writePng(std::filesystem::path(folder) / "heat-exchanger.png", picture(parts, width));
  }
  return isRight && isOpen && isApart ? 0 : 1;
}
