#pragma once

#include <functional>
#include <optional>
#include <string>

#include "Options/Command.hpp"

// What a command may take of the machine, and what it is expected to take, told before the work.
namespace cutwater::tool {

/// How much work may be done, see addLimits().
struct Limits {
  std::optional<double> items;  ///< cells, nodes or pixels
  std::optional<double> bytes;  ///< without it: three quarters of the machine's memory

  [[nodiscard]] double mostBytes() const;
};

/// Work that is about to be done.
struct Expected {
  std::string what;      ///< as in "cells": what there are so many of
  double items = 0;      ///< of them
  double bytes = 0;      ///< memory
  double seconds = -1;   ///< negative: not known
  bool isExact = false;  ///< the number of items, and the memory that they take
};

/// Adds `option`, as "--max-cells" if the work is counted in cells, and --max-memory. `limits` must
/// outlive the command.
void addLimits(Command command, const std::string& option, Limits& limits);

/// What is said before the work: "about 1 234 000 cells, 0.2 GB of memory, 12 s".
[[nodiscard]] std::string text(const Expected& expected);

/// Says on stderr, if that is a terminal and `isShown`, what is expected.
/// @param remedy  what would fit, as in "--level 9 fits, with ..."; asked for only if the work does
/// not.
/// @throws Error(Limit) if it is beyond the limits.
void requireWithin(const Limits& limits, const Expected& expected, bool isShown,
                   const std::function<std::string()>& remedy);

}  // namespace cutwater::tool
