#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Detail/PolygonDistance.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>
#include <Cutwater/Shapes/Revolution.hpp>

namespace cutwater {

template <std::floating_point T>
Revolution<T>::Revolution(const Polygon<T>& profile, const Vec3<T>& origin, const Vec3<T>& axis)
    : Axisymmetric<T>("Revolution", origin, axis),
      profile_(std::make_shared<const detail::PolygonDistance<T>>(profile,
                                                                  detail::EdgesOnAxis::Dropped)) {
  require(profile_->lower().x >= 0, "Revolution: need x >= 0 at all corners of the profile",
          Named{"least x", profile_->lower().x});
  for (const auto& loop : profile.loops()) {
    for (const auto& corner : loop) {
      box_.extend(this->rotationAxis().discBox(corner.y, corner.x));
    }
  }
}

template <std::floating_point T>
T Revolution<T>::profileDistance(const ProfilePoint<T>& p) const {
  return profile_->distance({p.radial, p.axial});
}

template <std::floating_point T>
ProfilePoint<T> Revolution<T>::profileGradient(const ProfilePoint<T>& p) const {
  const auto slope = profile_->gradient({p.radial, p.axial});
  return {slope.x, slope.y};
}

template <std::floating_point T>
bool Revolution<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  const auto center = this->rotationAxis().profilePoint(box.center);
  const auto around = Box<T>{{center.radial, center.axial, 0}, {center.radial, center.axial, 0}};
  profile_->forEdgesIn(around.grown(box.radius()), [&](const detail::PlanarEdge<T>& edge) {
    detail::visitRevolved<T>(this->rotationAxis(), {edge.start().x, edge.start().y},
                             {edge.end().x, edge.end().y}, visit);
  });
  return true;
}

template <std::floating_point T>
Guarantee<T> Revolution<T>::localGuarantee() const {
  return Guarantee<T>::exact(length(this->origin()) + profile_->size());
}

template <std::floating_point T>
Box<T> Revolution<T>::localBoundingBox() const {
  return localGuarantee().grown(box_);
}

template class Revolution<float>;
template class Revolution<double>;

}  // namespace cutwater
