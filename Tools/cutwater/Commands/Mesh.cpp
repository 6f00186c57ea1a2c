#include <Cutwater/Io/PolyMesh.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "Commands/Commands.hpp"
#include "Options/Arguments.hpp"
#include "Options/CutOctree.hpp"
#include "Options/CuttingOptions.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/OutputFile.hpp"
#include "Report/FluidMeshTotals.hpp"
#include "Report/Format.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/ProgressBar.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct MeshSettings {
  std::string caseFolder;
  SurfaceOptions surface;
  std::string json;
  MeshOptions octree;
  CuttingOptions cutting;
  FluidMeshOptions fluid;
  PolyMeshOptions file;
};

constexpr double kBytesOfLeaf = 700;  // of a mesh of mostly whole leaves, as measured

Octree<double> octreeOf(const MeshSettings& options, const Solid<double>& solid,
                        const Cutter& cutter) {
  const PlacedSurface placed(solid, options.octree.roots.box.value_or(boxAround(solid)),
                             options.cutting.cutter);
  return octreeToCut({.mesh = options.octree,
                      .polygons = true,
                      .bytesPerLeaf = kBytesOfLeaf,
                      .threads = options.surface.threads,
                      .quiet = options.surface.quiet},
                     solid, cutter.trial(solid, options.cutting), placed);
}

CutLeaves cut(const MeshSettings& options, const Cutter& cutter, const Octree<double>& octree) {
  ProgressBar bar("cutting", !options.surface.quiet);
  return cutter.cut(
      octree, {.polygons = true, .threads = options.surface.threads, .progress = bar.callback()});
}

void makeMesh(const MeshSettings& options, const Solid<double>& solid) {
  Stopwatch watch;
  const Cutter cutter(solid, options.cutting);
  const auto octree = octreeOf(options, solid, cutter);
  const auto mesh = fluidMesh(cut(options, cutter, octree), octree, options.fluid);
  writePolyMesh(options.caseFolder, mesh, options.file);
  const double seconds = watch.lap();
  if (options.json.empty() && options.surface.quiet) return;
  const FluidMeshTotals totals(mesh, options.surface.threads);
  if (!options.json.empty()) {
    writeText(options.json, totals.json(options.surface.file, seconds));
  }
  if (options.surface.quiet) return;
  std::cout << "made " << grouped(mesh.cells.leaf.size(), "cell") << " with "
            << grouped(mesh.faces.count(), "face") << " of " << grouped(octree.cells().size())
            << " leaves, the finest of "
            << extent(octree.domain().level(octree.deepest()).spacing()) << ", in "
            << duration(seconds) << '\n'
            << totals.text() << "wrote constant/polyMesh in " << onOneLine(options.caseFolder)
            << '\n';
}

void run(MeshSettings& options) {
  refuseOnOctrees(options.cutting);
  const std::filesystem::path folder(options.caseFolder);
  requireFolder((folder.has_filename() ? folder : folder.parent_path()).string());
  options.fluid.threads = options.surface.threads;
  const auto solid = loadSolid(options.surface);
  namingMemory("out of memory; use a lower --level", [&] { makeMesh(options, solid); });
}

}  // namespace

void addMesh(Program& program) {
  const auto options = std::make_shared<MeshSettings>();
  auto command = program.addCommand(
      "mesh", "Make an OpenFOAM mesh of the fluid: the leaves of an octree, cut by the surface");
  command
      .addText("CASE", "The folder of the case, for constant/polyMesh; made if it is not there",
               options->caseFolder)
      .required();
  addSurfaceOptions(command, options->surface, Reads::SurfacesAndScenes);
  addSignOptions(command, options->surface);
  addOutput(command, "--json", options->json, {".json"}, "Write the totals in JSON, for programs");
  addRefinementOptions(command, options->octree.refinement).required();
  addRoots(command, options->octree);
  addPlaceOptions(command, options->octree.roots);
  addBalance(command, options->octree);
  addLimits(command, "--max-cells", options->octree.limits);
  addCuttingOptions(command, options->cutting);
  auto& fluid = options->fluid;
  command.addFlag("--wall-triangles",
                  "Every triangle is a wall face of each cell it meets, so that volumes are exact; "
                  "else a cell has one wall face a patch where it can",
                  fluid.wallPolygons);
  command.addNumber("--smallest", "SHARE",
                    "Join pieces of less than this share of their leaf to a neighbour [default: "
                    "0.1]",
                    fluid.smallest, Range<double>{0, 1});
  command.addFlag("--cavities",
                  "Keep closed regions of fluid as well, as cellZones; else those that lead out "
                  "are kept, or the largest if none does",
                  [&fluid] { fluid.cavities = Cavities::Kept; });
  command.add("--within", "X,Y,Z", "Keep only the region of fluid around this point",
              [&fluid](const std::string& text) { fluid.within = vectorOf("--within", text); });
  command.addFlag("--binary", "Write numbers as they lie in memory, not as text",
                  options->file.binary);
  command.setFooter(
      "Walls are patches of type wall with the names of the surface's, sides of the domain are "
      "xMin, xMax, ... With a --band of the finest level around the surface, cells have better "
      "shapes.\n"
      "\n"
      "Examples:\n"
      "  cutwater mesh case/ hull.stl --level 5 --band 0.03:5 --margin 3\n"
      "  cutwater mesh case/ flange.stl --inside --level 3 --edges 30:4 --binary\n"
      "  cutwater mesh case/ pipe.obj --inside --open inlet --open outlet --box 0,0,0,2,1,1 "
      "--level 3");
  command.setAction([=] {
    passOn(options->cutting, options->octree.roots, options->surface);
    run(*options);
  });
}

}  // namespace cutwater::tool
