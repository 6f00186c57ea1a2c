#include "Options/Program.hpp"

#include <Cutwater/Text/Suggestion.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <vector>

#include "Options/UsageError.hpp"
#include "Report/Failure.hpp"

namespace cutwater::tool {

Program::Program(const std::string& name, const std::string& description, const std::string& footer)
    : app_(std::make_unique<CLI::App>()) {
  app_->name(name);
  app_->description(description);
  app_->set_version_flag("--version", name + " " + CUTWATER_VERSION);
  app_->require_subcommand(1);
  app_->footer(footer);
}

Program::~Program() = default;

Command Program::addCommand(const std::string& name, const std::string& description) {
  return Command(*app_->add_subcommand(name, description));
}

void Program::addHelpForAll() {
  app_->set_help_all_flag("--help-all", "Help for all subcommands");
}

std::string Program::help() const {
  return app_->help();
}

int Program::run(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (const auto unknown = unknownWord()) return refuse(*unknown);
    // --help and --version come this way, too; they go to stdout.
    if (error.get_exit_code() == 0) return isSilent_ ? 0 : app_->exit(error);
    return refuse(error.what());
  } catch (const UsageError& error) {
    return refuse(error.what());
  }
  std::cout.flush();
  return std::cout ? 0 : failed(app_->get_name(), "cannot write to standard output", kFailed);
}

int Program::refuse(const std::string& message) const {
  return isSilent_ ? kUsage : failed(app_->get_name(), message, kUsage);
}

std::optional<std::string> Program::unknownWord() const {
  const auto rest = app_->remaining(/*recurse=*/true);
  const auto parsed = app_->get_subcommands();
  const auto isOption = [](const std::string& word) { return word.starts_with('-'); };
  std::vector<std::string> known;
  if (parsed.empty() && !rest.empty() && !isOption(rest.front())) {
    for (const auto* command : app_->get_subcommands({})) known.push_back(command->get_name());
    return "there is no command \"" + rest.front() + '"' + text::suggestion(rest.front(), known);
  }
  const auto found = std::ranges::find_if(rest, isOption);
  if (parsed.empty() || found == rest.end()) return {};
  for (const auto* option : parsed.front()->get_options()) {
    for (const auto& name : option->get_lnames()) known.push_back("--" + name);
  }
  const auto option = found->substr(0, found->find('='));
  return parsed.front()->get_name() + " has no option \"" + option + '"' +
         text::suggestion(option, known);
}

}  // namespace cutwater::tool
