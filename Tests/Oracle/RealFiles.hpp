#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

namespace cutwater::test {

/// Whether it has the ending of a surface, compressed or not.
inline bool isSurface(const std::filesystem::path& file) {
  auto path = file;
  if (path.extension() == ".gz") path = path.stem();
  for (const char* extension : {".stl", ".obj", ".ply", ".off", ".vtk"}) {
    if (path.extension() == extension) return true;
  }
  return false;
}

/// The surfaces of a folder and of those in it, in the order of their names.
inline std::vector<std::filesystem::path> surfacesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (isSurface(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Two files of curves, without faces, and one with a face more than its header says.
inline bool isNoSurface(const std::filesystem::path& file) {
  const auto name = file.filename();
  return name == "curve.obj" || name == "curve2.vtk" || name == "prim.off";
}

}  // namespace cutwater::test
