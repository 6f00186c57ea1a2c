#pragma once

#include <stdexcept>
#include <string>

namespace cutwater::tool {

/// A command line that is wrong. what() names the option, and says what is wrong with it.
class UsageError : public std::runtime_error {
 public:
  UsageError(const std::string& option, const std::string& message)
      : std::runtime_error(option + ": " + message) {}
};

}  // namespace cutwater::tool
