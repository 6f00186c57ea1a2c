#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <span>

namespace cutwater {

/// A rotation followed by a translation: the placement of an object in the world. Lengths are
/// unchanged.
///
/// translate() and rotate() move the object, in the order of the calls, about the world's axes:
/// `translate({1, 0, 0}); rotate(90, 2);` first moves the object to x = 1, then rotates it about
/// the z axis through the origin to y = 1. Angles are in degrees, right-handed. Rotations by
/// multiples of 90 degrees about a coordinate axis are exact. Both throw Error(Argument), and
/// change nothing, for arguments that are not finite, and if motions add up to an offset that is
/// not.
template <std::floating_point T>
class RigidTransform {
 public:
  RigidTransform() = default;
  /// The transform with these values of axis() and offset(), to the bit.
  /// @throws Error(Argument) unless the axes are right-handed, orthonormal up to rounding (16 eps),
  /// and the offset is finite.
  RigidTransform(const std::array<Vec3<T>, 3>& axes, const Vec3<T>& offset);

  /// Moves the object by a vector in world coordinates.
  void translate(const Vec3<T>& offset);
  /// Rotates about the coordinate axis 0, 1 or 2 through the world's origin.
  void rotate(T degrees, int axis);
  /// Rotates about any axis through any point; `axis` need not have unit length.
  void rotate(T degrees, const Vec3<T>& axis, const Vec3<T>& through = {});

  /// From the world to the object's frame. Out of line: the same bits whatever the caller's flags.
  [[nodiscard]] Vec3<T> toLocal(const Vec3<T>& world) const;
  /// The same for many points; both spans must have the same size.
  void toLocal(std::span<const Vec3<T>> world, std::span<Vec3<T>> local) const;
  [[nodiscard]] Vec3<T> toWorld(const Vec3<T>& local) const;
  /// The same for directions, e.g. normals.
  [[nodiscard]] Vec3<T> directionToLocal(const Vec3<T>& world) const;
  [[nodiscard]] Vec3<T> directionToWorld(const Vec3<T>& local) const;
  /// The axis-aligned box around the moved box; infinite extents stay infinite.
  [[nodiscard]] Box<T> toWorld(const Box<T>& local) const;

  /// The transform that moves an object by `first` and then by `second`.
  /// @throws Error(Argument) if their offsets add up to one that is not finite.
  [[nodiscard]] static RigidTransform composed(const RigidTransform& first,
                                               const RigidTransform& second);

  /// Whether the transform leaves every point unchanged.
  [[nodiscard]] bool isIdentity() const { return !rotated_ && offset_ == Vec3<T>{}; }
  [[nodiscard]] bool isRotated() const { return rotated_; }
  [[nodiscard]] const Vec3<T>& offset() const { return offset_; }
  /// Image of the local axis 0, 1 or 2: a column of the rotation matrix.
  [[nodiscard]] const Vec3<T>& axis(int i) const { return column_[static_cast<std::size_t>(i)]; }

  bool operator==(const RigidTransform&) const = default;

 private:
  using Matrix = std::array<Vec3<T>, 3>;
  static constexpr Matrix kUnrotated{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  void applyRotation(const Matrix& columns);
  void moveTo(const char* motion, const Vec3<T>& offset);

  Matrix column_ = kUnrotated;
  Vec3<T> offset_;
  bool rotated_ = false;
};

extern template class RigidTransform<float>;
extern template class RigidTransform<double>;

}  // namespace cutwater
