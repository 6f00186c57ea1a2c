#pragma once

#include <Cutwater/Core/Vec2.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// Base class of all straight prisms: a subclass defines the signed distance of its section in the
/// xy plane, and this class adds flat ends.
///
/// The value is the exact distance wherever that of the section is: it is the distance of a box in
/// the plane of the section's value and z.
template <std::floating_point T>
class Prismatic : public SignedDistanceFunction<T> {
 protected:
  /// The prism from z = lower to z = upper.
  /// @throws Error naming the shape `name` unless both are finite and lower < upper.
  Prismatic(const char* name, T lower, T upper);

  /// The signed distance of the section in the plane.
  [[nodiscard]] virtual T sectionDistance(const Vec2<T>& p) const = 0;
  /// Unit gradient in the plane; zero where it is not defined.
  [[nodiscard]] virtual Vec2<T> sectionGradient(const Vec2<T>& p) const = 0;

  /// Visits the planes of both ends, for localSurfacesIn().
  void visitEnds(SurfaceVisitor<T> visit) const;

  /// The ends along z.
  [[nodiscard]] T lower() const { return ends_.lower.y; }
  [[nodiscard]] T upper() const { return ends_.upper.y; }

 private:
  T localSignedDistance(const Vec3<T>& p) const final;
  Vec3<T> localGradient(const Vec3<T>& p) const final;

  Box<T> ends_;  // in (value of the section, z, 0)
};

extern template class Prismatic<float>;
extern template class Prismatic<double>;

}  // namespace cutwater
