#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

// Numbers, counts and lists as people read them; the same in every locale.
namespace cutwater::text {

/// "1 234 567"
[[nodiscard]] std::string grouped(std::size_t count);
/// With its noun: "1 hole", "1 234 holes", "3 patches"
[[nodiscard]] std::string grouped(std::size_t count, std::string_view noun);
/// "1 open edge", "7 open edges".
[[nodiscard]] std::string counted(std::size_t count, std::string_view singular,
                                  std::string_view plural);
/// Up to `digits` significant digits: "6.2731", "1.5e-05"
[[nodiscard]] std::string number(double value, int digits = 6);
/// The value rounded to so many significant digits: 0.3, not 0.30000000000000004.
[[nodiscard]] double rounded(double value, int digits);
/// The shortest digits that read back as the same number.
[[nodiscard]] std::string exactly(double value);
/// "(1, 2.5, -3)"
[[nodiscard]] std::string point(const Vec3<double>& p, int digits = 6);
/// "a, b, c"
[[nodiscard]] std::string listed(const std::vector<std::string>& words);

}  // namespace cutwater::text
