#include "Report/FluidMeshTotals.hpp"

#include <Cutwater/Text/Numbers.hpp>

#include <cmath>
#include <vector>

#include "Report/Format.hpp"
#include "Report/Json.hpp"

namespace cutwater::tool {

namespace {

std::string kindOf(const FluidMesh::Patch& patch) {
  switch (patch.kind) {
    case FluidMesh::PatchKind::Wall:
      return "wall";
    case FluidMesh::PatchKind::Open:
      return "open";
    default:
      return "side";
  }
}

/// What is not as it should be; empty, if all is.
std::vector<std::string> complaints(const FluidMeshReport& found) {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* things, const char* which) {
    if (count > 0) parts.push_back(grouped(count, things) + ' ' + which);
  };
  add(found.openCells, "cell", "open along an edge");
  add(found.repeatedCorners, "face", "with a repeated corner");
  add(found.disordered, "face", "out of order");
  add(found.flatFaces, "face", "of no area");
  add(found.fewFaces, "cell", "of fewer than four faces");
  add(found.invertedCells, "cell", "of no volume");
  add(found.invertedFaces, "face", "seen from behind");
  add(found.skewFaces, "face", "of skewness above 4");
  add(found.nonOrthogonalFaces, "face", "above 70 degrees of non-orthogonality");
  return parts;
}

}  // namespace

std::string FluidMeshTotals::json(const std::string& input, double seconds) const {
  auto patches = Json::array();
  for (const auto& patch : mesh.patches) {
    patches.push(Json{{"name", patch.name}, {"kind", kindOf(patch)}, {"faces", patch.faceCount}});
  }
  return Json{{"input", input},
              {"cells", mesh.cells.leaf.size()},
              {"faces", mesh.faces.count()},
              {"points", mesh.points.size()},
              {"patches", patches},
              {"regions", mesh.regions},
              {"lostRegions", mesh.lostRegions},
              {"lostVolume", mesh.lostVolume},
              {"joinedPieces", mesh.joinedPieces},
              {"fluidVolume", found.fluidVolume},
              {"meshVolume", found.meshVolume},
              {"worstClosure", found.worstClosure},
              {"openCells", found.openCells},
              {"repeatedCorners", found.repeatedCorners},
              {"disorderedFaces", found.disordered},
              {"flatFaces", found.flatFaces},
              {"fewFaces", found.fewFaces},
              {"invertedCells", found.invertedCells},
              {"invertedFaces", found.invertedFaces},
              {"skewFaces", found.skewFaces},
              {"worstSkewness", found.worstSkewness},
              {"nonOrthogonalFaces", found.nonOrthogonalFaces},
              {"worstNonOrthogonality", found.worstNonOrthogonality},
              {"meanNonOrthogonality", found.meanNonOrthogonality},
              {"worstAspectRatio", found.worstAspectRatio},
              {"seconds", seconds}}
      .text();
}

std::string FluidMeshTotals::text() const {
  std::vector<std::string> patches;
  for (const auto& patch : mesh.patches) {
    patches.push_back(onOneLine(patch.name) + " (" + kindOf(patch) + ", " +
                      grouped(std::size_t{patch.faceCount}, "face") + ")");
  }
  auto lines = "patches: " + text::listed(patches) + "\n";
  const double off = found.meshVolume - found.fluidVolume;
  lines += "fluid " + number(found.fluidVolume, 6) + " in " +
           grouped(mesh.regions.size(), "region") + "; its polyhedra are off by " +
           number(std::abs(off) / found.fluidVolume, 2) + " of it\n";
  if (mesh.lostRegions > 0) {
    lines += "left out: " + grouped(mesh.lostRegions, "closed region") + " of " +
             number(mesh.lostVolume, 3) + "\n";
  }
  if (mesh.joinedPieces > 0) {
    lines += "small pieces joined to a neighbour: " + grouped(mesh.joinedPieces) + "\n";
  }
  lines += "skewness up to " + number(found.worstSkewness, 3) + ", non-orthogonality up to " +
           number(found.worstNonOrthogonality, 3) + " degrees (mean " +
           number(found.meanNonOrthogonality, 3) + "), aspect ratio up to " +
           number(found.worstAspectRatio, 3) + "\n";
  const auto bad = complaints(found);
  if (!bad.empty()) lines += "checkMesh is going to tell of " + text::listed(bad) + "\n";
  return lines;
}

}  // namespace cutwater::tool
