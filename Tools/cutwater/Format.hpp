#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Numbers formatted for people; the same in every locale.
namespace cutwater::tool {

/// "1 234 567"
[[nodiscard]] std::string grouped(std::size_t count);
/// Up to `digits` significant digits: "6.2731", "1.5e-05"
[[nodiscard]] std::string number(double value, int digits = 6);
/// The value rounded to so many significant digits: 0.3, not 0.30000000000000004.
[[nodiscard]] double rounded(double value, int digits);
/// The shortest digits that read back as the same number.
[[nodiscard]] std::string exactly(double value);
/// "(1, 2.5, -3)"
[[nodiscard]] std::string point(const Vec3<double>& p, int digits = 6);
/// "6.27 x 0.859 x 0.784"
[[nodiscard]] std::string extent(const Vec3<double>& size);
/// "14.1 MB", in powers of 1000
[[nodiscard]] std::string bytes(std::size_t count);
/// "0.31 s", "12 ms", "45 us", "2 min 5 s"
[[nodiscard]] std::string duration(double seconds);
/// The count and its noun: "1 hole", "2 holes", "3 patches"
[[nodiscard]] std::string counted(std::size_t count, const std::string& noun);
/// "00c0ffee00c0ffee"
[[nodiscard]] std::string hexadecimal(std::uint64_t value);
/// The text as one word of a shell's command line, quoted where needed.
[[nodiscard]] std::string shellWord(const std::string& text);
/// The same for the name of a file, which no command takes for an option.
[[nodiscard]] std::string fileWord(const std::string& file);
/// "a, b, c"
[[nodiscard]] std::string listed(const std::vector<std::string>& words);
/// Padded with blanks to `width`.
[[nodiscard]] std::string leftAligned(std::string_view text, std::size_t width);
[[nodiscard]] std::string rightAligned(std::string_view text, std::size_t width);

}  // namespace cutwater::tool
