#pragma once

#include <Cutwater/Mesh/Diagnosis.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "Options/Command.hpp"
#include "Options/StepReport.hpp"

namespace cutwater::tool {

/// The steps for Cutwater::Repair, after cleaning and closing on planes; all sizes are lengths.
struct MendingOptions {
  struct Wrap {
    double gap = 0;
    std::optional<double> offset = {};
  };

  std::optional<double> widestHole = {};  ///< infinity: of any width
  bool selfIntersections = false;
  std::optional<Wrap> wrap = {};
  double seconds = 60;  ///< for each step
  bool isShown = true;  ///< whether a terminal shows the progress
};

/// Whether the program was built with Cutwater::Repair. Otherwise there are no such options or
/// steps.
[[nodiscard]] bool canMend();

/// Fills holes as the option --holes does; empty without Cutwater::Repair.
[[nodiscard]] HoleFilling holeFilling();

/// Adds the options to the command, which `options` must outlive.
void addMendingOptions(Command command, MendingOptions& options);

/// The options as written on a command line, each preceded by a blank.
[[nodiscard]] std::string commandLine(const MendingOptions& options);

/// Appends the requested steps: holes, self-intersections, wrap.
void addMendingSteps(const MendingOptions& options, std::vector<RepairStep>& steps);

}  // namespace cutwater::tool
