#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cutwater::test {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// The patterns as the literature writes them, with x, y, z in radians, by the standard library's
/// functions; and what is known of them.
struct PlainPattern {
  std::string name;
  std::function<double(double, double, double)> value;
  double lipschitz, axisSlope;
  double leastSlope, meanSlope, mostSlope;  // of F on F = 0
  double area;                              // of F = 0 in a cell, in units of its side squared
};

inline std::vector<PlainPattern> plainPatterns() {
  const auto s = [](double a) { return std::sin(a); };
  const auto c = [](double a) { return std::cos(a); };
  const auto t = [=](double x, double y, double z) {
    return s(2 * x) * c(y) * s(z) + s(2 * y) * c(z) * s(x) + s(2 * z) * c(x) * s(y);
  };
  const auto cc = [=](double x, double y, double z) {
    return c(2 * x) * c(2 * y) + c(2 * y) * c(2 * z) + c(2 * z) * c(2 * x);
  };
  using D = double;
  return {
      {"gyroid", [=](D x, D y, D z) { return s(x) * c(y) + s(y) * c(z) + s(z) * c(x); }, 1.732051,
       std::sqrt(2), 1.414, 1.533, 1.732, 3.0916},
      {"Schwarz P", [=](D x, D y, D z) { return c(x) + c(y) + c(z); }, 1.732051, 1, 1, 1.339, 1.732,
       2.3526},
      {"Schwarz D", [=](D x, D y, D z) { return c(x) * c(y) * c(z) - s(x) * s(y) * s(z); },
       1.224745, 1, 1, 1.059, 1.225, 3.8380},
      {"Schwarz D, 4 terms",
       [=](D x, D y, D z) {
         return s(x) * s(y) * s(z) + s(x) * c(y) * c(z) + c(x) * s(y) * c(z) + c(x) * c(y) * s(z);
       },
       1.732051, std::sqrt(2), 1.414, 1.498, 1.732, 3.8380},
      {"lidinoid", [=](D x, D y, D z) { return t(x, y, z) / 2 - cc(x, y, z) / 2 + 0.15; }, 2.598076,
       2.0627, 0.49, 1.54, 2.55, 6.239},
      {"split-P",
       [=](D x, D y, D z) {
         return 1.1 * t(x, y, z) - 0.2 * cc(x, y, z) - 0.4 * (c(2 * x) + c(2 * y) + c(2 * z));
       },
       3.620074, 2.4351, 1.27, 2.38, 3.62, 5.114},
      {"Neovius", [=](D x, D y, D z) { return 3 * (c(x) + c(y) + c(z)) + 4 * c(x) * c(y) * c(z); },
       7, 7, 1, 2.89, 5.20, 3.524},
      {"Schoen IWP",
       [=](D x, D y, D z) {
         return 2 * (c(x) * c(y) + c(y) * c(z) + c(z) * c(x)) - (c(2 * x) + c(2 * y) + c(2 * z));
       },
       5.196152, 5.1962, 3.38, 4.35, 4.90, 3.5536},
      {"Schoen F-RD", [=](D x, D y, D z) { return 4 * c(x) * c(y) * c(z) - cc(x, y, z); }, 7.040690,
       7.0407, 2.55, 3.74, 5.53, 4.852},
      {"Fischer-Koch S",
       [=](D x, D y, D z) {
         return c(2 * x) * s(y) * c(z) + c(x) * c(2 * y) * s(z) + s(x) * c(y) * c(2 * z);
       },
       2.443973, 2.1852, 1.21, 1.80, 2.44, 5.430},
  };
}

}  // namespace cutwater::test
