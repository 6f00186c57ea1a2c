#pragma once

#include <Cutwater/Surface/Detail/IndexTable.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace cutwater {

/// Numbers points, those with the same coordinates alike, in the order in which they come.
class PointNumbers {
 public:
  /// The number of a point, which is new if no other has its coordinates.
  [[nodiscard]] std::uint32_t of(const Vec3<double>& point) {
    const auto next = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    const auto number = table_.findOrInsert(
        next, [&](std::uint32_t n) { return detail::hashOf(points_[n]); },
        [&](std::uint32_t n) { return points_[n] == point; });
    if (number != next) points_.pop_back();
    return number;
  }

  [[nodiscard]] const std::vector<Vec3<double>>& points() const { return points_; }
  [[nodiscard]] std::vector<Vec3<double>> take() && { return std::move(points_); }

 private:
  std::vector<Vec3<double>> points_;
  detail::IndexTable table_;
};

}  // namespace cutwater
