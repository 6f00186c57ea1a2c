#include "Report/StepLine.hpp"

#include <iostream>
#include <unistd.h>

#include "Report/Format.hpp"

namespace cutwater::tool {

StepLine::StepLine(bool shown) : shown_(shown && isatty(STDERR_FILENO) == 1) {}

StepLine::~StepLine() {
  if (shown_) std::cerr << "\r\033[K" << std::flush;
}

void StepLine::show(const std::string& step) {
  if (shown_) std::cerr << '\r' << onOneLine(step) << " ...\033[K" << std::flush;
}

}  // namespace cutwater::tool
