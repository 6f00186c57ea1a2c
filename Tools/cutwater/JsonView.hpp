#pragma once

#include <nlohmann/json.hpp>

#include "Diagnosis.hpp"
#include "DiagnosisPage.hpp"
#include "RepairSteps.hpp"

// Reports for programs; Docs/cleaning.md lists the keys.
namespace cutwater::tool {

/// Keys stay in the order in which they are written.
using Json = nlohmann::ordered_json;

[[nodiscard]] Json toJson(const Vec3<double>& v);
/// {"lower": [...], "upper": [...]}; null for an empty box.
[[nodiscard]] Json toJson(const Box<double>& box);
[[nodiscard]] Json toJson(const std::vector<Defect>& defects);
[[nodiscard]] Json toJson(const std::vector<Advice>& next);
/// {"area": ..., "volume": ...}
[[nodiscard]] Json toJson(const SurfaceMeasure& measure);
[[nodiscard]] Json toJson(const StepReport& report);

/// What the check found: closed, oriented, counts.
[[nodiscard]] Json checkJson(const Examination& found, const std::vector<Defect>& defects,
                             const std::optional<SignReport>& signs);
[[nodiscard]] Json signsJson(const SignReport& signs);

/// As text that ends with '\n'. Bytes that are not UTF-8, in names of files and patches, are
/// replaced.
[[nodiscard]] std::string dumped(const Json& json);

}  // namespace cutwater::tool
