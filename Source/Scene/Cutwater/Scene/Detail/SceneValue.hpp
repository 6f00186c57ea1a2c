#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace cutwater::scene {

/// A value of a scene file, and its line.
struct SceneValue {
  struct Entry;
  using List = std::vector<SceneValue>;
  using Table = std::vector<Entry>;  ///< in the order of the file

  std::variant<bool, double, std::string, List, Table> content;
  std::uint64_t line = 0;

  /// The content, if it is of this kind; else nullptr.
  template <typename Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&content);
  }
};

struct SceneValue::Entry {
  std::string key;
  std::uint64_t line = 0;  ///< of the key
  SceneValue value;
};

}  // namespace cutwater::scene
