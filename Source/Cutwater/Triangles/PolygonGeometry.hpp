#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The direction that a polygon faces, and its size.
struct PolygonArea {
  Vec3<double> normal;  ///< a unit vector; zero for a polygon of no area
  double area = 0;      ///< of its projection along the normal: its area, if it is planar
};

/// Newell's method, relative to the first corner: the sum of cross products is the normal of the
/// best plane of a non-planar polygon, and correct for concave ones.
///
/// It is accurate for needles, too: where the products cancel, they are formed in twice the
/// precision, from differences without error. A sum below 2^-98 of its terms is rounding and counts
/// as no area. No polygon is so large or small that it over- or underflows.
[[nodiscard]] PolygonArea polygonArea(std::span<const Vec3<double>> corners);

/// The power of two that brings the polygon's largest extent from its first corner into [1, 2); 1
/// if it has none. Multiplying by it changes no digit.
[[nodiscard]] double unitScale(std::span<const Vec3<double>> corners);

/// A power of two that brings the largest coordinate into [1, 2), as far as the exponents allow; 1
/// if all are zero.
template <std::floating_point T>
[[nodiscard]] T normalizingScale(std::span<const Vec3<T>> positions);

/// The same for the corners of triangles, which are indices of positions. Positions that are no
/// corner may be anywhere.
template <std::floating_point T>
[[nodiscard]] T normalizingScale(std::span<const Vec3<T>> positions,
                                 std::span<const std::array<std::uint32_t, 3>> triangles);

/// The same for the positions that have these indices.
[[nodiscard]] double normalizingScale(std::span<const Vec3<double>> positions,
                                      std::span<const std::uint32_t> used);

/// Every position times normalizingScale() of those that have these indices; others may be
/// anywhere, and are at the origin in the result.
[[nodiscard]] std::vector<Vec3<double>> normalizedPositions(std::span<const Vec3<double>> positions,
                                                            std::span<const std::uint32_t> used);
/// The same for the corners of triangles; other positions are multiplied, too, and may overflow.
template <std::floating_point T>
[[nodiscard]] std::vector<Vec3<double>> normalizedPositions(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// The corners of a triangle whose vertices are indices of positions.
template <std::floating_point T>
[[nodiscard]] std::array<Vec3<double>, 3> cornersOf(std::span<const Vec3<T>> positions,
                                                    const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return {Vec3<double>(positions[a]), Vec3<double>(positions[b]), Vec3<double>(positions[c])};
}

/// The box of each triangle, whose corners are indices of positions.
template <std::floating_point T>
[[nodiscard]] std::vector<Box<double>> triangleBoxes(
    std::span<const Vec3<T>> positions, std::span<const std::array<std::uint32_t, 3>> triangles);

/// The contribution of a triangle to the surface around it.
struct TriangleShape {
  Vec3<double> normal;           ///< as polygonArea()
  double area = 0;               ///< as polygonArea()
  std::array<double, 3> angles;  ///< at its corners, in radians; all zero if it has no area
};

/// The angles are atan2(|u x v|, u . v): acos fails on needles.
[[nodiscard]] TriangleShape triangleShape(const std::array<Vec3<double>, 3>& corners);

extern template float normalizingScale(std::span<const Vec3<float>>);
extern template double normalizingScale(std::span<const Vec3<double>>);
extern template float normalizingScale(std::span<const Vec3<float>>,
                                       std::span<const std::array<std::uint32_t, 3>>);
extern template double normalizingScale(std::span<const Vec3<double>>,
                                        std::span<const std::array<std::uint32_t, 3>>);
extern template std::vector<Vec3<double>> normalizedPositions(
    std::span<const Vec3<float>>, std::span<const std::array<std::uint32_t, 3>>);
extern template std::vector<Vec3<double>> normalizedPositions(
    std::span<const Vec3<double>>, std::span<const std::array<std::uint32_t, 3>>);
extern template std::vector<Box<double>> triangleBoxes(
    std::span<const Vec3<float>>, std::span<const std::array<std::uint32_t, 3>>);
extern template std::vector<Box<double>> triangleBoxes(
    std::span<const Vec3<double>>, std::span<const std::array<std::uint32_t, 3>>);

}  // namespace cutwater
