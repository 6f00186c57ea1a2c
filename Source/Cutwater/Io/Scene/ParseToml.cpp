#include <Cutwater/Io/Scene/ParseToml.hpp>

#ifdef CUTWATER_HAS_TOML
#include <stdexcept>

namespace cutwater::scene {
namespace {

[[noreturn]] void giveUp(const char* broken) {
  throw std::logic_error(broken);
}

}  // namespace
}  // namespace cutwater::scene

// The parser asserts what some bytes break ("[ }"), or, where assertions are off, relies on it.
#undef NDEBUG
#define TOML_ASSERT(expr) ((expr) ? static_cast<void>(0) : cutwater::scene::giveUp(#expr))
#define TOML_HEADER_ONLY 1  // nothing to link for users
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>
#endif

#include <algorithm>
#include <tuple>

namespace cutwater::scene {

void failAt(const std::string& file, std::uint64_t line, const std::string& message) {
  throw SceneError(file + ": line " + std::to_string(line) + ": " + message);
}

#ifdef CUTWATER_HAS_TOML

namespace {

constexpr int kMostNested = 8;  // a solid is a table of lists of lists of points
constexpr std::size_t kMostDots = 16;

/// Whether a dot parts the digits of one number.
bool isDecimalPoint(std::string_view line, std::size_t dot) {
  constexpr std::string_view kDigits = "0123456789_";
  const auto before = line.substr(0, dot);
  const auto after = line.substr(dot + 1);
  const auto left = before.find_last_not_of(kDigits) + 1;  // 0 where all are digits
  const auto right = std::min(after.find_first_not_of(kDigits), after.size());
  return left < dot && right > 0 && (left == 0 || before[left - 1] != '.') &&
         (right == after.size() || after[right] != '.');
}

/// A key "a.b.c" makes the parser nest tables, and their destructors call each other: a million
/// dots would take all of the stack. A key stands in one line, and scenes have none of these.
void requireFewDots(std::string_view text, const std::string& file) {
  for (std::uint64_t number = 1; !text.empty(); ++number) {
    const auto line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const auto start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos || line[start] == '#') continue;
    std::size_t dots = 0;
    for (auto at = line.find('.'); at != std::string_view::npos; at = line.find('.', at + 1)) {
      if (!isDecimalPoint(line, at)) ++dots;
    }
    if (dots > kMostDots) failAt(file, number, "more than 16 dots that are no decimal points");
  }
}

bool isBeyondAscii(std::string_view text, std::size_t at) {
  return at < text.size() && static_cast<unsigned char>(text[at]) >= 0x80;
}

/// What ends the string that begins with these bytes: one quote or three.
std::string_view quotesAt(std::string_view text) {
  const bool isTriple = text.size() > 2 && text[1] == text[0] && text[2] == text[0];
  return text.substr(0, isTriple ? 3 : 1);
}

/// TOML has characters beyond ASCII in strings and comments only. Elsewhere, and behind a
/// backslash, the parser asks whether they are white space, and takes most of them for impossible.
void requireAsciiOutsideStrings(std::string_view text, const std::string& file) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::uint64_t line = 1;
  std::string_view quotes;  // of the string around; none: in none
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool isEscape = c == '\\' && quotes.starts_with('"');
    // A backslash takes away the white space behind it, and the parser looks at what follows.
    const std::size_t asked = isEscape ? text.find_first_not_of(" \t\r\n", at + 1) : at;
    if ((quotes.empty() || isEscape) && isBeyondAscii(text, asked)) {
      failAt(file, line,
             "characters beyond ASCII need quotes around them, and no backslash before");
    }
    if (c == '\n') {
      ++line;
      if (quotes.size() == 1) quotes = {};  // the parser refuses it
    } else if (isEscape) {
      if (asked == at + 1) at = asked;
    } else if (!quotes.empty()) {
      if (!text.substr(at).starts_with(quotes)) continue;
      // Behind three, two more would be the last of what is in the string.
      const auto behind = std::min(text.find_first_not_of(c, at), at + 2 * quotes.size() - 1);
      at = std::min(behind, text.size()) - 1;
      quotes = {};
    } else if (c == '#') {
      at = std::min(text.find('\n', at), text.size()) - 1;
    } else if (c == '"' || c == '\'') {
      quotes = quotesAt(text.substr(at));
      at += quotes.size() - 1;
    }
  }
}

/// Into values of ours, level by level.
class Conversion {
 public:
  explicit Conversion(const std::string& file) : file_(file) {}

  [[nodiscard]] SceneValue::Table table(const toml::table& from, int depth) const {
    using Position = toml::source_position;
    std::vector<std::tuple<Position, const toml::key*, const toml::node*>> entries;
    for (auto&& [key, node] : from) entries.emplace_back(key.source().begin, &key, &node);
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
      return std::get<Position>(a) < std::get<Position>(b);
    });
    SceneValue::Table result;
    for (const auto& [position, key, node] : entries) {
      result.push_back({std::string(key->str()), position.line, value(*node, depth)});
    }
    return result;
  }

 private:
  [[nodiscard]] SceneValue value(const toml::node& node, int depth) const {
    const std::uint64_t line = node.source().begin.line;
    if (depth == kMostNested) failAt(file_, line, "lists and tables are nested too deeply");
    if (const auto* flag = node.as_boolean()) return {flag->get(), line};
    if (const auto* text = node.as_string()) return {text->get(), line};
    if (const auto* real = node.as_floating_point()) return {real->get(), line};
    if (const auto* whole = node.as_integer()) return {number(whole->get(), line), line};
    if (const auto* below = node.as_table()) return {table(*below, depth + 1), line};
    const auto* const array = node.as_array();
    if (array == nullptr) failAt(file_, line, "a scene has no dates");
    SceneValue::List list;
    for (const auto& element : *array) list.push_back(value(element, depth + 1));
    return {std::move(list), line};
  }

  [[nodiscard]] double number(std::int64_t whole, std::uint64_t line) const {
    constexpr std::int64_t kMost = std::int64_t{1} << 53U;
    if (whole < -kMost || kMost < whole) failAt(file_, line, "whole numbers end at 2^53");
    return static_cast<double>(whole);
  }

  const std::string& file_;
};

}  // namespace

SceneValue::Table parseToml(std::string_view text, const std::string& file) {
  requireFewDots(text, file);
  requireAsciiOutsideStrings(text, file);
  try {
    return Conversion(file).table(toml::parse(text), 0);
  } catch (const toml::parse_error& error) {
    std::string message(error.description());
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; },
        ' ');
    failAt(file, error.source().begin.line, message);
  } catch (const std::logic_error&) {
    throw SceneError(file + ": is no TOML: a value, or what parts values, is missing somewhere");
  }
}

#else

SceneValue::Table parseToml(std::string_view /*text*/, const std::string& file) {
  throw Error(ErrorKind::File, file + ": scenes are not supported: built without toml++");
}

#endif

}  // namespace cutwater::scene
