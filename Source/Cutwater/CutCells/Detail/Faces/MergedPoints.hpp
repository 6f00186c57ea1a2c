#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace cutwater {

/// Points, of which those that are one but for rounding become one: for polygons that were divided
/// in floating point.
class MergedPoints {
 public:
  /// Points that are nearer than this are one. Coordinates are up to about 1.
  static constexpr double kSame = 0x1p-46;

  /// Adds points that stay as they are, whatever is near.
  void keep(std::span<const Vec3<double>> points);
  /// The point that stands for one: the first of those nearby that were kept or merged.
  Vec3<double> merged(const Vec3<double>& point);
  /// The corners of a polygon, merged; empty if less than three are left.
  [[nodiscard]] std::vector<Vec3<double>> mergedPolygon(std::span<const Vec3<double>> polygon);

  /// The polygon with all points that lie on its edges as corners. All must have been merged.
  [[nodiscard]] std::vector<Vec3<double>> throughPoints(std::span<const Vec3<double>> polygon);

 private:
  using Place = std::array<std::int64_t, 3>;
  [[nodiscard]] static Place placeOf(const Vec3<double>& point);
  void addBetween(const Vec3<double>& from, const Vec3<double>& to,
                  std::vector<Vec3<double>>& out) const;
  void add(const Vec3<double>& point);
  void sort();

  std::vector<Vec3<double>> points_;
  std::map<Place, std::vector<std::uint32_t>> places_;  // their numbers
  std::array<std::vector<Vec3<double>>, 3> sorted_;     // along each axis
  bool isSorted_ = false;
};

}  // namespace cutwater
