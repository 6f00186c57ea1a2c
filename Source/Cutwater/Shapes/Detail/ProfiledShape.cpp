#include <Cutwater/Shapes/Detail/Profiles.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

#include <array>

namespace cutwater {

template <std::floating_point T, typename Profile>
T ProfiledShape<T, Profile>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_.distance(p);
}

template <std::floating_point T, typename Profile>
ProfilePoint<T> ProfiledShape<T, Profile>::profileGradient(const ProfilePoint<T>& p) const {
  return profile_.gradient(p);
}

template <std::floating_point T, typename Profile>
bool ProfiledShape<T, Profile>::localSurfacesIn(const OrientedBox<T>&,
                                                SurfaceVisitor<T> visit) const {
  constexpr bool kHasEdges = std::same_as<Profile, detail::FrustumProfile<T>>;
  if constexpr (kHasEdges) {
    const std::array<ProfilePoint<T>, 4> corners{{{0, 0},
                                                  {profile_.radiusA(), 0},
                                                  {profile_.radiusB(), profile_.height()},
                                                  {0, profile_.height()}}};
    detail::visitRevolved<T>(this->rotationAxis(), corners, visit);
  }
  return kHasEdges;
}

template <std::floating_point T, typename Profile>
Guarantee<T> ProfiledShape<T, Profile>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T, typename Profile>
Box<T> ProfiledShape<T, Profile>::localBoundingBox() const {
  return localGuarantee().grown(profile_.box(this->rotationAxis()));
}

template class ProfiledShape<float, detail::CapsuleProfile<float>>;
template class ProfiledShape<double, detail::CapsuleProfile<double>>;
template class ProfiledShape<float, detail::ConeSphereProfile<float>>;
template class ProfiledShape<double, detail::ConeSphereProfile<double>>;
template class ProfiledShape<float, detail::FrustumProfile<float>>;
template class ProfiledShape<double, detail::FrustumProfile<double>>;

}  // namespace cutwater
