#include "Report/Json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cutwater::tool {

/// Hands values to the library that writes them.
struct JsonWriter {
  using Written = nlohmann::ordered_json;

  static Written of(const Json& json) {
    return std::visit([](const auto& value) { return of(value); }, json.value_);
  }
  static Written of(const Json::Array& values) {
    auto result = Written::array();
    for (const auto& value : values) result.push_back(of(value));
    return result;
  }
  static Written of(const Json::Object& members) {
    auto result = Written::object();
    for (const auto& [key, value] : members) result[key] = of(value);
    return result;
  }
  template <typename Value>
  static Written of(const Value& value) {
    return value;
  }
};

Json::Json(std::initializer_list<Member> members) : value_(Object(members)) {}

Json Json::array(std::initializer_list<Json> values) {
  Json json;
  json.value_ = Array(values);
  return json;
}

void Json::push(Json value) {
  std::get<Array>(value_).push_back(std::move(value));
}

Json& Json::operator[](const std::string& key) {
  auto& members = std::get<Object>(value_);
  const auto found = std::ranges::find(members, key, &Member::key);
  if (found != members.end()) return found->value;
  return members.emplace_back(Member{key, nullptr}).value;
}

void Json::append(const Json& object) {
  for (const auto& [key, value] : std::get<Object>(object.value_)) (*this)[key] = value;
}

std::string Json::text() const {
  const auto written = JsonWriter::of(*this);
  return written.dump(2, ' ', false, JsonWriter::Written::error_handler_t::replace) + "\n";
}

}  // namespace cutwater::tool
