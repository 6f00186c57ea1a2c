#include <Cutwater/Core/Detail/UnitVector.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/HalfSpaceFaces.hpp>
#include <Cutwater/Shapes/Detail/ShapeSurfaces.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
ConvexPolyhedron<T>::ConvexPolyhedron(const std::vector<HalfSpace<T>>& halfSpaces) {
  std::vector<detail::ExactHalfSpace> exact;
  for (const auto& [point, normal] : halfSpaces) {
    detail::requireFinite("ConvexPolyhedron", "point", point);
    static_cast<void>(detail::unitVector("ConvexPolyhedron", "normal", normal));
    exact.push_back({Vec3<double>(point), Vec3<double>(normal)});
  }
  for (const auto& face : detail::halfSpaceFaces("ConvexPolyhedron", exact)) {
    const auto& normal = exact[face.plane].normal;
    const auto unit = detail::unitVector("ConvexPolyhedron", "normal", normal);
    const auto first = static_cast<std::uint32_t>(sides_.size());
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto& [start, across] = face.corners[i];
      const auto& end = face.corners[(i + 1) % face.corners.size()].position;
      const auto along = detail::sideDirection(normal, exact[across].normal);
      const double reach = std::max(dot(end - start, along), 0.0);
      sides_.push_back(
          {Vec3<T>(start), Vec3<T>(along), Vec3<T>(cross(along, unit)), static_cast<T>(reach)});
      box_.extend(sides_.back().start);
      size_ = std::max(size_, length(sides_.back().start));
    }
    faces_.push_back({Vec3<T>(unit), first, static_cast<std::uint32_t>(sides_.size())});
  }
}

template <std::floating_point T>
T ConvexPolyhedron<T>::height(const Face& face, const Vec3<T>& p) const {
  return dot(p - sides_[face.first].start, face.normal);
}

template <std::floating_point T>
Vec3<T> ConvexPolyhedron<T>::fromFace(const Face& face, const Vec3<T>& p) const {
  const Vec3<T> fromPlane = height(face, p) * face.normal;
  Vec3<T> best = fromPlane;
  T least = std::numeric_limits<T>::max();
  for (auto i = face.first; i < face.last; ++i) {
    const auto& side = sides_[i];
    const Vec3<T> fromStart = p - side.start;
    const T beyond = dot(fromStart, side.outward);
    if (!(beyond > 0)) continue;
    const T along = dot(fromStart, side.along);
    Vec3<T> gap = fromPlane + beyond * side.outward;
    if (along <= 0) gap = fromStart;
    if (along >= side.length) gap = p - sides_[i + 1 < face.last ? i + 1 : face.first].start;
    const T squared = lengthSquared(gap);
    if (squared < least) least = squared, best = gap;
  }
  return best;
}

template <std::floating_point T>
Vec3<T> ConvexPolyhedron<T>::fromSurface(const Vec3<T>& p) const {
  Vec3<T> best;
  T least = std::numeric_limits<T>::infinity();
  // Rounding may place a point below the face it lies on, and above a nearly coplanar one.
  const T rounding = 2 * localGuarantee().error(length(p));
  for (const auto& face : faces_) {
    if (height(face, p) < -rounding) continue;
    const auto gap = fromFace(face, p);
    const T squared = lengthSquared(gap);
    if (squared < least) least = squared, best = gap;
  }
  return best;
}

template <std::floating_point T>
T ConvexPolyhedron<T>::localSignedDistance(const Vec3<T>& p) const {
  T deepest = -std::numeric_limits<T>::infinity();
  for (const auto& face : faces_) deepest = std::max(deepest, height(face, p));
  return deepest < 0 ? deepest : length(fromSurface(p));
}

template <std::floating_point T>
Vec3<T> ConvexPolyhedron<T>::localGradient(const Vec3<T>& p) const {
  T deepest = -std::numeric_limits<T>::infinity();
  Vec3<T> normal;
  bool isUnique = true;
  for (const auto& face : faces_) {
    const T value = height(face, p);
    if (value < deepest) continue;
    isUnique = value > deepest;
    deepest = value;
    normal = face.normal;
  }
  if (deepest > 0) {
    const auto gap = fromSurface(p);
    // Rounding alone may have decided the direction of a shorter one.
    if (length(gap) > 2 * localGuarantee().error(length(p))) return normalized(gap);
  }
  return isUnique ? normal : Vec3<T>{};
}

template <std::floating_point T>
Interval<T> ConvexPolyhedron<T>::localBounds(const OrientedBox<T>& box, BoxHint*) const {
  // A value is at least the height above any plane; inside, it is the largest of these heights.
  Interval<T> highest{-std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity()};
  for (const auto& face : faces_) {
    const T atCenter = height(face, box.center);
    T reach = 2 * box.slack;
    for (const auto& half : box.halfAxis) reach += std::abs(dot(half, face.normal));
    highest.lower = std::max(highest.lower, atCenter - reach);
    highest.upper = std::max(highest.upper, atCenter + reach);
  }
  if (!(highest.upper < 0)) highest.upper = std::numeric_limits<T>::infinity();
  return detail::boundsWithin(highest, localSignedDistance(box.center), box, localGuarantee());
}

template <std::floating_point T>
bool ConvexPolyhedron<T>::localSurfacesIn(const OrientedBox<T>& box,
                                          SurfaceVisitor<T> visit) const {
  for (const auto& face : faces_) {
    if (std::abs(height(face, box.center)) > box.radius()) continue;
    detail::visitPlane(sides_[face.first].start, face.normal, visit);
  }
  return true;
}

template <std::floating_point T>
Guarantee<T> ConvexPolyhedron<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> ConvexPolyhedron<T>::localBoundingBox() const {
  return localGuarantee().grown(box_);
}

template class ConvexPolyhedron<float>;
template class ConvexPolyhedron<double>;

}  // namespace cutwater
