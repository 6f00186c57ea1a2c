#include "Report/Failure.hpp"

#include <iostream>

#include "Report/Format.hpp"

namespace cutwater::tool {

int failed(const std::string& program, const std::string& message, int status) {
  std::cerr << program << ": error: " << onOneLine(message) << '\n';
  return status;
}

}  // namespace cutwater::tool
