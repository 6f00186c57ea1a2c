#include "Meshes.hpp"

#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include <algorithm>

#include "Refine.hpp"

namespace cutwater::benchmarks {

namespace {

/// A file's triangles, or more.
struct Surface {
  std::string name;
  std::string file;
  std::size_t triangles = 0;
  bool isRefined = false;
};

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> all{
      {"elephant", "elephant.off", 5558},
      {"lion-head", "lion-head.off", 16'674},
      {"camel", "camel.off", 19'536},
      {"bear", "bear_bis.off", 20'188},
      {"hull", "hull.stl.gz", 116'062},
      {"fine-hull", "hull.stl.gz", 1'100'000, true},
      {"finest-hull", "hull.stl.gz", 10'000'000, true},
  };
  return all;
}

const Surface& surfaceCalled(const std::string& name) {
  return *std::ranges::find(surfaces(), name, &Surface::name);
}

}  // namespace

std::vector<std::string> surfaceNames(std::size_t mostTriangles) {
  std::vector<std::string> names;
  for (const auto& surface : surfaces()) {
    if (surface.triangles <= mostTriangles) names.push_back(surface.name);
  }
  return names;
}

PolygonSoup loadSurface(const std::string& name, const std::filesystem::path& data) {
  const auto& surface = surfaceCalled(name);
  auto soup = readSurface(data / surface.file).soup;
  if (!surface.isRefined) return soup;
  soup = refined(std::move(soup), surface.triangles);
  displace(soup, 1e-5 * soup.boundingBox().diagonal());
  return soup;
}

std::filesystem::path surfaceFile(const std::string& name, const std::filesystem::path& data) {
  const auto& surface = surfaceCalled(name);
  if (!surface.isRefined) return data / surface.file;
  auto file = data / (name + ".stl");
  if (!std::filesystem::exists(file)) writeSurface(file, loadSurface(name, data));
  return file;
}

}  // namespace cutwater::benchmarks
