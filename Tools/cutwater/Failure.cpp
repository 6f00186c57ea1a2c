#include "Failure.hpp"

#include <Cutwater/Text/Suggestion.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <vector>

namespace cutwater::tool {

int failed(const std::string& program, std::string message, int status) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
      ' ');
  std::cerr << program << ": error: " << message << '\n';
  return status;
}

int failed(const CLI::App& program, const CLI::ParseError& error) {
  const auto rest = program.remaining();
  const bool isUnknown =
      program.get_subcommands().empty() && !rest.empty() && !rest.front().starts_with('-');
  if (!isUnknown) return failed(program.get_name(), error.what(), kUsage);
  std::vector<std::string> commands;
  for (const auto* command : program.get_subcommands({})) commands.push_back(command->get_name());
  return failed(
      program.get_name(),
      "there is no command \"" + rest.front() + '"' + text::suggestion(rest.front(), commands),
      kUsage);
}

}  // namespace cutwater::tool
