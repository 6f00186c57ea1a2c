#include "Report/Format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace cutwater::tool {

namespace {

/// As shells quote control characters: $'a\nb'.
std::string inDollarQuotes(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\' || c == '\'') escaped += '\\';
    escaped += c;
  }
  return "$'" + onOneLine(escaped) + "'";
}

}  // namespace

std::string extent(const Vec3<double>& size) {
  return number(size.x) + " x " + number(size.y) + " x " + number(size.z);
}

std::string bytes(std::size_t count) {
  if (count < 1000) return std::to_string(count) + " B";
  double value = static_cast<double>(count);
  for (const char* unit : {" kB", " MB", " GB"}) {
    value /= 1000;
    if (value < 999.5) return number(value, 3) + unit;
  }
  return number(value / 1000, 3) + " TB";
}

std::string duration(double seconds) {
  if (seconds >= 99.5) {
    const auto whole = static_cast<std::size_t>(std::lround(seconds));
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  }
  if (seconds >= 0.9995) return number(seconds, 3) + " s";
  if (seconds >= 0.9995e-3) return number(seconds * 1e3, 3) + " ms";
  return number(seconds * 1e6, 3) + " us";
}

std::string roughDuration(double seconds) {
  constexpr double kHour = 3600;
  constexpr double kDay = 24 * kHour;
  if (seconds > 2 * kHour && seconds <= kDay) return "about " + number(seconds / kHour, 2) + " h";
  return seconds > kDay ? "more than a day" : "about " + duration(rounded(seconds, 2));
}

std::string hexadecimal(std::uint64_t value) {
  constexpr std::size_t kDigits = 16;
  std::array<char, kDigits> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + kDigits, value, 16).ptr;
  const auto count = static_cast<std::size_t>(end - digits.data());
  return std::string(kDigits - count, '0').append(digits.data(), count);
}

std::string onOneLine(std::string_view text) {
  constexpr std::array<std::pair<char, char>, 3> kLetters = {
      {{'\n', 'n'}, {'\r', 'r'}, {'\t', 't'}}};
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    const auto* const letter = std::ranges::find(kLetters, c, &std::pair<char, char>::first);
    if (letter != kLetters.end()) {
      result += {'\\', letter->second};
    } else if (code < ' ' || c == '\x7f') {
      result += {'\\', static_cast<char>('0' + code / 64), static_cast<char>('0' + code / 8 % 8),
                 static_cast<char>('0' + code % 8)};
    } else {
      result += c;
    }
  }
  return result;
}

std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:%@";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  if (onOneLine(text) != text) return inDollarQuotes(text);
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string fileWord(const std::string& file) {
  return shellWord(file.starts_with('-') ? "./" + file : file);
}

std::string leftAligned(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

std::string rightAligned(std::string_view text, std::size_t width) {
  return std::string(width > text.size() ? width - text.size() : 0, ' ') + std::string(text);
}

}  // namespace cutwater::tool
