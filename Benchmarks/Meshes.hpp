#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace cutwater::benchmarks {

/// The surfaces, from small to large: an elephant, a ship hull, and the hull refined to more than a
/// million triangles. All are closed, and triangles only.
[[nodiscard]] std::vector<std::string> surfaceNames();

/// @throws Error if the folder lacks its file.
[[nodiscard]] PolygonSoup loadSurface(const std::string& name, const std::filesystem::path& data);

/// The file that reading it is measured with; made if need be.
[[nodiscard]] std::filesystem::path surfaceFile(const std::string& name,
                                                const std::filesystem::path& data);

}  // namespace cutwater::benchmarks
