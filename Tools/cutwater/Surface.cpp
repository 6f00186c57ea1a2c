#include "Surface.hpp"

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/ReadScene.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "Arguments.hpp"
#include "Choice.hpp"
#include "Format.hpp"

namespace cutwater::tool {

namespace {

void rotate(RigidTransform<double>& placement, const std::string& text) {
  constexpr const char* kNeed = "degrees and an axis, x, y or z or three numbers: 90,x or 30,1,1,0";
  const auto comma = text.find(',');
  const auto axis = comma == std::string::npos ? std::string() : text.substr(comma + 1);
  if (axis == "x" || axis == "y" || axis == "z") {
    placement.rotate(numbers("--rotate", text.substr(0, comma), kNeed).front(),
                     axisOf("--rotate", axis));
    return;
  }
  const auto values = numbers("--rotate", text, kNeed);
  if (values.size() != 4 || (values[1] == 0 && values[2] == 0 && values[3] == 0)) {
    refuse("--rotate", text, kNeed);
  }
  placement.rotate(values[0], Vec3<double>{values[1], values[2], values[3]});
}

/// The triangles of a prepared file, moved as if read from the file that it was made from.
template <std::floating_point T>
LoadedSurface loadPrepared(const SurfaceOptions& options, const GeometryFileInfo& info) {
  Stopwatch watch;
  const auto solid = MeshSDF<T>::open(options.file);
  LoadedSurface surface{.soup = solid.soup(), .report = {}};
  for (auto& p : surface.soup.points) {
    const Vec3<double> placed(solid.placement().toWorld(static_cast<Vec3<T>>(p)));
    p = options.placement.toWorld(options.scale * placed);
  }
  surface.report.bytes = std::filesystem::file_size(options.file);
  surface.report.pointsInFile = surface.soup.points.size();
  surface.report.polygonsInFile = surface.soup.polygonCount();
  surface.prepared = Prepared{.info = info, .signs = solid.signReport().summary()};
  surface.secondsToRead = watch.lap();
  return surface;
}

/// The solid in a prepared file, if it can be used as it is: not if options scale or move it or
/// request other signs, or if it has the other precision.
template <std::floating_point T>
std::optional<MeshSDF<T>> ready(const SurfaceOptions& options) {
  const auto info = geometryFileInfo(options.file);
  if (!info || info->bytesPerNumber == (sizeof(T) == 4 ? 8 : 4)) return {};
  auto solid = MeshSDF<T>::open(options.file, {.threads = options.threads});
  const bool isWanted = options.scale == 1 && options.placement.isIdentity() &&
                        options.solid.signs == SignScheme::Automatic &&
                        (!options.solid.requireWatertight || solid.signReport().isSound());
  if (!isWanted) return {};
  return solid;
}

/// Coordinates must have squares, or nothing can be measured.
void requireNear(const PolygonSoup& soup, const SurfaceOptions& options) {
  for (const auto& p : soup.points) {
    if (std::isfinite(lengthSquared(p))) continue;
    throw Error(ErrorKind::Argument, options.file + options.motions + ": the point " + point(p) +
                                         " is too far away: at most 1e150 can be computed with");
  }
}

}  // namespace

std::string extensionOf(const std::string& file) {
  auto extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

void addQuiet(CLI::App& command, bool& quiet) {
  command.add_flag("-q,--quiet", quiet, "Say nothing but errors");
}

void addSurfaceOptions(CLI::App& command, SurfaceOptions& options, Reads reads) {
  const std::string scenes =
      reads == Reads::SurfacesAndScenes ? ", or a scene in TOML: see 'cutwater scene'" : "";
  command
      .add_option("FILE", options.file,
                  "STL, OBJ, PLY, OFF or legacy VTK, also gzip-compressed, or what 'cutwater "
                  "prepare' wrote" +
                      scenes)
      ->check([](const std::string& text) {
        return text == "-" ? "'-': standard input is called /dev/stdin" : "";
      })
      ->required();
  command
      .add_option_function<std::string>(
          "--scale",
          [&](const std::string& text) {
            options.scale = positiveNumber("--scale", text);
            options.motions += " --scale " + text;
          },
          "Multiply the file's coordinates first; 0.001: millimetres to metres")
      ->type_name("FACTOR");
  // The functions are called as options are read, so that motions act in the order given.
  command
      .add_option_function<std::string>(
          "--translate",
          [&](const std::string& text) {
            options.placement.translate(vectorOf("--translate", text));
            options.motions += " --translate " + text;
          },
          "Then move the surface; may be repeated")
      ->type_name("X,Y,Z")
      ->trigger_on_parse();
  command
      .add_option_function<std::string>(
          "--rotate",
          [&](const std::string& text) {
            rotate(options.placement, text);
            options.motions += " --rotate " + text;
          },
          "Turn the surface about an axis through the origin, in the order given with --translate; "
          "may be repeated")
      ->type_name("DEGREES,AXIS")
      ->trigger_on_parse();
  command.add_option("--threads", options.threads, "Use so many threads; 0: all there are")
      ->check(CLI::Range(0, 4096))
      ->type_name("N");
  addQuiet(command, options.quiet);
}

void addSignOptions(CLI::App& command, SurfaceOptions& options) {
  addChoice<SignScheme>(command, "--signs", options.solid.signs,
                        {{"auto", SignScheme::Automatic},
                         {"nearest", SignScheme::NearestFeature},
                         {"winding", SignScheme::WindingNumber}},
                        "How to tell inside from outside: by the nearest faces, or by how often "
                        "the surface goes round a point (for open and overlapping surfaces); "
                        "without it: as a check of the surface suggests");
  command.add_flag("--require-watertight", options.solid.requireWatertight,
                   "Refuse a surface that does not bound a solid");
}

bool isScene(const SurfaceOptions& options) {
  return extensionOf(options.file) == ".toml";
}

LoadedSurface load(const SurfaceOptions& options) {
  if (isScene(options)) {
    throw Error(ErrorKind::File, options.file +
                                     ": a scene has no surface mesh to work on; 'cutwater "
                                     "isosurface' makes one of it, and info, sample, amr, slice "
                                     "and render take scenes");
  }
  if (const auto info = geometryFileInfo(options.file)) {
    return info->bytesPerNumber == sizeof(float) ? loadPrepared<float>(options, *info)
                                                 : loadPrepared<double>(options, *info);
  }
  Stopwatch watch;
  auto [soup, report] = readSurface(
      options.file, {.scale = options.scale, .placement = options.placement, .weld = false});
  requireNear(soup, options);
  LoadedSurface surface{.soup = std::move(soup), .report = std::move(report)};
  surface.secondsToRead = watch.lap();
  surface.pointsMerged = weldExactly(surface.soup);
  surface.secondsToWeld = watch.lap();
  return surface;
}

template <std::floating_point T>
MeshSDF<T> loadMesh(const SurfaceOptions& options) {
  auto solid = ready<T>(options);
  try {
    if (!solid) solid.emplace(load(options).soup, options.solid);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Topology) throw;
    throw Error(ErrorKind::Topology, options.file + ": " + error.what());
  }
  if (!options.quiet && !solid->signReport().isSound()) {
    std::cout << "signs: " << solid->signReport().summary() << '\n';
  }
  return *std::move(solid);
}

template MeshSDF<float> loadMesh(const SurfaceOptions&);
template MeshSDF<double> loadMesh(const SurfaceOptions&);

Solid<double> loadSolid(const SurfaceOptions& options) {
  if (!isScene(options)) return loadMesh(options);
  if (options.solid.signs != SignScheme::Automatic || options.solid.requireWatertight) {
    throw Error(ErrorKind::Argument,
                options.file +
                    ": --signs and --require-watertight are for surfaces; in a scene, "
                    "\"signs\" and \"require_watertight\" are keys of its meshes");
  }
  auto solid = readScene(options.file);
  if (options.scale != 1) solid = scaled(solid, options.scale);
  solid.setPlacement(RigidTransform<double>::composed(solid.placement(), options.placement));
  return solid;
}

Box<double> boxAround(const Solid<double>& solid) {
  const auto box = solid.boundingBox();
  const auto* const mesh = solid.as<MeshSDF<double>>();
  return mesh == nullptr || isFinite(box) ? box : solid.placement().toWorld(mesh->surfaceBox());
}

std::uint64_t sourceHash(const SurfaceOptions& options) {
  if (const auto info = geometryFileInfo(options.file)) return info->source;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(options.file, ignored)) return 0;
  std::ifstream file(options.file, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(file), {});
  return xxHash64(std::as_bytes(std::span(content)));
}

std::string fileName(const SurfaceOptions& options) {
  return std::filesystem::path(options.file).filename().string();
}

}  // namespace cutwater::tool
