#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

namespace cutwater::detail {

/// Treatments that help, and the openings that cleaning and welding leave.
struct FoundTreatments {
  std::vector<Treatment> treatments;
  std::vector<Opening> openings;
};

/// Looks for treatments as diagnose() describes; none if cleaning changes nothing and nothing is
/// open, or nothing helps.
[[nodiscard]] FoundTreatments findTreatments(const PolygonSoup& soup, const HoleFilling& fillHoles);

}  // namespace cutwater::detail
