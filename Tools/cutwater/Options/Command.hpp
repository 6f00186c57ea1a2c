#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name of CLI11
class App;
class Option;
}  // namespace CLI

// How commands and options are declared. CLI11 parses them, in Command.cpp and Program.cpp alone,
// as it takes long to compile.
namespace cutwater::tool {

/// An option that a command has.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required() const;
  Option excludes(Option other) const;
  Option needs(Option other) const;

 private:
  CLI::Option* option_;
};

/// Numbers that an option accepts, both ends included.
template <typename Number>
struct Range {
  Number least;
  Number most;
};

/// How many values may follow an option each time it is given.
enum class Values : std::uint8_t { One, Several };

/// A subcommand of a program. In all functions, `names` is as in "-o,--output", or as in "FILE" for
/// an argument that is no option; `value` is what help calls the value; variables that take a value
/// must outlive the program.
class Command {
 public:
  /// Takes an option's text, and throws UsageError if it is wrong.
  using Read = std::function<void(const std::string& text)>;

  explicit Command(CLI::App& app) : app_(&app) {}

  Option add(const std::string& names, const std::string& value, const std::string& meaning,
             const Read& read);
  /// Calls `read` as soon as the option is reached, each time that it is given: for options whose
  /// order counts.
  Option addInOrder(const std::string& names, const std::string& value, const std::string& meaning,
                    const Read& read);
  /// Calls `read` for each value, however often the option is given.
  Option addRepeated(const std::string& names, const std::string& value, const std::string& meaning,
                     const Read& read, Values values = Values::One);
  /// Its value may be left out, and is an empty text then.
  Option addOptional(const std::string& names, const std::string& value, const std::string& meaning,
                     const Read& read);
  Option addText(const std::string& names, const std::string& meaning, std::string& text);
  /// Some of the words, with commas between them.
  Option addWords(const std::string& names, const std::string& value, const std::string& meaning,
                  std::vector<std::string>& chosen, const std::vector<std::string>& words,
                  Values values = Values::One);
  Option addNumber(const std::string& names, const std::string& value, const std::string& meaning,
                   int& number, Range<int> range);
  Option addNumber(const std::string& names, const std::string& value, const std::string& meaning,
                   double& number, Range<double> range);
  void addFlag(const std::string& names, const std::string& meaning, bool& isGiven);
  void addFlag(const std::string& names, const std::string& meaning,
               const std::function<void()>& given);

  /// An option that was added.
  [[nodiscard]] Option option(const std::string& name) const;
  /// Whether the option is on the command line that was parsed.
  [[nodiscard]] bool isGiven(const std::string& option) const;

  /// Text below the help: examples.
  void setFooter(const std::string& text);
  /// What the command does, once its options are read.
  void setAction(const std::function<void()>& run);

 private:
  CLI::App* app_;
};

}  // namespace cutwater::tool
