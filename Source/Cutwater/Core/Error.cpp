#include <Cutwater/Core/Error.hpp>

#include <charconv>
#include <system_error>

namespace cutwater {

Error::Error(ErrorKind kind, const std::string& message)
    : std::runtime_error(message), kind_(kind) {}

namespace detail {

namespace {

template <typename Number>
std::string shortest(Number value) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);  // locale-free
  return {buffer, result.ptr};
}

}  // namespace

void throwArgument(const char* message, std::initializer_list<std::string> values) {
  std::string text = message;
  const char* separator = " (";
  for (const auto& value : values) {
    text += separator + value;
    separator = ", ";
  }
  if (values.size() > 0) text += ")";
  throw Error(ErrorKind::Argument, text);
}

std::string toText(double value) {
  return shortest(value);
}
std::string toText(long long value) {
  return shortest(value);
}

}  // namespace detail
}  // namespace cutwater
