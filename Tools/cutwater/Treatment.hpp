#pragma once

#include <Cutwater/Mesh/Cleaning/Rims.hpp>
#include <Cutwater/Mesh/MeshReport.hpp>

#include <string>
#include <vector>

#include "RepairSteps.hpp"

// Which repair would help: found by trying it on a copy, so that nothing is promised that does not
// come about.
namespace cutwater::tool {

/// A repair that was tried.
struct Treatment {
  RepairOptions options;
  std::string effect;     ///< what it does and what is left then, in words
  bool isClosed = false;  ///< no edge is open then, nor has faces in excess
};

struct Treatments {
  std::vector<Treatment> found;  ///< of several the first is recommended, others are alternatives
  std::vector<Rim> openings;     ///< after cleaning and welding, the largest first
  double planeTolerance = 0;     ///< within which openings were taken for plane, a length
};

/// Looks for what `cutwater repair` can do about the surface: cleaning; if it is open, tolerances
/// for welding and junctions that close gaps; then caps, a mirror image or an extension for
/// openings in planes across an axis. None if cleaning changes nothing and nothing is open, or
/// nothing helps.
[[nodiscard]] Treatments findTreatments(const PolygonSoup& soup);

}  // namespace cutwater::tool
