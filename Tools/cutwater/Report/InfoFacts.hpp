#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

#include <optional>
#include <string>
#include <vector>

#include "Options/LoadSurface.hpp"
#include "Report/DiagnosisPage.hpp"

namespace cutwater::tool {

struct InfoOptions : SurfaceOptions {
  bool inFloat = false;
  bool json = false;
};

/// Everything that `cutwater info` reports: the page and the JSON are views of it.
struct InfoFacts {
  InfoOptions options;
  LoadedSurface surface;
  std::optional<std::size_t> bytesOnDisk;
  Diagnosis found;
  std::optional<std::size_t> bytesInFloat;  ///< that the surface takes in single precision
  std::optional<std::size_t> peakResidentBytes;
  std::vector<Advice> next;
};

/// @throws Error if the file cannot be read.
[[nodiscard]] InfoFacts gather(const InfoOptions& options);

/// "binary STL, gzip-compressed"
[[nodiscard]] std::string formatOf(const LoadedSurface& surface);

/// Number of polygons of each named patch.
[[nodiscard]] std::vector<std::size_t> polygonsPerPatch(const PolygonSoup& soup);

/// The meaning of distances, in words.
[[nodiscard]] std::string meaningOf(const Guarantee<double>& guarantee);

/// Returns "y = 0", for example, if the opening lies in a plane across an axis.
[[nodiscard]] std::optional<std::string> planeOf(const Opening& opening);

/// The bytes that a solid takes for each of the surface's triangles.
[[nodiscard]] std::size_t bytesPerTriangle(std::size_t bytes, const MeshReport& report);

/// The report as a page or as JSON; ends with '\n'.
[[nodiscard]] std::string pageOf(const InfoFacts& facts);
[[nodiscard]] std::string jsonOf(const InfoFacts& facts);

/// The report on a scene, as a page or in JSON. Ends with '\n'.
/// @throws Error as loadSolid(), and if single precision is requested.
[[nodiscard]] std::string aboutScene(const InfoOptions& options);

}  // namespace cutwater::tool
