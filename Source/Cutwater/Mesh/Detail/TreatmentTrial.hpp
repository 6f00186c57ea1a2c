#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Surface/MeshReport.hpp>

namespace cutwater::detail {

/// A treatment, tried on a copy of the surface.
struct TreatmentTrial {
  Treatment treatment;
  PolygonSoup soup;
  MeshReport report;
  std::vector<TreatmentEffect> effects;

  /// Number of edges that make the surface open: those with one face, and others with faces in
  /// excess.
  [[nodiscard]] std::size_t gaps() const { return report.oddEdges + report.unbalancedEdges; }
};

/// Tries a treatment on a copy of the surface; returns nothing if a step refuses it.
[[nodiscard]] std::optional<TreatmentTrial> tried(const PolygonSoup& soup,
                                                  const Treatment& treatment,
                                                  const HoleFilling& fillHoles);

}  // namespace cutwater::detail
