#pragma once

#include <Cutwater/Core/OrientedBox.hpp>

#include <array>
#include <cstdint>

namespace cutwater {

/// Whether a box meets triangles: not at all, perhaps, or certainly.
enum class BoxOverlap : std::uint8_t { None, Possible, Certain };

/// A box that triangles are tested against, in double precision. All answers are certain, for the
/// box with its slack and in spite of rounding; what is not is left open.
///
/// Coordinates are to be about 1 at most, or not much larger than the distances that matter.
class QueryBox {
 public:
  /// Of a triangle.
  using Corners = std::array<Vec3<double>, 3>;

  explicit QueryBox(const OrientedBox<double>& box);

  /// Whether a triangle meets the box, both in the caller's coordinates.
  [[nodiscard]] BoxOverlap overlapWith(const Corners& triangle) const;

  /// As seen from the box: from its centre, along its edges. Triangles below are in this frame.
  [[nodiscard]] Corners toBox(const Corners& triangle) const;

  /// The triangle has no point in common with the box. (Separating axes: Gottschalk, Lin and
  /// Manocha 1996, "OBBTree".)
  [[nodiscard]] bool isApart(const Corners& triangle) const;
  /// The triangle has a point in the box.
  [[nodiscard]] bool meets(const Corners& triangle) const;
  /// The triangle is at least so far from every point of the box; it is not asked how far if that
  /// is `enough`.
  /// Less what rounding and the search for the direction of the gap leave, about a thousandth.
  [[nodiscard]] double gap(const Corners& triangle, double enough) const;

  /// Orthonormal; along the half axes, as far as these have a direction.
  [[nodiscard]] const Vec3<double>& axis(int i) const { return axes_[static_cast<std::size_t>(i)]; }
  /// The half axes are along x, y and z.
  [[nodiscard]] static bool isAligned(const OrientedBox<double>& box) {
    const auto& [x, y, z] = box.halfAxis;
    return x.y == 0 && x.z == 0 && y.x == 0 && y.z == 0 && z.x == 0 && z.y == 0;
  }

 private:
  [[nodiscard]] Vec3<double> toBox(const Vec3<double>& p) const;
  /// How far apart they are along a direction, times its length; negative if they overlap there.
  [[nodiscard]] double separation(const Vec3<double>& axis, const Corners& triangle) const;

  Vec3<double> center_;
  std::array<Vec3<double>, 3> axes_;  // orthonormal
  Vec3<double> half_;                 // of a box around it
  Vec3<double> innerHalf_;            // of a box within it; may be negative
  double rounding_;                   // of coordinates of points near the box
};

}  // namespace cutwater
