#include <Cutwater/Bvh/Detail/FittingAxes.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// The unit vector along the mean normal, whichever way each triangle faces.
Vec3<double> meanNormal(std::size_t count,
                        FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> triangle) {
  Vec3<double> sum;
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = triangle(i);
    const auto normal = cross(b - a, c - a);
    sum += dot(normal, sum) < 0 ? -normal : normal;
  }
  return normalized(sum);
}

/// Two directions across a normal.
std::array<Vec3<double>, 2> across(const Vec3<double>& normal) {
  int axis = 0;
  for (const int other : {1, 2}) {
    if (std::abs(normal[other]) < std::abs(normal[axis])) axis = other;
  }
  Vec3<double> away;
  away[axis] = 1;
  const auto u = normalized(cross(normal, away));
  return {u, cross(normal, u)};
}

}  // namespace

std::optional<BoxAxes> fittingAxes(std::size_t count,
                                   FunctionRef<std::array<Vec3<double>, 3>(std::size_t)> triangle) {
  const auto normal = meanNormal(count, triangle);
  const auto [u, v] = across(normal);
  double sumU = 0;
  double sumV = 0;
  double sumUU = 0;
  double sumUV = 0;
  double sumVV = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& corner : triangle(i)) {
      const double x = dot(u, corner);
      const double y = dot(v, corner);
      sumU += x, sumV += y;
      sumUU += x * x, sumUV += x * y, sumVV += y * y;
    }
  }
  // The principal axis of their covariance; of two formulas, the one that does not cancel.
  const auto corners = static_cast<double>(3 * count);
  const double mixed = 2 * (sumUV - sumU * sumV / corners);
  const double excess = (sumUU - sumU * sumU / corners) - (sumVV - sumV * sumV / corners);
  const double size = std::sqrt(excess * excess + mixed * mixed);
  const auto longest =
      excess < 0 ? mixed * u + (size - excess) * v : (size + excess) * u + mixed * v;
  const auto first = size > 0 ? normalized(longest) : u;
  const BoxAxes axes{static_cast<Vec3<float>>(first),
                     static_cast<Vec3<float>>(cross(normal, first)),
                     static_cast<Vec3<float>>(normal)};
  const bool valid = std::ranges::all_of(axes, [](const auto& axis) {
    return std::abs(length(axis) - 1) < 0x1p-20F;  // false if anything is NaN
  });
  return valid ? std::optional(axes) : std::nullopt;
}

}  // namespace cutwater::detail
