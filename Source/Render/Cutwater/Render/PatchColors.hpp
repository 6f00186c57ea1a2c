#pragma once

#include <Cutwater/Render/Image.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace cutwater {

/// One of twelve colours that are easy to tell apart, even when shaded; then twelve lighter and
/// twelve darker ones, and again from the first.
[[nodiscard]] Rgb patchColor(std::size_t patch);

/// "steel", "white", "grey", "graphite", "sand", "copper", "red", "green" or "blue"; or a code such
/// as "#4a90d9". Nothing for other names.
[[nodiscard]] std::optional<Rgb> colorNamed(std::string_view name);

}  // namespace cutwater
