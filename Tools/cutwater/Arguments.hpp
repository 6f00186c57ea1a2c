#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

// Values of options, read independently of the locale. All functions throw CLI::ValidationError,
// which names the option and its text.
namespace cutwater::tool {

/// Finite numbers separated by commas: "1,-2.5,3".
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text);
/// Exactly `count` numbers.
[[nodiscard]] std::vector<double> numbers(const std::string& option, const std::string& text,
                                          std::size_t count);
[[nodiscard]] double positiveNumber(const std::string& option, const std::string& text);
[[nodiscard]] Vec3<double> vectorOf(const std::string& option, const std::string& text);
/// A box with a volume, from six numbers, the lower corner first: "0,0,0,1,2,3".
[[nodiscard]] Box<double> boxOf(const std::string& option, const std::string& text);
/// Positive integers separated by 'x': "640x480".
[[nodiscard]] std::vector<std::int32_t> sizes(const std::string& option, const std::string& text);
/// "x", "y" or "z" as 0, 1 or 2.
[[nodiscard]] int axisOf(const std::string& option, const std::string& text);

/// Refuses a file's name that ends otherwise than in one of these, as in {".png"}, in letters of
/// any case. A name without an extension, such as /dev/stdout, will do.
void requireExtension(const std::string& option, const std::string& path,
                      std::initializer_list<std::string_view> extensions);

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& need);

}  // namespace cutwater::tool
