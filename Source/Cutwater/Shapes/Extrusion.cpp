#include <Cutwater/Shapes/Detail/PolygonDistance.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>
#include <Cutwater/Shapes/Extrusion.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
Extrusion<T>::Extrusion(const Polygon<T>& section, T lower, T upper)
    : Prismatic<T>("Extrusion", lower, upper),
      section_(std::make_shared<const detail::PolygonDistance<T>>(section,
                                                                  detail::EdgesOnAxis::Boundary)) {}

template <std::floating_point T>
T Extrusion<T>::sectionDistance(const Vec2<T>& p) const {
  return section_->distance(p);
}

template <std::floating_point T>
Vec2<T> Extrusion<T>::sectionGradient(const Vec2<T>& p) const {
  return section_->gradient(p);
}

template <std::floating_point T>
bool Extrusion<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  section_->forEdgesIn(box.bounds(), [&](const detail::PlanarEdge<T>& edge) {
    const auto& [x, y] = edge.start();
    const auto normal = edge.outward();
    detail::visitPlane<T>({x, y, 0}, {normal.x, normal.y, 0}, visit);
  });
  this->visitEnds(visit);
  return true;
}

template <std::floating_point T>
Guarantee<T> Extrusion<T>::localGuarantee() const {
  return Guarantee<T>::exact(section_->size() +
                             std::max(std::abs(this->lower()), std::abs(this->upper())));
}

template <std::floating_point T>
Box<T> Extrusion<T>::localBoundingBox() const {
  const auto& low = section_->lower();
  const auto& high = section_->upper();
  return localGuarantee().grown({{low.x, low.y, this->lower()}, {high.x, high.y, this->upper()}});
}

template class Extrusion<float>;
template class Extrusion<double>;

}  // namespace cutwater
