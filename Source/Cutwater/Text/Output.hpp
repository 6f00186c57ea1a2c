#pragma once

#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <string>

namespace cutwater::text {

/// Assembles text and numbers (little-endian unless stated otherwise) and passes them on in large
/// pieces.
class Output {
 public:
  explicit Output(OutputFile& file) : file_(file) {}

  Output& operator<<(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() > kPiece) flush();
    return *this;
  }
  Output& operator<<(char c) { return *this << std::string_view(&c, 1); }
  /// The shortest digits that read back as the same number.
  Output& operator<<(double value) { return digits(value); }
  Output& operator<<(std::uint64_t value) { return digits(value); }
  Output& operator<<(const Vec3<double>& p) { return *this << p.x << ' ' << p.y << ' ' << p.z; }

  /// A number of any type, as above.
  template <typename Number>
  void decimal(Number value) {
    digits(value);
  }

  /// The number's bytes.
  template <typename Number>
  void binary(Number value) {
    static_assert(std::endian::native == std::endian::little);
    *this << std::string_view(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  template <typename Number>
  void binaryBigEndian(Number value) {
    char bytes[sizeof(value)];
    std::memcpy(bytes, &value, sizeof(value));
    std::reverse(bytes, bytes + sizeof(value));
    *this << std::string_view(bytes, sizeof(value));
  }

  /// Passes on what is left. Nothing does so by itself.
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 16U;

  template <typename Number>
  Output& digits(Number value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    return *this << std::string_view(text, static_cast<std::size_t>(end - text));
  }

  OutputFile& file_;
  std::string buffer_;
};

}  // namespace cutwater::text
