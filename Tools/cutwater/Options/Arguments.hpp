#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <string>
#include <vector>

// Values of options, read independently of the locale. All functions throw UsageError, which
// names the option, its text and what it needs; `need` says that for one option.
namespace cutwater::tool {

/// Finite numbers separated by commas: "1,-2.5,3".
[[nodiscard]] std::vector<double> numbers(
    const std::string& option, const std::string& text,
    const std::string& need = "finite numbers with commas between them");
/// Exactly `count` numbers.
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text,
                                          std::size_t count);
[[nodiscard]] double positiveNumber(const std::string& option, const std::string& text,
                                    const std::string& need = "a number above 0");
/// Degrees above 0 and below 180.
[[nodiscard]] double angleOf(const std::string& option, const std::string& text);
[[nodiscard]] Vec3<double> vectorOf(const std::string& option, const std::string& text);
/// A box with a volume, from six numbers, the lower corner first: "0,0,0,1,2,3".
[[nodiscard]] Box<double> boxOf(const std::string& option, const std::string& text);
/// Positive integers separated by 'x': "640x480".
[[nodiscard]] std::vector<std::int32_t> sizes(
    const std::string& option, const std::string& text,
    const std::string& need = "positive whole numbers with an x between them");
/// "x", "y" or "z" as 0, 1 or 2.
[[nodiscard]] int axisOf(const std::string& option, const std::string& text);

/// The index of the text among the choices.
[[nodiscard]] std::size_t choiceOf(const std::string& option, const std::string& text,
                                   const std::vector<std::string>& choices);

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& need);

}  // namespace cutwater::tool
