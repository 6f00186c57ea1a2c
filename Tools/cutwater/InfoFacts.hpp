#pragma once

#include <Cutwater/Sdf/Guarantee.hpp>

#include <optional>
#include <string>
#include <vector>

#include "Diagnosis.hpp"
#include "DiagnosisPage.hpp"
#include "Surface.hpp"
#include "Treatment.hpp"

namespace cutwater::tool {

struct InfoOptions : SurfaceOptions {
  bool inFloat = false;
  bool json = false;
};

/// The memory that a solid takes, in bytes.
struct MemoryUse {
  std::size_t bytes = 0;
  std::size_t bytesPerTriangle = 0;
  std::size_t peak = 0;  ///< while it was built, not counting the soup
};

/// The surface as a MeshSDF.
struct SolidFacts {
  SignReport signs;
  Guarantee<double> guarantee;
  MemoryUse memory;
  std::optional<MemoryUse> memoryInFloat;
  double seconds = 0;  ///< to build it
};

/// Everything that `cutwater info` reports: the page and the JSON are views of it.
struct InfoFacts {
  InfoOptions options;
  LoadedSurface surface;
  std::optional<std::size_t> bytesOnDisk;
  Examination found;
  std::optional<SolidFacts> solid;    ///< none: there are no triangles
  std::optional<double> solidVolume;  ///< none: not known without doubt
  std::vector<Defect> defects;
  Treatments treatments;
  double secondsToTreat = 0;
  std::vector<Advice> next;

  [[nodiscard]] std::optional<SignReport> signs() const {
    return solid ? std::optional(solid->signs) : std::nullopt;
  }
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
[[nodiscard]] std::optional<std::string> planeOf(const Rim& rim, const Treatments& treatments);

/// The report as a page or as JSON; ends with '\n'.
[[nodiscard]] std::string pageOf(const InfoFacts& facts);
[[nodiscard]] std::string jsonOf(const InfoFacts& facts);

/// The report on a scene, as a page or in JSON. Ends with '\n'.
/// @throws Error as loadSolid(), and if single precision is requested.
[[nodiscard]] std::string aboutScene(const InfoOptions& options);

}  // namespace cutwater::tool
