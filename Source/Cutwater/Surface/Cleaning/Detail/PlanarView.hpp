#pragma once

#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <cstdint>
#include <span>
#include <utility>

namespace cutwater::detail {

/// Points seen along an axis: their other two coordinates, u and v, and exact decisions about them.
/// Points are given by their indices; coordinates must be about 1 in size.
class PlanarView {
 public:
  PlanarView(std::span<const Vec3<double>> positions, int axis)
      : positions_(positions), axis_(axis) {}

  [[nodiscard]] double u(std::uint32_t i) const { return positions_[i][(axis_ + 1) % 3]; }
  [[nodiscard]] double v(std::uint32_t i) const { return positions_[i][(axis_ + 2) % 3]; }
  [[nodiscard]] const Vec3<double>& position(std::uint32_t i) const { return positions_[i]; }
  [[nodiscard]] int axis() const { return axis_; }

  /// 1 if a, b, c turn left, seen against the axis; -1 if right, 0 if they are collinear.
  [[nodiscard]] int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return crossSign(positions_[a], positions_[b], positions_[a], positions_[c], axis_);
  }

  /// Whether the closed segments ab and cd meet anywhere except at an end that they share.
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const;

  /// Whether the loop runs around the point, which is on none of its edges.
  [[nodiscard]] bool isAround(std::span<const std::uint32_t> loop, std::uint32_t point) const;

  /// 1 if a loop that does not meet itself runs counter-clockwise, seen against the axis; else -1.
  [[nodiscard]] int orientation(std::span<const std::uint32_t> loop) const;

  /// The index in the loop of the point with the largest u, and among equals the largest v.
  [[nodiscard]] std::size_t lastOf(std::span<const std::uint32_t> loop) const;

 private:
  /// Whether p lies between a and b, given that the three are collinear.
  [[nodiscard]] bool isWithin(std::uint32_t p, std::uint32_t a, std::uint32_t b) const;
  /// Whether the boxes of the segments ab and cd meet.
  [[nodiscard]] bool boxesMeet(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                               std::uint32_t d) const;

  std::span<const Vec3<double>> positions_;
  int axis_;
};

}  // namespace cutwater::detail
