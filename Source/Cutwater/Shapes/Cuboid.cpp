#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/BoxDistance.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

namespace cutwater {

template <std::floating_point T>
Cuboid<T>::Cuboid(const Box<T>& box) : box_(box) {
  const auto size = box.size();
  require(isFinite(box) && size.x > 0 && size.y > 0 && size.z > 0,
          "Cuboid: need finite corners with lower < upper", Named{"lower", box.lower},
          Named{"upper", box.upper});
}

template <std::floating_point T>
T Cuboid<T>::localSignedDistance(const Vec3<T>& p) const {
  return detail::boxDistance(box_, p);
}

template <std::floating_point T>
Vec3<T> Cuboid<T>::localGradient(const Vec3<T>& p) const {
  return detail::boxGradient(box_, p);
}

template <std::floating_point T>
Interval<T> Cuboid<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  return detail::boundsWithin(detail::boxDistances(box_, box.bounds()),
                              localSignedDistance(box.center), box, localGuarantee());
}

template <std::floating_point T>
BoxClass Cuboid<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  if (!box.exact) return SignedDistanceFunction<T>::localClassify(box, hint);
  // Comparisons do not round. A box that only touches a face holds points of the surface.
  const auto& [lower, upper] = *box.exact;
  if (!box_.overlaps(*box.exact)) return BoxClass::Outside;
  const auto isAbove = [](const Vec3<T>& a, const Vec3<T>& b) {
    return a.x > b.x && a.y > b.y && a.z > b.z;
  };
  return isAbove(lower, box_.lower) && isAbove(box_.upper, upper) ? BoxClass::Inside
                                                                  : BoxClass::Cut;
}

template <std::floating_point T>
bool Cuboid<T>::localSurfacesIn(const OrientedBox<T>&, SurfaceVisitor<T> visit) const {
  detail::visitSides(box_, visit);
  return true;
}

template <std::floating_point T>
Guarantee<T> Cuboid<T>::localGuarantee() const {
  return Guarantee<T>::exact(detail::farther(box_.lower, box_.upper));
}

template <std::floating_point T>
Box<T> Cuboid<T>::localBoundingBox() const {
  return localGuarantee().grown(box_);
}

template class Cuboid<float>;
template class Cuboid<double>;

}  // namespace cutwater
