#include <Cutwater/Text/TextCursor.hpp>
#include <Cutwater/Text/Words.hpp>

#include <algorithm>
#include <charconv>
#include <system_error>

namespace cutwater::text {

namespace {

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool endsLine(char c) {
  return c == '\n' || c == '\r' || c == '\0';
}

// from_chars rejects a leading plus, which printf("%+g") and Fortran write.
std::string_view withoutPlus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return plus ? word.substr(1) : word;
}

}  // namespace

template <typename Number>
Number numberOf(const Cursor& at, std::string_view word) {
  const std::string what = std::is_floating_point_v<Number> ? "a number" : "an integer";
  if (word.empty()) at.fail(what + " is missing at the end of the line");
  const std::string_view digits = withoutPlus(word);
  const char* const end = digits.data() + digits.size();
  Number value{};
  const auto result = std::from_chars(digits.data(), end, value);
  if (result.ec == std::errc::result_out_of_range && result.ptr == end) {
    at.fail(inQuotes(word) + " is out of range");
  }
  if (result.ec != std::errc{} || result.ptr != end) {
    at.fail("expected " + what + ", found " + inQuotes(word));
  }
  return value;
}

template std::int8_t numberOf(const Cursor&, std::string_view);
template std::uint8_t numberOf(const Cursor&, std::string_view);
template std::int16_t numberOf(const Cursor&, std::string_view);
template std::uint16_t numberOf(const Cursor&, std::string_view);
template std::int32_t numberOf(const Cursor&, std::string_view);
template std::uint32_t numberOf(const Cursor&, std::string_view);
template std::int64_t numberOf(const Cursor&, std::string_view);
template std::uint64_t numberOf(const Cursor&, std::string_view);
template float numberOf(const Cursor&, std::string_view);
template double numberOf(const Cursor&, std::string_view);

Place TextCursor::place() const {
  return {unit_, unit_ == Place::Unit::Line ? std::max<std::uint64_t>(line_, 1) : position()};
}

std::string TextCursor::remark() const {
  const std::string_view text = bytes();
  const bool endsWithinLine = !text.empty() && text.back() != '\n' && text.back() != '\r';
  return endsWithinLine && position() == text.size() ? "; the file ends here, within a line" : "";
}

std::uint64_t TextCursor::findLineEnd(std::uint64_t begin) const {
  const std::string_view text = bytes();
  const auto limit = std::min<std::uint64_t>(text.size(), begin + longestLine_ + 1);
  std::uint64_t end = begin;
  while (end < limit && !endsLine(text[end])) ++end;
  if (end - begin > longestLine_) fail("the line is longer than 64 kB");
  if (end < text.size() && text[end] == '\0') fail("a NUL byte in text");
  return end;
}

bool TextCursor::nextLine() {
  moveTo(next_);
  lineEnd_ = next_;
  continued_ = false;
  if (next_ >= bytes().size()) return false;
  ++line_;
  lineEnd_ = findLineEnd(next_);
  next_ = lineEnd_;
  skipTerminator();
  if (rules_.continuation && lineEnd_ > position() && bytes()[lineEnd_ - 1] == '\\') {
    continued_ = true;
    --lineEnd_;
  }
  return true;
}

void TextCursor::skipTerminator() {
  const std::string_view text = bytes();
  if (next_ >= text.size()) return;
  const bool carriageReturn = text[next_++] == '\r';
  const bool lineFeedFollows = next_ < text.size() && text[next_] == '\n';
  if (line_ == 1) loneReturns_ = carriageReturn && !lineFeedFollows;
  if (carriageReturn && lineFeedFollows && !loneReturns_) ++next_;
}

bool TextCursor::nextFilledLine() {
  while (nextLine()) {
    skipBlanks();
    const bool comment =
        rules_.comments != Comments::None && position() < lineEnd_ && bytes()[position()] == '#';
    if (position() < lineEnd_ && !comment) return true;
  }
  return false;
}

void TextCursor::seek(std::uint64_t position) {
  moveTo(position);
  lineEnd_ = next_ = position;
  continued_ = false;
}

void TextCursor::skipBlanks() {
  const std::string_view text = bytes();
  std::uint64_t to = position();
  while (to < lineEnd_ && isBlank(text[to])) ++to;
  moveTo(to);
}

std::string_view TextCursor::word() {
  skipBlanks();
  while (position() == lineEnd_ && continued_) {
    if (!nextLine()) return {};
    skipBlanks();
  }
  const std::string_view text = bytes();
  const std::uint64_t begin = position();
  if (begin == lineEnd_) return {};
  if (rules_.comments != Comments::None && text[begin] == '#') {
    moveTo(lineEnd_);
    continued_ = false;
    return {};
  }
  const char stop = rules_.comments == Comments::Anywhere ? '#' : ' ';
  std::uint64_t end = begin;
  while (end < lineEnd_ && !isBlank(text[end]) && text[end] != stop) ++end;
  moveTo(end);
  return text.substr(begin, end - begin);
}

std::string_view TextCursor::wordOfFileOrNone() {
  for (;;) {
    const auto found = word();
    if (!found.empty() || !nextLine()) return found;
  }
}

std::string_view TextCursor::wordOfFile() {
  const auto found = wordOfFileOrNone();
  if (found.empty()) fail("the file ends too early");
  return found;
}

std::string_view TextCursor::rest() {
  skipBlanks();
  auto text = bytes().substr(position(), lineEnd_ - position());
  while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
  moveTo(lineEnd_);
  return text;
}

void TextCursor::skipLine() {
  while (continued_ && nextLine()) {
  }
  moveTo(lineEnd_);
}

double TextCursor::toNumber(std::string_view word) const {
  return numberOf<double>(*this, word);
}

std::int64_t TextCursor::toInteger(std::string_view word) const {
  return numberOf<std::int64_t>(*this, word);
}

void TextCursor::skipNumbers() {
  for (auto value = word(); !value.empty(); value = word()) static_cast<void>(toNumber(value));
}

void TextCursor::requireLineEnd() {
  const auto extra = word();
  if (!extra.empty()) fail("expected the end of the line, found " + inQuotes(extra));
}

std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

}  // namespace cutwater::text
