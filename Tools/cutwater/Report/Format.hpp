#pragma once

#include <Cutwater/Text/Numbers.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// Numbers and words formatted for people; the same in every locale.
namespace cutwater::tool {

using text::exactly;
using text::grouped;
using text::listed;
using text::number;
using text::point;
using text::rounded;

/// "6.27 x 0.859 x 0.784"
[[nodiscard]] std::string extent(const Vec3<double>& size);
/// "14.1 MB", in powers of 1000
[[nodiscard]] std::string bytes(std::size_t count);
/// "0.31 s", "12 ms", "45 us", "2 min 5 s"
[[nodiscard]] std::string duration(double seconds);
/// "about 12 s" for an estimate, "about 5.6 h", "more than a day"
[[nodiscard]] std::string roughDuration(double seconds);
/// "00c0ffee00c0ffee"
[[nodiscard]] std::string hexadecimal(std::uint64_t value);
/// The text as one word of a shell's command line, quoted where needed.
[[nodiscard]] std::string shellWord(const std::string& text);
/// The same for the name of a file, which no command takes for an option.
[[nodiscard]] std::string fileWord(const std::string& file);
/// The text with line breaks and other control characters as C writes them: a name can hold any.
[[nodiscard]] std::string onOneLine(std::string_view text);
/// Padded with blanks to `width`.
[[nodiscard]] std::string leftAligned(std::string_view text, std::size_t width);
[[nodiscard]] std::string rightAligned(std::string_view text, std::size_t width);

}  // namespace cutwater::tool
