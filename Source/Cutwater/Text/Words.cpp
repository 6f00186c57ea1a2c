#include <Cutwater/Text/Words.hpp>

#include <algorithm>

namespace cutwater::text {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

bool equalIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

bool isPrintable(char c) {
  return static_cast<unsigned char>(c) >= ' ' && c != '\x7f';
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result;
  for (const char c : text.substr(0, kLongest)) result += isPrintable(c) ? c : '?';
  return result + (text.size() > kLongest ? "..." : "");
}

std::string inQuotes(std::string_view text) {
  return '"' + shortened(text) + '"';
}

}  // namespace cutwater::text
