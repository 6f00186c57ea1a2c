#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

namespace cutwater::tool {

/// A JSON value. Keys stay in the order in which they are written. The library that writes it takes
/// long to compile, so Json.cpp alone includes it.
class Json {
 public:
  /// A key of an object, and its value.
  struct Member;
  using Array = std::vector<Json>;
  struct Object {
    std::vector<std::string> keys;
    std::vector<Json> values;
  };

  // NOLINTBEGIN(google-explicit-constructor): values are written as they are
  Json(std::nullptr_t = nullptr) {}
  Json(bool value) : value_(value) {}
  Json(std::signed_integral auto value) : value_(std::int64_t{value}) {}
  Json(std::unsigned_integral auto value) : value_(std::uint64_t{value}) {}
  Json(double value) : value_(value) {}
  Json(const char* text) : value_(std::string(text)) {}
  Json(std::string text) : value_(std::move(text)) {}
  template <typename Value>
  Json(const std::vector<Value>& values) : value_(Array(values.begin(), values.end())) {}
  /// An object.
  Json(std::initializer_list<Member> members);
  // NOLINTEND(google-explicit-constructor)

  static Json array(std::initializer_list<Json> values = {});

  /// Appends to an array.
  void push(Json value);
  /// The member of an object, which is appended if there is none of this key.
  Json& operator[](const std::string& key);
  /// Appends the members of another object.
  void append(const Json& object);

  /// As text that ends with '\n'. Bytes that are not UTF-8, in names of files and patches, are
  /// replaced.
  [[nodiscard]] std::string text() const;

 private:
  friend struct JsonWriter;

  std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Array,
               Object>
      value_ = nullptr;
};

struct Json::Member {
  std::string key;
  Json value;
};

}  // namespace cutwater::tool
