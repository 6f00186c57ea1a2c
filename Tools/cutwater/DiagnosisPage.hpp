#pragma once

#include "Diagnosis.hpp"
#include "Page.hpp"

namespace cutwater::tool {

/// To find places in the coordinates of a map, too, millions of metres from their origin.
inline constexpr int kPlaceDigits = 8;

/// A command, and what it is good for.
struct Advice {
  std::string command;
  std::string purpose;
};

/// The section "Defects": severity, how many, what, what it means, the first few places.
void describe(Page& page, const std::vector<Defect>& defects);

/// The section "Next".
void describe(Page& page, const std::vector<Advice>& next);

/// What to do with a surface whose file is `file`, as a word of a shell, with its options.
[[nodiscard]] std::vector<Advice> usesOf(const std::string& file);

}  // namespace cutwater::tool
