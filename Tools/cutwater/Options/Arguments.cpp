#include "Options/Arguments.hpp"

#include <Cutwater/Text/Suggestion.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "Options/UsageError.hpp"
#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return {};
  return value;
}

template <typename Number, typename Accept>
std::vector<Number> list(std::string_view text, char separator, Accept accept) {
  std::vector<Number> values;
  for (;;) {
    const auto end = text.find(separator);
    const auto value = parsed<Number>(text.substr(0, end));
    if (!value || !accept(*value)) return {};
    values.push_back(*value);
    if (end == std::string_view::npos) return values;
    text.remove_prefix(end + 1);
  }
}

}  // namespace

void refuse(const std::string& option, const std::string& text, const std::string& need) {
  throw UsageError(option, "'" + text + "': need " + need);
}

std::vector<double> numbers(const std::string& option, const std::string& text,
                            const std::string& need) {
  auto values = list<double>(text, ',', [](double v) { return std::isfinite(v); });
  if (values.empty()) refuse(option, text, need);
  return values;
}

std::vector<double> numbers(const std::string& option, const std::string& text, std::size_t count) {
  const auto need =
      count == 1 ? "a number" : std::to_string(count) + " numbers with commas between them";
  auto values = numbers(option, text, need);
  if (values.size() != count) refuse(option, text, need);
  return values;
}

double positiveNumber(const std::string& option, const std::string& text, const std::string& need) {
  const auto values = numbers(option, text, need);
  if (values.size() != 1 || values[0] <= 0) refuse(option, text, need);
  return values[0];
}

double angleOf(const std::string& option, const std::string& text) {
  constexpr const char* kNeed = "degrees above 0 and below 180";
  const double degrees = positiveNumber(option, text, kNeed);
  if (degrees >= 180) refuse(option, text, kNeed);
  return degrees;
}

Vec3<double> vectorOf(const std::string& option, const std::string& text) {
  const auto values = numbers(option, text, 3);
  return {values[0], values[1], values[2]};
}

Box<double> boxOf(const std::string& option, const std::string& text) {
  const auto v = numbers(option, text, 6);
  const Box<double> box{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  const auto size = box.size();
  if (!(size.x > 0 && size.y > 0 && size.z > 0)) {
    refuse(option, text, "the lower corner and then the upper one");
  }
  return box;
}

std::vector<std::int32_t> sizes(const std::string& option, const std::string& text,
                                const std::string& need) {
  constexpr auto kMost = std::numeric_limits<std::int32_t>::max() - 1;  // fits a grid's nodes
  auto values = list<std::int32_t>(text, 'x', [](std::int32_t v) { return 1 <= v && v < kMost; });
  if (values.empty()) refuse(option, text, need);
  return values;
}

int axisOf(const std::string& option, const std::string& text) {
  if (text == "x") return 0;
  if (text == "y") return 1;
  if (text == "z") return 2;
  refuse(option, text, "x, y or z");
}

std::size_t choiceOf(const std::string& option, const std::string& text,
                     const std::vector<std::string>& choices) {
  const auto found = std::ranges::find(choices, text);
  if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
  refuse(option, text, "one of " + listed(choices) + text::suggestion(text, choices));
}

}  // namespace cutwater::tool
