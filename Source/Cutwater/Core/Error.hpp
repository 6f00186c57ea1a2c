#pragma once

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace cutwater {

/// The kind of an error, so that a program can react without reading the message.
enum class ErrorKind {
  Argument,  ///< an argument is outside its documented range
  File,      ///< a file is missing, truncated, malformed, or cannot be written
  Topology,  ///< a surface lacks what the operation needs, e.g. is not closed
  Limit,     ///< a stated limit of size, memory or time is exceeded
};

/// The library's only exception. what() states in one line what is wrong, where, and which value.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message);

  [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

/// A value and its name in the error message.
template <typename V>
struct Named {
  const char* name;
  const V& value;
};
template <typename V>
Named(const char*, const V&) -> Named<V>;

namespace detail {

// The shortest text that reads back as the same number, in every locale.
std::string toText(double value);
std::string toText(long long value);

template <typename V>
std::string toText(const Named<V>& named) {
  const std::string name = std::string(named.name) + " = ";
  if constexpr (std::is_integral_v<V>) {
    return name + toText(static_cast<long long>(named.value));
  } else if constexpr (std::is_floating_point_v<V>) {
    return name + toText(static_cast<double>(named.value));
  } else {
    return name + "(" + toText(static_cast<double>(named.value[0])) + ", " +
           toText(static_cast<double>(named.value[1])) + ", " +
           toText(static_cast<double>(named.value[2])) + ")";
  }
}

[[noreturn]] void throwArgument(const char* message, std::initializer_list<std::string> values);

}  // namespace detail

/// Throws an Argument error unless `ok`: "Torus: need 0 < minor < major (minor = 2, major = 1)".
/// For constructors and set-up, never for queries. The text is built only when the error is thrown.
template <typename... Values>
void require(bool ok, const char* message, const Values&... values) {
  if (!ok) detail::throwArgument(message, {detail::toText(values)...});
}

}  // namespace cutwater
