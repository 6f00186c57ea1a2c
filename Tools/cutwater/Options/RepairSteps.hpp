#pragma once

#include <Cutwater/Surface/Cleaning/Clean.hpp>

#include <string>
#include <vector>

#include "Options/Command.hpp"
#include "Options/Mending.hpp"

namespace cutwater::tool {

/// An option of `cutwater repair` that closes openings, as written: "--cap", "z=0:inlet".
struct OpeningOption {
  std::string name;
  std::string value;
};

/// The repairs requested from `cutwater repair`.
struct RepairOptions {
  CleanOptions clean;
  double tolerance = 0;  ///< for the openings' planes, a length
  std::vector<OpeningOption> openings;
  MendingOptions mending;
};

/// Adds the options to the command, which `options` must outlive.
void addRepairOptions(Command command, RepairOptions& options);

/// The options that ask for a treatment.
[[nodiscard]] RepairOptions optionsOf(const Treatment& treatment);

/// The options as written on a command line, each preceded by a blank.
[[nodiscard]] std::string commandLine(const RepairOptions& options);

/// The steps in order: cleaning, then openings in the order given, then those of Cutwater::Repair.
/// A new kind of step needs a function here, an option above and a report in StepReport.
/// @throws UsageError for the value of an option that cannot be read.
[[nodiscard]] std::vector<RepairStep> stepsOf(const RepairOptions& options);

/// The report's lines, each ending with '\n'.
[[nodiscard]] std::string text(const StepReport& report);

}  // namespace cutwater::tool
