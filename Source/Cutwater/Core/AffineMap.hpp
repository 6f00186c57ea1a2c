#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>

namespace cutwater {

/// x -> A x + offset.
template <std::floating_point T>
struct AffineMap {
  std::array<Vec3<T>, 3> columns{
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< images of the unit vectors
  Vec3<T> offset;

  /// The image of a point. Out of line, so its bits do not depend on the caller's compiler flags.
  [[nodiscard]] Vec3<T> operator()(const Vec3<T>& point) const;
  /// A v.
  [[nodiscard]] Vec3<T> direction(const Vec3<T>& v) const;
  /// The transpose of A times v: maps gradients and plane normals back.
  [[nodiscard]] Vec3<T> transposed(const Vec3<T>& v) const;
  /// The axis-aligned box around the image of a box; infinite extents stay infinite.
  [[nodiscard]] Box<T> operator()(const Box<T>& box) const;

  bool operator==(const AffineMap&) const = default;
};

extern template struct AffineMap<float>;
extern template struct AffineMap<double>;

}  // namespace cutwater
