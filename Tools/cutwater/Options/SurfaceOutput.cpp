#include "Options/SurfaceOutput.hpp"

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include "Options/OutputFile.hpp"
#include "Options/SurfaceOptions.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

std::vector<bool> polygonsWithArea(const PolygonSoup& soup) {
  std::vector<bool> result(soup.polygonCount());
  std::vector<Vec3<double>> corners;
  for (std::size_t i = 0; i < result.size(); ++i) {
    corners.clear();
    for (const auto v : soup.polygon(i)) corners.push_back(soup.points[v]);
    result[i] = polygonArea(corners).normal != Vec3<double>{};
  }
  return result;
}

/// Rounds to single precision. Returns a sentence on what does not survive that; none: nothing.
std::string roundedToSingle(const std::string& file, PolygonSoup& soup) {
  weldExactly(soup);
  const auto hadArea = polygonsWithArea(soup);
  for (auto& p : soup.points) {
    const Vec3<double> single(static_cast<Vec3<float>>(p));
    if (!isFinite(single)) {
      throw Error(ErrorKind::Argument, file + ": binary STL has single precision, too little for " +
                                           point(p) + "; .obj and .ply have double precision");
    }
    p = single;
  }
  const std::size_t merged = weldExactly(soup);
  const auto hasArea = polygonsWithArea(soup);
  std::size_t lost = 0;
  for (std::size_t i = 0; i < hasArea.size(); ++i) lost += hadArea[i] && !hasArea[i] ? 1 : 0;
  if (merged == 0 && lost == 0) return {};
  return "warning: single precision made " + grouped(merged, "point") + " equal to others, and " +
         grouped(lost, "face") +
         " lose all area; .obj, .ply and --ascii keep all digits, and near the origin fewer "
         "are lost";
}

/// Why single precision leaves no face, and what keeps them.
std::string whyNothingIsLeft(const std::string& file, const Box<double>& box) {
  const auto middle = box.center();
  const bool isFar = maxComponent(box.size()) < 1e-3 * maxComponent(abs(middle));
  std::string text =
      file +
      ": single precision, which binary STL has, makes points of every face equal, or puts " +
      "them in a line: the surface measures " + extent(box.size());
  if (isFar) text += " at " + point(middle, 3);
  text += "; .obj, .ply and --ascii keep all digits";
  if (!isFar) return text;
  const auto back = -middle;
  return text + ", or move it to the origin: --translate " + number(back.x, 3) + "," +
         number(back.y, 3) + "," + number(back.z, 3);
}

}  // namespace

void addSurfaceOutput(Command command, const std::string& names, std::string& output,
                      WriteOptions& options) {
  std::vector<std::string> extensions;
  for (const auto& format : kReadSurfaceFormats) extensions.emplace_back(format.extension);
  addOutput(command, names, output, extensions,
            "The surface to write; its extension decides the format: " + surfaceExtensions("or") +
                "; only .obj, and .stl with --ascii, keep patches")
      .required();
  command.addFlag("--ascii", "Text where the format has both (STL, PLY, VTK)", options.ascii);
}

SurfaceOutput asWritten(const std::string& file, PolygonSoup soup, const WriteOptions& options) {
  const auto extension = extensionOf(file);
  const bool isStl = extension == ".stl";
  const bool keepsPatches = extension == ".obj" || (isStl && options.ascii);
  SurfaceOutput output{.soup = std::move(soup), .patches = 1, .losses = {}};
  const std::size_t patches = output.soup.patchNames.size();
  const auto box = output.soup.boundingBox();
  const bool hadFaces = output.soup.polygonCount() > 0;
  if (keepsPatches) {
    output.patches = patches;
  } else if (patches > 1) {
    output.losses.push_back("note: this format does not keep the names of " +
                            grouped(patches, "patch") + "; .obj does, and .stl with --ascii");
  }
  bool isExact = true;
  if (isStl && !options.ascii) {
    const auto loss = roundedToSingle(file, output.soup);
    isExact = loss.empty();
    if (!isExact) output.losses.push_back(loss);
  }
  const bool hasOnlyTriangles = output.soup.corners.size() == 3 * output.soup.polygonCount();
  if (isStl && !(hasOnlyTriangles && isExact)) output.soup = triangulated(output.soup);
  if (hadFaces && output.soup.polygonCount() == 0) {
    throw Error(ErrorKind::Argument, whyNothingIsLeft(file, box));
  }
  return output;
}

std::string sizeOf(const SurfaceOutput& surface) {
  return grouped(surface.soup.polygonCount(), "polygon") + ", " +
         grouped(surface.soup.points.size(), "point") + ", " + grouped(surface.patches, "patch");
}

std::string lossesOf(const SurfaceOutput& surface) {
  std::string text;
  for (const auto& loss : surface.losses) text += loss + '\n';
  return text;
}

}  // namespace cutwater::tool
