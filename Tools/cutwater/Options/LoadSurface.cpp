#include "Options/LoadSurface.hpp"

#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Scene/ReadScene.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "Options/OpenSurface.hpp"
#include "Report/Format.hpp"
#include "Report/OutOfMemory.hpp"
#include "Report/StepLine.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

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

/// The surface in a file of one of the formats for surfaces.
LoadedSurface loadFile(const SurfaceOptions& options) {
  constexpr std::uintmax_t kLarge = 20'000'000;  // bytes, which take about a second
  std::error_code ignored;
  const auto size = std::filesystem::file_size(options.file, ignored);
  StepLine line(!options.quiet && !ignored && size >= kLarge);
  line.show("reading " + fileName(options));
  Stopwatch watch;
  auto [soup, report] = readAnySurface(
      options.file, {.scale = options.scale, .placement = options.placement, .weld = false});
  requireNear(soup, options);
  LoadedSurface surface{.soup = std::move(soup), .report = std::move(report)};
  surface.secondsToRead = watch.lap();
  surface.pointsMerged = weldExactly(surface.soup);
  surface.secondsToWeld = watch.lap();
  return surface;
}

}  // namespace

LoadedSurface load(const SurfaceOptions& options) {
  if (isScene(options)) {
    throw Error(ErrorKind::File, options.file +
                                     ": a scene has no surface mesh to work on; 'cutwater "
                                     "isosurface' makes one of it, and info, sample, amr, cells, "
                                     "slice and render take scenes");
  }
  return namingMemory(options.file + ": out of memory while reading it", [&] {
    const auto info = geometryFileInfo(options.file);
    if (!info) return loadFile(options);
    return info->bytesPerNumber == sizeof(float) ? loadPrepared<float>(options, *info)
                                                 : loadPrepared<double>(options, *info);
  });
}

namespace {

bool saysSigns(const SurfaceOptions& options) {
  return !options.quiet && !options.mayBeOpen;
}

/// Builds the solid, and says what its signs are based on unless that is sound.
template <std::floating_point T>
MeshSDF<T> built(const SurfaceOptions& options) {
  const auto soup = load(options).soup;
  auto solid = namingMemory(options.file + ": out of memory while building the tree of " +
                                grouped(soup.polygonCount(), "polygon"),
                            [&] { return MeshSDF<T>(soup, options.solid); });
  if (!saysSigns(options) || solid.signReport().isSound()) return solid;
  std::cout << "signs: " << solid.signReport().summary() << '\n'
            << adviceOnOpenings(soup, solid.signReport(), options) << std::flush;
  return solid;
}

}  // namespace

template <std::floating_point T>
MeshSDF<T> loadMesh(const SurfaceOptions& options) {
  if (auto solid = ready<T>(options)) {
    if (saysSigns(options) && !solid->signReport().isSound()) {
      std::cout << "signs: " << solid->signReport().summary() << '\n';
    }
    return *std::move(solid);
  }
  try {
    return built<T>(options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Topology) throw;
    throw Error(ErrorKind::Topology, options.file + ": " + error.what());
  }
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
  auto solid = namingMemory(options.file + ": out of memory while making the scene's solid",
                            [&] { return readScene(options.file); });
  if (options.scale != 1) solid = scaled(solid, options.scale);
  solid.setPlacement(RigidTransform<double>::composed(solid.placement(), options.placement));
  return solid;
}

Box<double> boxAround(const Solid<double>& solid) {
  const auto* const mesh = solid.as<MeshSDF<double>>();
  if (mesh == nullptr) return solid.boundingBox();
  return solid.placement().toWorld(mesh->surfaceBox());
}

std::uint64_t sourceHash(const SurfaceOptions& options) {
  if (const auto info = geometryFileInfo(options.file)) return info->source;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(options.file, ignored)) return 0;
  std::ifstream file(options.file, std::ios::binary);
  const std::string content(std::istreambuf_iterator<char>(file), {});
  return xxHash64(std::as_bytes(std::span(content)));
}

}  // namespace cutwater::tool
