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
    for (std::size_t i = 0; i < members.keys.size(); ++i) {
      result[members.keys[i]] = of(members.values[i]);
    }
    return result;
  }
  template <typename Value>
  static Written of(const Value& value) {
    return value;
  }
};

Json::Json(std::initializer_list<Member> members) : value_(Object{}) {
  for (const auto& [key, value] : members) (*this)[key] = value;
}

Json Json::array(std::initializer_list<Json> values) {
  Json json;
  json.value_ = Array(values);
  return json;
}

void Json::push(Json value) {
  std::get<Array>(value_).push_back(std::move(value));
}

Json& Json::operator[](const std::string& key) {
  auto& [keys, values] = std::get<Object>(value_);
  const auto found = std::ranges::find(keys, key);
  if (found != keys.end()) return values[static_cast<std::size_t>(found - keys.begin())];
  keys.push_back(key);
  return values.emplace_back();
}

void Json::append(const Json& object) {
  const auto& [keys, values] = std::get<Object>(object.value_);
  for (std::size_t i = 0; i < keys.size(); ++i) (*this)[keys[i]] = values[i];
}

std::string Json::text() const {
  const auto written = JsonWriter::of(*this);
  return written.dump(2, ' ', false, JsonWriter::Written::error_handler_t::replace) + "\n";
}

}  // namespace cutwater::tool
