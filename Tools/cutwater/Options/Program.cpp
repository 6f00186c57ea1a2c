#include "Options/Program.hpp"

#include <Cutwater/Text/Suggestion.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <vector>

#include "Options/UsageError.hpp"
#include "Report/Failure.hpp"

namespace cutwater::tool {

namespace {

std::vector<std::string> optionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

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
  const auto isOption = [](const std::string& word) { return word.starts_with('-'); };
  const auto own = app_->remaining(/*recurse=*/false);  // what stands before a command
  if (!own.empty() && !isOption(own.front())) {
    auto known = optionsOf(*app_);  // for "help"
    for (const auto* command : app_->get_subcommands({})) known.push_back(command->get_name());
    return "there is no command \"" + own.front() + '"' + text::suggestion(own.front(), known);
  }
  const auto parsed = app_->get_subcommands();
  const auto& asked = own.empty() && !parsed.empty() ? *parsed.front() : *app_;
  const auto rest = asked.remaining(/*recurse=*/true);
  const auto found = std::ranges::find_if(rest, isOption);
  if (found == rest.end()) return {};
  const auto option = found->substr(0, found->find('='));
  return asked.get_name() + " has no option \"" + option + '"' +
         text::suggestion(option, optionsOf(asked));
}

}  // namespace cutwater::tool
