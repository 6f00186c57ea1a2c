#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <string>
#include <vector>

// Values of options, read independently of the locale. All throw CLI::ValidationError, which names
// the option and its text.
namespace cutwater::tool {

/// Finite numbers with a separator between them: "1,-2.5,3".
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text);
/// Exactly so many.
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text,
                                          std::size_t count);
[[nodiscard]] double positiveNumber(const std::string& option, const std::string& text);
[[nodiscard]] Vec3<double> vectorOf(const std::string& option, const std::string& text);
/// Six numbers, the lower corner first: "0,0,0,1,2,3". Only one with a volume.
[[nodiscard]] Box<double> boxOf(const std::string& option, const std::string& text);
/// Positive integers with an 'x' between them: "640x480".
[[nodiscard]] std::vector<std::int32_t> sizes(const std::string& option, const std::string& text);
/// "x", "y" or "z" as 0, 1 or 2.
[[nodiscard]] int axisOf(const std::string& option, const std::string& text);

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& need);

}  // namespace cutwater::tool
