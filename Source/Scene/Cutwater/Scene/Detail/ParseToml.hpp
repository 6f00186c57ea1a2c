#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Scene/Detail/SceneValue.hpp>

#include <string_view>

namespace cutwater::scene {

/// An Error(File) whose message includes the line.
class SceneError final : public Error {
 public:
  explicit SceneError(const std::string& message) : Error(ErrorKind::File, message) {}
};

/// @throws SceneError "hull.toml: line 7: message".
[[noreturn]] void failAt(const std::string& file, std::uint64_t line, const std::string& message);

/// Parses a text in TOML 1.0 into a table. `file` is its name in messages.
/// @throws Error(File), with the line unless the parser loses it, for text that is not TOML, dates,
/// whole numbers that a double cannot represent, and values nested deeper than in any scene; for
/// any text in a library built without toml++.
[[nodiscard]] SceneValue::Table parseToml(std::string_view text, const std::string& file);

}  // namespace cutwater::scene
