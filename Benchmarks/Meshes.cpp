#include "Meshes.hpp"

#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include "Refine.hpp"

namespace cutwater::benchmarks {

namespace {

constexpr const char* kElephant = "elephant";
constexpr const char* kHull = "hull";
constexpr const char* kFineHull = "fine-hull";
constexpr std::size_t kFineTriangles = 1'100'000;

}  // namespace

std::vector<std::string> surfaceNames() {
  return {kElephant, kHull, kFineHull};
}

PolygonSoup loadSurface(const std::string& name, const std::filesystem::path& data) {
  if (name == kElephant) return readSurface(data / "elephant.off").soup;
  auto hull = readSurface(data / "hull.stl.gz").soup;
  if (name == kHull) return hull;
  hull = refined(std::move(hull), kFineTriangles);
  displace(hull, 1e-5 * hull.boundingBox().diagonal());
  return hull;
}

std::filesystem::path surfaceFile(const std::string& name, const std::filesystem::path& data) {
  if (name == kElephant) return data / "elephant.off";
  if (name == kHull) return data / "hull.stl.gz";
  auto file = data / (name + ".stl");
  if (!std::filesystem::exists(file)) writeSurface(file, loadSurface(name, data));
  return file;
}

}  // namespace cutwater::benchmarks
