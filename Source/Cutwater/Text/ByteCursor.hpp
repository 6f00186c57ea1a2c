#pragma once

#include <Cutwater/Text/Cursor.hpp>

#include <bit>
#include <cstring>
#include <utility>

namespace cutwater::text {

/// The number types of PLY and VTK.
enum class ScalarType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

[[nodiscard]] std::uint64_t sizeOf(ScalarType type);
[[nodiscard]] bool isInteger(ScalarType type);

/// Reads binary numbers of either byte order, never beyond the end of the file.
class ByteCursor final : public Cursor {
 public:
  ByteCursor(const Content& content, std::endian order) : Cursor(content), order_(order) {}

  /// Messages name the first byte of the current record.
  Place place() const override { return {Place::Unit::Byte, record_}; }
  void beginRecord() { record_ = position(); }

  /// Goes to the position and begins a record there.
  void seek(std::uint64_t position);
  void skip(std::uint64_t count);

  template <typename Number>
  Number read() {
    if (bytesLeft() < sizeof(Number)) fail("the file ends too early");
    char raw[sizeof(Number)];
    std::memcpy(raw, bytes().data() + position(), sizeof(Number));
    moveTo(position() + sizeof(Number));
    if (order_ != std::endian::native) reverse(raw);
    return std::bit_cast<Number>(raw);
  }

  double number(ScalarType type);
  /// Fails if the value does not fit; `type` must be an integer type.
  std::int64_t integer(ScalarType type);

  /// Checks bytes behind the data: padding is fine, anything else means that a count is too small.
  void requireOnlyPadding();

 private:
  template <std::size_t size>
  static void reverse(char (&raw)[size]) {
    for (std::size_t i = 0; i < size / 2; ++i) std::swap(raw[i], raw[size - 1 - i]);
  }

  std::endian order_;
  std::uint64_t record_ = 0;
};

}  // namespace cutwater::text
