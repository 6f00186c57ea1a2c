#pragma once

#include <Cutwater/Surface/MeshReport.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "RepairSteps.hpp"

namespace cutwater::tool {

/// The effects of a repair, in words, with their counts: "faces turned", 3.
using Effects = std::vector<std::pair<std::string, std::size_t>>;

/// A repair, tried on a copy of the surface.
struct Trial {
  PolygonSoup soup;
  RepairOptions options;
  MeshReport report;
  Effects effects;

  /// Number of edges that make the surface open: those with one face, and others with faces in
  /// excess.
  [[nodiscard]] std::size_t gaps() const { return report.oddEdges + report.unbalancedEdges; }
};

/// Tries a repair on a copy of the surface; returns nothing if a step refuses it.
[[nodiscard]] std::optional<Trial> tried(const PolygonSoup& soup, const RepairOptions& options);

}  // namespace cutwater::tool
