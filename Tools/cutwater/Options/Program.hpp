#pragma once

#include <memory>
#include <optional>
#include <string>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// A program with subcommands, of which a command line names one.
class Program {
 public:
  /// `footer`: text below the help.
  Program(const std::string& name, const std::string& description, const std::string& footer);
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  /// Adds a subcommand.
  Command addCommand(const std::string& name, const std::string& description);
  /// Adds --help-all, the help of all subcommands.
  void addHelpForAll();
  /// Lets run() neither print help nor report wrong usage: for all ranks but one.
  void beSilent() { isSilent_ = true; }

  /// The help of the program or, while one runs, of its subcommand.
  [[nodiscard]] std::string help() const;

  /// Runs the subcommand that the command line names. Wrong usage is reported on stderr. Returns
  /// the exit status: 0, or that of Failure.hpp.
  /// @throws what the subcommand throws, but for UsageError.
  int run(int argc, const char* const* argv);

 private:
  int refuse(const std::string& message) const;
  /// If the command line names a subcommand or an option that there is not: says so, with the one
  /// that may be meant.
  [[nodiscard]] std::optional<std::string> unknownWord() const;

  std::unique_ptr<CLI::App> app_;
  bool isSilent_ = false;
};

}  // namespace cutwater::tool
