#pragma once

#include <string>
#include <string_view>

namespace cutwater::text {

/// A line of a report: a name, and its value in a column of its own.
inline std::string reportLine(std::string_view name, const std::string& value) {
  constexpr std::size_t kColumn = 40;
  std::string result(name);
  result.append(result.size() < kColumn ? kColumn - result.size() : 1, ' ');
  return result + value + "\n";
}

}  // namespace cutwater::text
