#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace cutwater::tool {

// Exit statuses, as documented by --help.
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;

/// Reports the failure on stderr, on a single line, whatever characters a file name contains.
/// Returns the status.
int failed(const std::string& program, std::string message, int status);
/// The same for wrong usage. Names a command that there is not, and the one that may be meant.
int failed(const CLI::App& program, const CLI::ParseError& error);

}  // namespace cutwater::tool
