#pragma once

#include <Cutwater/Lattice/Beam.hpp>
#include <Cutwater/Lattice/Detail/CappedFrustumProfile.hpp>

namespace cutwater {

/// A beam that is a frustum with a cap at each end: see BeamCap. If both ends are flat, its surface
/// is that of a CappedCone. Compiled with the other beams, in Beam.cpp.
template <std::floating_point T>
class CappedBeam : public Beam<T, detail::CappedFrustumProfile<T>> {
 public:
  /// @throws Error unless the nodes are finite and differ, both radii are finite and not negative,
  /// and one of them is positive.
  CappedBeam(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB,
             const std::array<BeamCap, 2>& caps);
};

extern template class Beam<float, detail::CappedFrustumProfile<float>>;
extern template class Beam<double, detail::CappedFrustumProfile<double>>;
extern template class CappedBeam<float>;
extern template class CappedBeam<double>;
extern template class LinearBVH<float, CappedBeam<float>>;
extern template class LinearBVH<double, CappedBeam<double>>;

}  // namespace cutwater
