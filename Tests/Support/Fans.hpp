#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace cutwater::test {

/// Triangles and the points that they lie between.
struct TriangleList {
  std::vector<Vec3<double>> points;
  std::vector<std::array<std::uint32_t, 3>> corners;

  void shuffle(std::mt19937& engine) {
    for (std::size_t i = corners.size(); i > 1; --i)
      std::swap(corners[i - 1], corners[engine() % i]);
  }
};

inline double unitRandom(std::mt19937& engine) {
  return 0x1p-32 * static_cast<double>(engine());
}

/// n triangles from point 0 to a rim around it whose radius and height vary by up to half the
/// roughness, randomly. They do not meet.
inline TriangleList fan(std::uint32_t n, double roughness, std::mt19937& engine) {
  TriangleList result;
  result.points.push_back({0.1, 0.2, 0.3});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double radius = 1 + roughness * (unitRandom(engine) - 0.5);
    const double height = roughness * (unitRandom(engine) - 0.5);
    result.points.push_back(
        {0.1 + radius * std::cos(angle), 0.2 + radius * std::sin(angle), height});
    result.corners.push_back({0, 1 + i, 1 + (i + 1) % n});
  }
  return result;
}

/// A fan whose rim runs around the point many times, in a spiral from pole to pole.
inline TriangleList spiralFan(std::uint32_t n) {
  TriangleList result;
  result.points.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < n; ++i) {
    const double z = 1 - 2 * (i + 0.5) / n;
    const double angle = 2 * std::numbers::pi * i / std::sqrt(n);
    const double radius = std::sqrt(1 - z * z);
    result.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    if (i > 0) result.corners.push_back({0, i, i + 1});
  }
  return result;
}

/// Two fans with the same rim, which do not meet.
inline TriangleList doubleFan(std::uint32_t n, double roughness, std::mt19937& engine) {
  auto result = fan(n, roughness, engine);
  const auto apex = static_cast<std::uint32_t>(result.points.size());
  result.points.push_back({0.1, 0.2, -1.3});
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto [point, from, to] = result.corners[i];
    result.corners.push_back({apex, to, from});
  }
  return result;
}

/// The wall of a tower of 2 n triangles from bottom to top, oblique to all axes, its top turned by
/// an angle.
inline TriangleList twistedTower(std::uint32_t n, double twist) {
  TriangleList result;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (const double z : {-3.0, 3.0}) {
      const double angle = 2 * std::numbers::pi * i / n + (z > 0 ? twist : 0);
      const Vec3<double> p{std::cos(angle) + 0.3, std::sin(angle), z};
      const Vec3<double> q{0.8 * p.x + 0.6 * p.z, p.y, 0.8 * p.z - 0.6 * p.x};
      result.points.push_back({q.x, 0.8 * q.y + 0.6 * q.z, 0.8 * q.z - 0.6 * q.y});
    }
    const std::uint32_t next = 2 * ((i + 1) % n);
    result.corners.push_back({2 * i, next, 2 * i + 1});
    result.corners.push_back({2 * i + 1, next, next + 1});
  }
  return result;
}

/// n triangles with an edge in common.
inline TriangleList book(std::uint32_t n, std::mt19937& engine) {
  TriangleList result;
  result.points = {{0, 0, 0}, {0.3, 0.5, 1}};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    result.points.push_back({std::cos(angle), std::sin(angle), unitRandom(engine)});
    result.corners.push_back({0, 1, 2 + i});
  }
  return result;
}

/// Adds triangles between random points of these and others, some at the first point.
inline void addIntruders(TriangleList& to, int count, std::mt19937& engine) {
  const auto any = [&] { return static_cast<std::uint32_t>(engine() % to.points.size()); };
  for (int i = 0; i < count; ++i) {
    const auto added = static_cast<std::uint32_t>(to.points.size());
    to.points.push_back(
        {unitRandom(engine) - 0.5, unitRandom(engine) - 0.5, unitRandom(engine) - 0.5});
    to.corners.push_back({any(), any(), any()});
    to.corners.push_back({0, added, any()});
  }
}

}  // namespace cutwater::test
