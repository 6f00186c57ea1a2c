#pragma once

#include <iosfwd>

#include "Report.hpp"

namespace cutwater::benchmarks {

/// The report as Markdown.
void printTables(const Report& report, std::ostream& out);

}  // namespace cutwater::benchmarks
