#pragma once

#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// What all straight prisms share: a subclass states the signed distance of its section in the xy
/// plane, and this class gives it flat ends.
///
/// The value is the exact distance wherever the section's is. It is that of a box in the plane of
/// the section's value and z.
template <std::floating_point T>
class Prismatic : public SignedDistanceFunction<T> {
 protected:
  /// From z = lower to z = upper.
  /// @throws Error, as from the shape `name`, unless both are finite and lower < upper.
  Prismatic(const char* name, T lower, T upper);

  /// The section's signed distance in the plane.
  [[nodiscard]] virtual T sectionDistance(const Vec2<T>& p) const = 0;
  /// Unit gradient in the plane; zero where it is not defined.
  [[nodiscard]] virtual Vec2<T> sectionGradient(const Vec2<T>& p) const = 0;

  /// The ends along z.
  [[nodiscard]] T lower() const { return ends_.lower.y; }
  [[nodiscard]] T upper() const { return ends_.upper.y; }

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& p) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& p) const final;

  Box<T> ends_;  // of (value of the section, z, 0)
};

extern template class Prismatic<float>;
extern template class Prismatic<double>;

}  // namespace cutwater
