#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/Scene/SceneValue.hpp>

#include <string_view>

// Private: not installed.

namespace cutwater::scene {

/// An Error(File) whose message has the line.
class SceneError final : public Error {
 public:
  explicit SceneError(const std::string& message) : Error(ErrorKind::File, message) {}
};

/// @throws SceneError "hull.toml: line 7: message".
[[noreturn]] void failAt(const std::string& file, std::uint64_t line, const std::string& message);

/// The table that a text in TOML 1.0 is. `file` is its name in messages.
/// @throws Error(File) with the line, unless the parser loses it, for what is no TOML, is a date,
/// is a whole number that a double does not hold, or is nested deeper than a scene is; in a library
/// built without toml++, whatever the text.
[[nodiscard]] SceneValue::Table parseToml(std::string_view text, const std::string& file);

}  // namespace cutwater::scene
