#pragma once

#include <Cutwater/Core/Box.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace cutwater {

/// What tells which images of a body matter.
struct BodySize {
  Box<double> box;
  Vec3<double> longest = {};  ///< along each axis, of its triangles

  [[nodiscard]] bool isBounded(int axis) const {
    return std::isfinite(box.lower[axis]) && std::isfinite(box.upper[axis]);
  }
};

/// The period of a body along each axis, if it has any.
///
/// Coordinates are multiples of a power of two, the unit, and so are lengths of periods. So what
/// lies whole periods apart does so exactly, as long as there are fewer than 2^52 units to it.
struct CutPeriod {
  Vec3<double> length = {};  ///< 0: none
  /// Where cells are cut: at the place, whole periods away, where their lowest plane is from here
  /// on and less than a period above.
  Vec3<double> start = {};
  double unit = 0;

  /// How far above the start cells reach, in periods: there are two cells in a period at least.
  static constexpr double kReach = 1.5;

  [[nodiscard]] bool isOn(int axis) const { return length[axis] > 0; }
  [[nodiscard]] bool isOnAny() const { return maxComponent(length) > 0; }
  /// The nearest multiple of the unit.
  [[nodiscard]] double rounded(double x) const;
  [[nodiscard]] Vec3<double> rounded(const Vec3<double>& p) const {
    return {rounded(p.x), rounded(p.y), rounded(p.z)};
  }
  /// Whether a coordinate is a multiple, and not too far away.
  [[nodiscard]] bool has(double x) const;
  /// By how many periods a plane lies above the one where cells are cut.
  [[nodiscard]] std::int64_t periodsTo(int axis, double plane) const;
  /// The same as a length.
  [[nodiscard]] double shiftTo(int axis, double plane) const {
    return isOn(axis) ? static_cast<double>(periodsTo(axis, plane)) * length[axis] : 0;
  }
  /// The highest coordinate at which cells are cut.
  [[nodiscard]] double endOf(int axis) const {
    return isOn(axis) ? start[axis] + kReach * length[axis] : Box<double>::kInf;
  }

  /// Starts where the fewest images of the body matter.
  void startBeside(const BodySize& body);
  /// How far the images of the body that matter where cells are cut are from it, sorted by z, y, x.
  /// Along axes without bounds, the body is its own image.
  [[nodiscard]] std::vector<Vec3<double>> imagesOf(const BodySize& body) const;
};

/// The period of what lies in a box, which starts at 0.
/// @throws Error(Argument) unless lengths are finite and not negative, and none is so short beside
/// the box that it fits a thousand times.
[[nodiscard]] CutPeriod periodOf(const Box<double>& body, const Vec3<double>& length);

}  // namespace cutwater
