#pragma once

#include <Cutwater/Surface/Cleaning/Rims.hpp>
#include <Cutwater/Surface/MeshReport.hpp>

#include <string>
#include <vector>

#include "RepairSteps.hpp"

// Finds repairs that help by trying them on a copy, so that only effects that occur are promised.
namespace cutwater::tool {

/// A repair that was tried.
struct Treatment {
  RepairOptions options;
  std::string effect;     ///< what it does and what remains, in words
  bool isClosed = false;  ///< afterwards no edge is open or has faces in excess
};

struct Treatments {
  std::vector<Treatment> found;  ///< the first is recommended, others are alternatives
  std::vector<Rim> openings;     ///< after cleaning and welding, the largest first
  double planeTolerance = 0;     ///< within which openings count as plane, a length
};

/// Searches for what `cutwater repair` can do for the surface: cleaning; if it is open, tolerances
/// for welding and junctions that close gaps; then caps, a mirror image or an extension for
/// openings in planes across an axis. Finds none if cleaning changes nothing and nothing is open,
/// or nothing helps.
[[nodiscard]] Treatments findTreatments(const PolygonSoup& soup);

}  // namespace cutwater::tool
