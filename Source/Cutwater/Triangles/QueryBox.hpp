#pragma once

#include <Cutwater/Core/OrientedBox.hpp>

#include <array>
#include <cstdint>

namespace cutwater {

/// Whether a box meets triangles: not at all, possibly, or certainly.
enum class BoxOverlap : std::uint8_t { None, Possible, Certain };

/// A box that triangles are tested against, in double precision. All results are certain, for the
/// box with its slack and in spite of rounding; cases in doubt are reported as such.
///
/// Coordinates should be about 1 at most, or not much larger than the distances that matter.
class QueryBox {
 public:
  /// The corners of a triangle.
  using Corners = std::array<Vec3<double>, 3>;

  explicit QueryBox(const OrientedBox<double>& box);

  /// Whether a triangle meets the box, both in the caller's coordinates, or what was found `before`
  /// for others, whichever is more certain. Once one may meet the box, others need not be apart.
  [[nodiscard]] BoxOverlap overlapWith(const Corners& triangle,
                                       BoxOverlap before = BoxOverlap::None) const;

  /// Transforms to the box's frame: from its centre, along its edges. Triangles below are in this
  /// frame.
  [[nodiscard]] Corners toBox(const Corners& triangle) const;

  /// Whether the triangle certainly has no point in common with the box. (Separating axes:
  /// Gottschalk, Lin and Manocha 1996, "OBBTree".)
  [[nodiscard]] bool isApart(const Corners& triangle) const;
  /// Whether the triangle certainly has a point in the box; never where the box has no inside.
  [[nodiscard]] bool meets(const Corners& triangle) const;
  /// Whether the box is thicker than rounding and slack on all axes.
  [[nodiscard]] bool hasInside() const {
    return innerHalf_.x > 0 && innerHalf_.y > 0 && innerHalf_.z > 0;
  }
  /// A lower bound on the distance from the triangle to the box, not improved further once it is at
  /// least `enough`. It is less than the distance by rounding and by what the search for the
  /// direction of the gap leaves, about a thousandth.
  [[nodiscard]] double gap(const Corners& triangle, double enough) const;

  /// Orthonormal axes, along the half axes as far as these have a direction.
  [[nodiscard]] const Vec3<double>& axis(int i) const { return axes_[static_cast<std::size_t>(i)]; }
  /// Whether the half axes are along x, y and z.
  [[nodiscard]] static bool isAligned(const OrientedBox<double>& box) {
    const auto& [x, y, z] = box.halfAxis;
    return x.y == 0 && x.z == 0 && y.x == 0 && y.z == 0 && z.x == 0 && z.y == 0;
  }

 private:
  [[nodiscard]] Vec3<double> toBox(const Vec3<double>& p) const;
  /// How far apart box and triangle are along an axis, times its length; negative if they overlap
  /// there.
  [[nodiscard]] double separation(const Vec3<double>& axis, const Corners& triangle) const;

  Vec3<double> center_;
  std::array<Vec3<double>, 3> axes_;  // orthonormal
  Vec3<double> half_;                 // of a box around it
  Vec3<double> innerHalf_;            // of a box within it; may be negative
  double rounding_;                   // of coordinates of points near the box
};

}  // namespace cutwater
