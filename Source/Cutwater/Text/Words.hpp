#pragma once

#include <string>
#include <string_view>

// Words of files: how they are compared, and how they appear in messages.
namespace cutwater::text {

/// Whether the words are the same but for the case of ASCII letters.
[[nodiscard]] bool equalIgnoringCase(std::string_view a, std::string_view b);

/// Whether a message may contain the character: no control character.
[[nodiscard]] bool isPrintable(char c);
/// The beginning of a text, fit for a message: 40 characters, with ? for what is not printable.
[[nodiscard]] std::string shortened(std::string_view text);
/// The same in quotes.
[[nodiscard]] std::string inQuotes(std::string_view text);

}  // namespace cutwater::text
