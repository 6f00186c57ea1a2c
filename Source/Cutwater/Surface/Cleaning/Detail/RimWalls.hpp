#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater::detail {

/// Adds walls with one point below each point of the rims, shared by all rims that share the point.
class RimWalls {
 public:
  RimWalls(PolygonSoup& soup, int axis, double level)
      : soup_(soup), axis_(axis), level_(level), foot_(soup.points.size(), kNone) {}

  /// Adds the walls along a rim; returns the rim's image on the plane.
  std::vector<std::uint32_t> add(std::span<const std::uint32_t> rim, std::uint32_t patch) {
    std::vector<std::uint32_t> feet;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const auto from = rim[i];
      const auto to = rim[(i + 1) % rim.size()];
      feet.push_back(footOf(from));
      soup_.addPolygon(std::array{from, to, footOf(to)}, patch);
      soup_.addPolygon(std::array{from, footOf(to), footOf(from)}, patch);
    }
    return feet;
  }

 private:
  std::uint32_t footOf(std::uint32_t point) {
    if (foot_[point] == kNone) {
      foot_[point] = static_cast<std::uint32_t>(soup_.points.size());
      soup_.points.push_back(soup_.points[point]);
      soup_.points.back()[axis_] = level_;
    }
    return foot_[point];
  }

  PolygonSoup& soup_;
  int axis_;
  double level_;
  std::vector<std::uint32_t> foot_;
};

}  // namespace cutwater::detail
