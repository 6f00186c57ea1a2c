#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace cutwater::detail {

/// Bytes that stand raw in a file, or in base64 (RFC 4648), read one after the other. In base64,
/// blanks and line ends may stand anywhere, and padding may end any group of four characters: what
/// was encoded in pieces reads as one.
class EncodedBytes {
 public:
  enum class Encoding : std::uint8_t { Raw, Base64 };

  EncodedBytes(std::string_view text, Encoding encoding) : text_(text), encoding_(encoding) {}

  /// How many bytes are left at most; exactly, if they stand raw.
  [[nodiscard]] std::uint64_t mostLeft() const;
  /// Reads as many bytes; returns false if the text ends before, or is no base64.
  bool read(std::span<char> bytes);
  /// Whether nothing is left but blanks.
  bool isAtEnd();

 private:
  bool readBase64(std::span<char> bytes);
  bool nextGroup();
  void skipBlanks();

  std::string_view text_;  // what is left of it
  Encoding encoding_;
  // Of the last group of base64, bytes that have not been read yet.
  std::array<char, 3> group_{};
  std::size_t groupBegin_ = 0;
  std::size_t groupEnd_ = 0;
};

}  // namespace cutwater::detail
