#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "StepReport.hpp"

namespace CLI {
class App;
}

namespace cutwater::tool {

/// What Cutwater::Repair is to do, after cleaning and closing on planes; all lengths.
struct MendingOptions {
  struct Wrap {
    double gap = 0;
    std::optional<double> offset = {};
  };

  std::optional<double> widestHole = {};  ///< infinity: of any width
  bool selfIntersections = false;
  std::optional<Wrap> wrap = {};
  double seconds = 60;  ///< for each step
};

/// Whether the program was built with Cutwater::Repair. Without it there are no such options and no
/// such steps.
[[nodiscard]] bool canMend();

/// Adds the options to the command. `options` must live as long as it.
void addMendingOptions(CLI::App& command, MendingOptions& options);

/// The options as they are written on a command line, each with a blank before it.
[[nodiscard]] std::string commandLine(const MendingOptions& options);

/// Appends holes, self-intersections and the wrap, as far as they are wanted.
void addMendingSteps(const MendingOptions& options, std::vector<RepairStep>& steps);

}  // namespace cutwater::tool
