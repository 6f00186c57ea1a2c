#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cutwater {

/// Corners of a face in order, by their numbers.
using CornerLoop = std::vector<std::uint32_t>;

/// Leaves out corners that follow themselves, and edges there and back with nothing between. Fewer
/// than three corners are none.
void clean(CornerLoop& loop);

/// Whether a corner comes twice.
[[nodiscard]] bool hasRepeatedCorner(std::span<const std::uint32_t> loop);

/// Whether two loops lie in one plane across an axis.
[[nodiscard]] bool areInOnePlane(const CornerLoop& a, const CornerLoop& b,
                                 std::span<const Vec3<double>> points);

/// Appends the loops that a closed path consists of, in which no corner comes twice.
void addSimpleLoops(const CornerLoop& path, std::vector<CornerLoop>& loops);

/// Divides an outline in a plane across an axis, counterclockwise as seen against it, into loops
/// that have no corner twice. Outlines have where parts of one touch each other in a point, and
/// where a hole in them was cut open by an edge there and back: then another cut to the hole makes
/// two loops of it. Appends to `loops`.
void divideIntoLoops(CornerLoop outline, std::span<const Vec3<double>> points, int axis,
                     std::vector<CornerLoop>& loops);

/// The only stretch of a loop's n places, of corners or edges, for which is(place) holds; places
/// beyond n are those from 0 on again. None, if there are several, and for all of them or none.
/// @returns its first place, and the first one behind it, which is beyond n if the stretch goes on
/// across the loop's end.
template <typename Is>
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> onlyStretch(std::size_t n,
                                                                             const Is& is) {
  std::optional<std::size_t> start;
  for (std::size_t k = 0; k < n; ++k) {
    if (!is(k) || is(k + n - 1)) continue;
    if (start) return std::nullopt;
    start = k;
  }
  if (!start) return std::nullopt;
  auto end = *start + 1;
  while (is(end)) ++end;
  return std::pair(*start, end);
}

}  // namespace cutwater
