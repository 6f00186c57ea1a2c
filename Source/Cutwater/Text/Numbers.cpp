#include <Cutwater/Text/Numbers.hpp>

#include <array>
#include <charconv>

namespace cutwater::text {

std::string grouped(std::size_t count) {
  auto digits = std::to_string(count);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3) {
    digits.insert(static_cast<std::size_t>(i), 1, ' ');
  }
  return digits;
}

std::string grouped(std::size_t count, std::string_view noun) {
  std::string text = grouped(count).append(" ").append(noun);
  if (count == 1) return text;
  return text.append(noun.ends_with("ch") ? "es" : "s");
}

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
  return std::to_string(count).append(" ").append(count == 1 ? singular : plural);
}

std::string number(double value, int digits) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0,
                                    std::chars_format::general, digits);
  return {buffer.data(), result.ptr};
}

double rounded(double value, int digits) {
  const auto text = number(value, digits);
  double read = 0;
  std::from_chars(text.data(), text.data() + text.size(), read);
  return read;
}

std::string exactly(double value) {
  std::array<char, 64> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0);
  return {buffer.data(), result.ptr};
}

std::string point(const Vec3<double>& p, int digits) {
  std::string text = "(";
  text += number(p.x, digits) + ", " + number(p.y, digits) + ", " + number(p.z, digits) + ")";
  return text;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace cutwater::text
