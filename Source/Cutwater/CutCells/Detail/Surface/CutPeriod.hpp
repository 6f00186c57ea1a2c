#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Surface/PolygonSoup.hpp>

#include <cstdint>

namespace cutwater {

/// The period of a body along each axis, if it has any.
///
/// Coordinates are multiples of a power of two, the unit, and so are lengths of periods. So what
/// lies whole periods apart does so exactly, as long as there are fewer than 2^52 units to it.
struct CutPeriod {
  Vec3<double> length;  ///< 0: none
  /// Where cells are cut: at the place, whole periods away, where their lowest plane is from here
  /// on and less than a period above.
  Vec3<double> start;
  double unit = 0;

  /// How far above the start cells reach, in periods: there are two cells in a period at least.
  static constexpr double kReach = 1.5;

  [[nodiscard]] bool isOn(int axis) const { return length[axis] > 0; }
  [[nodiscard]] bool isOnAny() const { return maxComponent(length) > 0; }
  /// The nearest multiple of the unit.
  [[nodiscard]] double rounded(double x) const;
  /// Whether a coordinate is a multiple, and not too far away.
  [[nodiscard]] bool has(double x) const;
  /// By how many periods a plane lies above the one where cells are cut.
  [[nodiscard]] std::int64_t periodsTo(int axis, double plane) const;
};

/// The period of a body of triangles.
/// @throws Error(Argument) unless lengths are finite and not negative, and none is so short beside
/// the body that it repeats a thousand times within it.
[[nodiscard]] CutPeriod periodOf(const PolygonSoup& body, const Vec3<double>& length);

/// The body and those of its images that matter where cells are cut, with rounded vertices, those
/// in one place merged. Vertices are in the order of their coordinates, and images in the order of
/// theirs: so images are alike, but for where they are.
[[nodiscard]] PolygonSoup withImages(const PolygonSoup& body, const CutPeriod& period);

/// Whether images may touch each other.
[[nodiscard]] bool imagesMayTouch(const PolygonSoup& body, const CutPeriod& period);

}  // namespace cutwater
