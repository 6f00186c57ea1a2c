#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

#include "Options/RepairSteps.hpp"
#include "Report/DiagnosisPage.hpp"
#include "Report/Json.hpp"

// Reports for programs; Docs/cleaning.md lists the keys.
namespace cutwater::tool {

[[nodiscard]] Json toJson(const Vec3<double>& v);
/// {"lower": [...], "upper": [...]}; null for an empty box.
[[nodiscard]] Json toJson(const Box<double>& box);
[[nodiscard]] Json toJson(const std::vector<Defect>& defects);
[[nodiscard]] Json toJson(const std::vector<Advice>& next);
/// {"area": ..., "volume": ...}
[[nodiscard]] Json toJson(const SurfaceMeasure& measure);
[[nodiscard]] Json toJson(const StepReport& report);

/// What the check found: closed, oriented, counts.
[[nodiscard]] Json checkJson(const Diagnosis& found);
[[nodiscard]] Json toJson(const SignReport& signs);

}  // namespace cutwater::tool
