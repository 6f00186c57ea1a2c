#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// Points and polygons as read from a file: nothing is assumed about how they fit together.
struct PolygonSoup {
  std::vector<Vec3<double>> points;
  /// Polygon i has the corners [offsets[i], offsets[i + 1]).
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint32_t> corners;  ///< indices of points
  std::vector<std::uint32_t> patches;  ///< per polygon: index into patchNames
  std::vector<std::string> patchNames;

  /// The number of polygons, and the corners of one of them: indices of points.
  [[nodiscard]] std::size_t polygonCount() const { return patches.size(); }
  [[nodiscard]] std::span<const std::uint32_t> polygon(std::size_t i) const {
    return std::span(corners).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  /// Appends a polygon; `patch` is an index into patchNames.
  void addPolygon(std::span<const std::uint32_t> polygonCorners, std::uint32_t patch = 0);

  /// The box around the corners of all polygons, which must be indices of points. Points that no
  /// polygon uses may be anywhere.
  [[nodiscard]] Box<double> boundingBox() const;

  /// Checks a soup that did not come from a reader; soups from a reader always pass.
  /// @throws Error(Argument) unless offsets go from 0 to the number of corners in steps of three or
  /// more, every corner is the index of a point, every point is finite, and the numbers of points
  /// and of polygons are below 2^32 - 1.
  void validate() const;
};

/// Merges points whose coordinates are equal (-0 equals 0), in linear time. Points keep the order
/// of their first appearance and the sign that zero has there; points that no polygon uses stay. A
/// point that is not finite equals no other. Returns the number of points merged away.
///
/// @throws Error(Argument) for more than 2^32 - 2 points.
std::size_t weldExactly(PolygonSoup& soup);

}  // namespace cutwater
