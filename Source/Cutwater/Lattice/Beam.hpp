#pragma once

#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater {

/// A straight beam of a lattice: a body of revolution about the line between two nodes, as a
/// primitive for LinearBVH. Its values are those of the corresponding shape, whose formulas it
/// shares, but it takes less than half the memory, as it has no virtual functions and no placement.
template <std::floating_point T, typename Profile>
class Beam {
 public:
  /// The signedDistance() of the shape without a placement, to the bit. `p` must be finite.
  [[nodiscard]] T distance(const Vec3<T>& p) const;
  /// Gradient of the distance; zero where it is undefined.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& p) const;
  /// Bounding box of the shape: as small as possible, apart from rounding, for round and for flat
  /// ends.
  [[nodiscard]] Box<T> boundingBox() const;
  /// An upper bound of the distance of any of its points from the origin: see Guarantee::size.
  [[nodiscard]] T size() const { return size_; }

  [[nodiscard]] const detail::RotationAxis<T>& axis() const { return axis_; }
  [[nodiscard]] const Profile& profile() const { return profile_; }

 protected:
  /// A beam from a to b.
  Beam(const detail::RotationAxis<T>& axis, const Profile& profile, const Vec3<T>& a,
       const Vec3<T>& b);

 private:
  detail::RotationAxis<T> axis_;
  Profile profile_;
  T size_;
};

/// A beam with the surface of a Capsule: half balls at its ends.
template <std::floating_point T>
class CapsuleBeam : public Beam<T, detail::CapsuleProfile<T>> {
 public:
  /// @throws Error unless the nodes are finite and 0 < radius < infinity.
  CapsuleBeam(const Vec3<T>& a, const Vec3<T>& b, T radius);
};

/// A beam with the surface of a ConeSphere: the convex hull of a ball about each node.
template <std::floating_point T>
class ConeSphereBeam : public Beam<T, detail::ConeSphereProfile<T>> {
 public:
  /// @throws Error unless the nodes are finite, both radii are finite and not negative, and one of
  /// them is positive.
  ConeSphereBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);
};

/// A beam with the surface of a CappedCone: flat at its ends.
template <std::floating_point T>
class CappedConeBeam : public Beam<T, detail::FrustumProfile<T>> {
 public:
  /// @throws Error unless the nodes are finite and differ, both radii are finite and not negative,
  /// and one of them is positive.
  CappedConeBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB);
};

extern template class Beam<float, detail::CapsuleProfile<float>>;
extern template class Beam<double, detail::CapsuleProfile<double>>;
extern template class CapsuleBeam<float>;
extern template class CapsuleBeam<double>;
extern template class Beam<float, detail::ConeSphereProfile<float>>;
extern template class Beam<double, detail::ConeSphereProfile<double>>;
extern template class ConeSphereBeam<float>;
extern template class ConeSphereBeam<double>;
extern template class Beam<float, detail::FrustumProfile<float>>;
extern template class Beam<double, detail::FrustumProfile<double>>;
extern template class CappedConeBeam<float>;
extern template class CappedConeBeam<double>;
// Trees of beams are compiled in the library, too.
extern template class LinearBVH<float, CapsuleBeam<float>>;
extern template class LinearBVH<double, CapsuleBeam<double>>;
extern template class LinearBVH<float, ConeSphereBeam<float>>;
extern template class LinearBVH<double, ConeSphereBeam<double>>;
extern template class LinearBVH<float, CappedConeBeam<float>>;
extern template class LinearBVH<double, CappedConeBeam<double>>;

}  // namespace cutwater
