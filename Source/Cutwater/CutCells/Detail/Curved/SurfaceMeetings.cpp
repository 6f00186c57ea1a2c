#include <Cutwater/CutCells/Detail/Curved/SurfaceMeetings.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace cutwater {

std::optional<Vec3<double>> meetingOf(std::span<const FluidField* const> surfaces,
                                      const Box<double>& region) {
  constexpr int kMostSteps = 16;
  constexpr double kFound = 1e-8;  // of the box: the next step is exact
  constexpr double kSingular = 1e-9;
  const auto size = region.size();
  std::array<int, 3> free{};
  std::size_t count = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0) free[count++] = axis;
  }
  const double reach = maxComponent(size);
  auto point = region.center();
  for (int step = 0; step < kMostSteps; ++step) {
    // In the free axes; in a plane, the third equation is that nothing moves across it.
    std::array<Vec3<double>, 3> rows{{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}};
    Vec3<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      const auto slope = surfaces[i]->gradient(point);
      rows[i] = {};
      for (std::size_t a = 0; a < count; ++a) rows[i][static_cast<int>(a)] = slope[free[a]];
      values[static_cast<int>(i)] = surfaces[i]->value(point);
    }
    const auto across = cross(rows[1], rows[2]);
    const double determinant = dot(rows[0], across);
    if (std::abs(determinant) <= kSingular) return {};
    const auto move = (values.x * across + values.y * cross(rows[2], rows[0]) +
                       values.z * cross(rows[0], rows[1])) /
                      -determinant;
    double moved = 0;
    for (std::size_t a = 0; a < count; ++a) {
      const int axis = free[a];
      const double before = point[axis];
      point[axis] =
          std::clamp(before + move[static_cast<int>(a)], region.lower[axis] - 0.5 * size[axis],
                     region.upper[axis] + 0.5 * size[axis]);
      moved = std::max(moved, std::abs(point[axis] - before));
    }
    if (moved > kFound * reach) continue;
    for (std::size_t a = 0; a < count; ++a) {
      const int axis = free[a];
      if (point[axis] < region.lower[axis] || point[axis] > region.upper[axis]) return {};
    }
    return point;
  }
  return {};
}

}  // namespace cutwater
