#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

#include "Report/Page.hpp"

namespace cutwater::tool {

/// Enough to locate places even in map coordinates, millions of metres from their origin.
inline constexpr int kPlaceDigits = 8;

/// A command and its purpose.
struct Advice {
  std::string command;
  std::string purpose;
};

/// Adds the section "Defects": severity, count, name, meaning and the first few places.
void describe(Page& page, const std::vector<Defect>& defects);

/// Adds the section "Next".
void describe(Page& page, const std::vector<Advice>& next);

/// Suggestions on how to use a surface. `file`: its file, as a shell word, and its options.
[[nodiscard]] std::vector<Advice> usesOf(const std::string& file);

}  // namespace cutwater::tool
