#include "Options/Limits.hpp"

#include <Cutwater/Core/Error.hpp>

#include <array>
#include <cmath>
#include <iostream>
#include <unistd.h>
#include <utility>

#include "Options/Arguments.hpp"
#include "Options/MachineMemory.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

/// "8G", "500M", "2.5e9": bytes.
double bytesOf(const std::string& option, const std::string& text) {
  constexpr const char* kNeed = "a size above 0, in bytes or with k, M, G or T: 8G";
  constexpr std::array<std::pair<char, double>, 4> kUnits = {
      {{'k', 1e3}, {'M', 1e6}, {'G', 1e9}, {'T', 1e12}}};
  for (const auto& [letter, factor] : kUnits) {
    if (!text.ends_with(letter)) continue;
    return factor * positiveNumber(option, text.substr(0, text.size() - 1), kNeed);
  }
  return positiveNumber(option, text, kNeed);
}

/// A number of things as people read it: an estimate has no more than three digits.
std::string countOf(double count, bool isExact) {
  constexpr double kMostGrouped = 1e15;
  if (count > kMostGrouped) return number(count, 3);
  return grouped(static_cast<std::size_t>(isExact ? count : rounded(count, 3)));
}

}  // namespace

double Limits::mostBytes() const {
  return bytes.value_or(0.75 * static_cast<double>(memoryOfMachine()));
}

void addLimits(Command command, const std::string& option, Limits& limits) {
  const auto what = option.substr(std::string("--max-").size());
  command.add(
      option, "N", "Refuse the work before it begins if it would take more " + what + " than this",
      [option, &limits](const std::string& text) { limits.items = positiveNumber(option, text); });
  command.add("--max-memory", "SIZE",
              "Refuse it if it would take more memory than this, such as 8G [default: three "
              "quarters of what there is]",
              [&limits](const std::string& text) { limits.bytes = bytesOf("--max-memory", text); });
}

std::string text(const Expected& expected) {
  std::string result = expected.isExact ? "" : "about ";
  result += countOf(expected.items, expected.isExact) + " " + expected.what + ", " +
            bytes(static_cast<std::size_t>(expected.bytes)) + " of memory";
  if (expected.seconds >= 0) result += ", " + roughDuration(expected.seconds);
  return result;
}

void requireWithin(const Limits& limits, const Expected& expected, bool isShown,
                   const std::function<std::string()>& remedy) {
  const double most = limits.mostBytes();
  std::string why;
  if (limits.items && expected.items > *limits.items) {
    why = "--max-" + expected.what + " allows " + countOf(*limits.items, true);
  } else if (expected.bytes > most) {
    why = limits.bytes ? "--max-memory allows " : "three quarters of the memory here are ";
    why += bytes(static_cast<std::size_t>(most));
    if (!limits.bytes) why += ", and --max-memory allows more";
  }
  if (!why.empty()) {
    throw Error(ErrorKind::Limit,
                "this would take " + text(expected) + "; " + why + "; " + remedy());
  }
  if (isShown && isatty(STDERR_FILENO) == 1) std::cerr << text(expected) << '\n';
}

}  // namespace cutwater::tool
