#include <Cutwater/Core/Detail/DomainUnder.hpp>
#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Operations/Detail/Mirror.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>

namespace cutwater {

namespace detail {

template <std::floating_point T>
MirrorPlane<T>::MirrorPlane(const char* name, const Vec3<T>& point, const Vec3<T>& normal)
    : point_(point), normal_(unitVector(name, "normal", normal)) {
  requireFinite(name, "point", point);
}

template <std::floating_point T>
T MirrorPlane<T>::height(const Vec3<T>& p) const {
  return dot(p - point_, normal_);
}

template <std::floating_point T>
Vec3<T> MirrorPlane<T>::image(const Vec3<T>& p) const {
  // Twice the distance is rounded by 8 eps of |p - point|; the unit normal adds another 4.
  return p - (2 * height(p)) * normal_;
}

template <std::floating_point T>
Vec3<T> MirrorPlane<T>::imageOfDirection(const Vec3<T>& v) const {
  return v - (2 * dot(v, normal_)) * normal_;
}

template <std::floating_point T>
OrientedBox<T> MirrorPlane<T>::image(const OrientedBox<T>& box) const {
  OrientedBox<T> result = box;
  result.exact.reset();
  result.center = image(box.center);
  for (auto& half : result.halfAxis) half = imageOfDirection(half);
  const T size = length(box.center) + box.radius() + length(point_);
  result.slack += 42 * kEps<T> * size;  // of the centre, half axes and points they stand for
  return result;
}

template <std::floating_point T>
SurfacePoint<T> MirrorPlane<T>::image(SurfacePoint<T> found, const Vec3<T>& from) const {
  found.point = image(found.point);
  found.normal = imageOfDirection(found.normal);
  found.tolerance += 28 * kEps<T> * (length(from) + length(found.point) + 2 * length(point_));
  return found;
}

template <std::floating_point T>
AffineMap<T> MirrorPlane<T>::map() const {
  AffineMap<T> result;
  for (auto& column : result.columns) column = imageOfDirection(column);
  result.offset = image(Vec3<T>{});
  return result;
}

template <std::floating_point T>
T MirrorPlane<T>::reach() const {
  return 2 * std::abs(dot(point_, normal_)) * (1 + 8 * kEps<T>)+4 * kEps<T> * length(point_);
}

template class MirrorPlane<float>;
template class MirrorPlane<double>;

}  // namespace detail

template <std::floating_point T>
Mirror<T>::Mirror(Solid<T> solid, const Vec3<T>& point, const Vec3<T>& normal)
    : PointMap<T>(std::move(solid)), plane_("mirrored", point, normal) {}

template <std::floating_point T>
Vec3<T> Mirror<T>::mapped(const Vec3<T>& p) const {
  return plane_.image(p);
}

template <std::floating_point T>
OrientedBox<T> Mirror<T>::mapped(const OrientedBox<T>& box) const {
  return plane_.image(box);
}

template <std::floating_point T>
Vec3<T> Mirror<T>::pulledBack(const Vec3<T>&, const Vec3<T>& gradient) const {
  return plane_.imageOfDirection(gradient);
}

template <std::floating_point T>
SurfacePoint<T> Mirror<T>::localClosestPoint(const Vec3<T>& p) const {
  return plane_.image(operand().closestPoint(mapped(p)), p);
}

template <std::floating_point T>
CrossingCount Mirror<T>::localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const {
  const Segment<T> image{mapped(segment.start), mapped(segment.end)};
  return operand().crossings(image, [&](Crossing<T> crossing) {
    crossing.point = mapped(crossing.point);
    crossing.normal = plane_.imageOfDirection(crossing.normal);
    return visit(crossing);
  });
}

template <std::floating_point T>
BoxClass Mirror<T>::localClassify(const OrientedBox<T>& box, BoxHint*) const {
  return this->classOf(operand(), mapped(box));
}

template <std::floating_point T>
bool Mirror<T>::localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const {
  const auto image = [&](const Solid<T>& solid) -> Solid<T> {
    return Mirror<T>(solid, plane_.point(), plane_.normal());
  };
  this->surfacesOf(operand(), mapped(box), [&](const Solid<T>& surface, const Solid<T>* of) {
    const auto here = image(surface);
    if (of == &surface) return visit(here, &here);
    const auto ofHere = image(*of);
    visit(here, &ofHere);
  });
  return true;
}

template <std::floating_point T>
Guarantee<T> Mirror<T>::localGuarantee() const {
  auto promise = operand().guarantee();
  promise.ulps += 14 * promise.lipschitz.value_or(T(1));
  promise.size += plane_.reach() + length(plane_.point());
  promise.domain = detail::domainUnder(plane_.map(), plane_.map(), promise.domain);
  return promise;
}

template <std::floating_point T>
Box<T> Mirror<T>::localBoundingBox() const {
  return localGuarantee().grown(plane_.map()(operand().boundingBox()));
}

template <std::floating_point T>
Box<T> Mirror<T>::localClearanceBox() const {
  return localGuarantee().grown(plane_.map()(operand().clearanceBox()));
}

template class Mirror<float>;
template class Mirror<double>;

}  // namespace cutwater
