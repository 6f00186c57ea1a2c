#pragma once

#include <string>

namespace cutwater::tool {

// Exit statuses; also told by --help.
inline constexpr int kFailed = 1;
inline constexpr int kUsage = 2;

/// Says so on stderr, in one line, whatever a file's name may hold. Returns the status.
int failed(const std::string& program, std::string message, int status);

}  // namespace cutwater::tool
