#pragma once

#include <string>

namespace cutwater::tool {

// Exit statuses, as documented by --help.
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;

/// Reports the failure on stderr, on a single line, whatever characters a file name contains.
/// Returns the status.
int failed(const std::string& program, const std::string& message, int status);

}  // namespace cutwater::tool
