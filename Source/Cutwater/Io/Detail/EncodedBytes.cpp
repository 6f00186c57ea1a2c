#include <Cutwater/Io/Detail/EncodedBytes.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

constexpr std::uint8_t kNoDigit = 255;

/// The value of each character in base64.
constexpr std::array<std::uint8_t, 256> base64Digits() {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<std::uint8_t, 256> values{};
  for (auto& value : values) value = kNoDigit;
  std::uint8_t next = 0;
  for (const char c : kDigits) values[static_cast<unsigned char>(c)] = next++;
  return values;
}

constexpr auto kBase64 = base64Digits();

bool isBlankOrEnd(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

}  // namespace

std::uint64_t EncodedBytes::mostLeft() const {
  if (encoding_ == Encoding::Raw) return text_.size();
  return groupEnd_ - groupBegin_ + text_.size() / 4 * 3;
}

bool EncodedBytes::read(std::span<char> bytes) {
  if (encoding_ == Encoding::Base64) return readBase64(bytes);
  if (bytes.size() > text_.size()) return false;
  std::copy_n(text_.begin(), bytes.size(), bytes.begin());
  text_.remove_prefix(bytes.size());
  return true;
}

bool EncodedBytes::readBase64(std::span<char> bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    if (groupBegin_ == groupEnd_ && !nextGroup()) return false;
    const auto some = std::min(groupEnd_ - groupBegin_, bytes.size() - done);
    std::copy_n(group_.begin() + static_cast<std::ptrdiff_t>(groupBegin_), some,
                bytes.begin() + static_cast<std::ptrdiff_t>(done));
    groupBegin_ += some;
    done += some;
  }
  return true;
}

/// Four characters are three bytes; with one or two = at the end, two or one. Bits that belong to
/// none must be 0.
bool EncodedBytes::nextGroup() {
  std::uint32_t bits = 0;
  std::size_t padding = 0;
  for (int i = 0; i < 4; ++i) {
    skipBlanks();
    if (text_.empty()) return false;
    const char c = text_.front();
    text_.remove_prefix(1);
    const bool isPadding = c == '=' && i >= 2;
    const auto digit = isPadding ? std::uint8_t{0} : kBase64[static_cast<unsigned char>(c)];
    if (digit == kNoDigit || (padding > 0 && !isPadding)) return false;
    padding += isPadding ? 1 : 0;
    bits = bits << 6U | digit;
  }
  group_ = {static_cast<char>(bits >> 16U), static_cast<char>(bits >> 8U & 255U),
            static_cast<char>(bits & 255U)};
  groupBegin_ = 0;
  groupEnd_ = 3 - padding;
  const std::uint32_t unused = padding == 0 ? 0 : padding == 1 ? 0xffU : 0xffffU;
  return (bits & unused) == 0;
}

void EncodedBytes::skipBlanks() {
  while (!text_.empty() && isBlankOrEnd(text_.front())) text_.remove_prefix(1);
}

bool EncodedBytes::isAtEnd() {
  if (encoding_ == Encoding::Raw) return text_.empty();
  skipBlanks();
  return text_.empty() && groupBegin_ == groupEnd_;
}

}  // namespace cutwater::detail
