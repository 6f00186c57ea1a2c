#include <Cutwater/Text/ByteCursor.hpp>

#include <cassert>

namespace cutwater::text {

namespace {

// Calls visit(Number{}) with the C++ type of `type`.
template <typename Visit>
auto withType(ScalarType type, Visit visit) {
  switch (type) {
    case ScalarType::Int8:
      return visit(std::int8_t{});
    case ScalarType::UInt8:
      return visit(std::uint8_t{});
    case ScalarType::Int16:
      return visit(std::int16_t{});
    case ScalarType::UInt16:
      return visit(std::uint16_t{});
    case ScalarType::Int32:
      return visit(std::int32_t{});
    case ScalarType::UInt32:
      return visit(std::uint32_t{});
    case ScalarType::Int64:
      return visit(std::int64_t{});
    case ScalarType::UInt64:
      return visit(std::uint64_t{});
    case ScalarType::Float32:
      return visit(float{});
    case ScalarType::Float64:
      break;
  }
  return visit(double{});
}

}  // namespace

std::uint64_t sizeOf(ScalarType type) {
  return withType(type, [](auto number) { return std::uint64_t{sizeof(number)}; });
}

bool isInteger(ScalarType type) {
  return type != ScalarType::Float32 && type != ScalarType::Float64;
}

void ByteCursor::seek(std::uint64_t position) {
  assert(position <= bytes().size());
  moveTo(position);
  beginRecord();
}

void ByteCursor::skip(std::uint64_t count) {
  if (count > bytesLeft()) fail("the file ends too early");
  moveTo(position() + count);
}

double ByteCursor::number(ScalarType type) {
  return withType(
      type, [this](auto number) { return static_cast<double>(this->read<decltype(number)>()); });
}

std::int64_t ByteCursor::integer(ScalarType type) {
  assert(isInteger(type));
  if (type == ScalarType::UInt64) {
    const auto value = read<std::uint64_t>();
    if (value > INT64_MAX) fail(std::to_string(value) + " is out of range");
    return static_cast<std::int64_t>(value);
  }
  return withType(type, [this](auto number) {
    return static_cast<std::int64_t>(this->read<decltype(number)>());
  });
}

void ByteCursor::requireOnlyPadding() {
  const auto behind =
      bytes().substr(position()).find_first_not_of(std::string_view("\0 \t\r\n", 5));
  if (behind == std::string_view::npos) return;
  seek(position() + behind);
  fail("data behind the last element: a count in the header is too small");
}

}  // namespace cutwater::text
