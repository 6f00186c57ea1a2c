#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/Detail/Ticks.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kMostTicks = 10000;

/// Decimal places that the multiples of `step` need, negative if they end in zeros; for a step like
/// 1/3, those that give three digits.
int decimals(double step) {
  const int leading = -static_cast<int>(std::floor(std::log10(step) + 1e-9));
  for (int digits = leading; digits < leading + 2; ++digits) {
    const double scaled = step * std::pow(10.0, digits);
    if (std::abs(scaled - std::round(scaled)) < 1e-9 * scaled) return digits;
  }
  return leading + 2;
}

std::string label(double value, double step, double largest) {
  char buffer[64];
  const bool plain = largest < 1e6 && step >= 0.9e-5;
  if (value == 0 && !plain) return "0";
  const int leading = plain ? 0 : static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value, format,
                                    std::clamp(decimals(step) + leading, 0, 16));  // locale-free
  return {buffer, result.ptr};
}

}  // namespace

double roundStep(double wanted) {
  constexpr double kLeast = 1e-300;  // below, powers of ten lose digits
  const double target = std::clamp(wanted, kLeast, 1e300);
  const double power = std::pow(10.0, std::floor(std::log10(target)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= target * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<Tick> ticksBetween(double lower, double upper, double step) {
  require(std::isfinite(lower) && std::isfinite(upper) && lower <= upper && step > 0 &&
              (upper - lower) / step <= kMostTicks,
          "ticksBetween: need lower <= upper and a step that is not too small",
          Named{"lower", lower}, Named{"upper", upper}, Named{"step", step});
  // A tick that rounding moved just beyond an end is still included.
  const double first = std::ceil(lower / step - 1e-9);
  const double last = std::floor(upper / step + 1e-9);
  const double largest = std::max({std::abs(lower), std::abs(upper), step});
  std::vector<Tick> ticks;
  for (int n = 0; n <= last - first; ++n) {
    const double value = (first + n) * step + 0.0;  // -0 becomes 0
    ticks.push_back({value, label(value, step, largest)});
  }
  return ticks;
}

std::string lengthLabel(double length, const std::string& unit) {
  const auto text = ticksBetween(length, length, length).at(0).label;
  return unit.empty() ? text : text + " " + unit;
}

}  // namespace cutwater
