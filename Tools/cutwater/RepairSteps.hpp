#pragma once

#include <Cutwater/Mesh/Cleaning/Clean.hpp>

#include <string>
#include <vector>

#include "Mending.hpp"

namespace CLI {
class App;
}

namespace cutwater::tool {

/// An option of `cutwater repair` that closes openings, as it is written: "--cap", "z=0:inlet".
struct OpeningOption {
  std::string name;
  std::string value;
};

/// What `cutwater repair` is to do.
struct RepairOptions {
  CleanOptions clean;
  double tolerance = 0;  ///< of the openings' planes, a length
  std::vector<OpeningOption> openings;
  MendingOptions mending;
};

/// Adds the options to the command. `options` must live as long as it.
void addRepairOptions(CLI::App& command, RepairOptions& options);

/// The options as they are written on a command line, each with a blank before it.
[[nodiscard]] std::string commandLine(const RepairOptions& options);

/// The steps in their order: cleaning, then openings as they were given, then what Cutwater::Repair
/// does. A new kind of step is a function here, an option above and a report that StepReport knows.
/// @throws CLI::ValidationError for the value of an option that cannot be read.
[[nodiscard]] std::vector<RepairStep> stepsOf(const RepairOptions& options);

/// The report's lines, each ended by '\n'.
[[nodiscard]] std::string text(const StepReport& report);

}  // namespace cutwater::tool
