#include "Report/Failure.hpp"

#include <algorithm>
#include <iostream>

namespace cutwater::tool {

int failed(const std::string& program, std::string message, int status) {
  std::replace_if(
      message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
      ' ');
  std::cerr << program << ": error: " << message << '\n';
  return status;
}

}  // namespace cutwater::tool
