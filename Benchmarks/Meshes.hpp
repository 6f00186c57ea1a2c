#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace cutwater::benchmarks {

/// The surfaces of up to so many triangles, from small to large, and of triangles only: closed ones
/// (an elephant, a bear, a ship's hull, and the hull refined), one that meets itself (a camel) and
/// one that is open (the head of a lion).
[[nodiscard]] std::vector<std::string> surfaceNames(std::size_t mostTriangles);

/// @throws Error if the folder lacks its file.
[[nodiscard]] PolygonSoup loadSurface(const std::string& name, const std::filesystem::path& data);

/// The file that reading it is measured with; made if need be.
[[nodiscard]] std::filesystem::path surfaceFile(const std::string& name,
                                                const std::filesystem::path& data);

}  // namespace cutwater::benchmarks
