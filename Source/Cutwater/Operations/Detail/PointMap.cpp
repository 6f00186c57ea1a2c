#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Images.hpp>
#include <Cutwater/Operations/Detail/PointMap.hpp>

namespace cutwater {

template <std::floating_point T>
T PointMap<T>::localSignedDistance(const Vec3<T>& p) const {
  return factor() * this->operand().signedDistance(mapped(p));
}

template <std::floating_point T>
T PointMap<T>::localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const {
  return factor() *
         this->operand().signedDistanceWithin(mapped(p), this->wantedOverFactor(wanted, factor()));
}

template <std::floating_point T>
void PointMap<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                       std::span<T> distances) const {
  detail::forImages(
      points, [this](const Vec3<T>& p) { return mapped(p); },
      [&](std::span<const Vec3<T>> images, std::size_t first) {
        const auto values = distances.subspan(first, images.size());
        this->operandValues(images, values);
        for (auto& value : values) value *= factor();
      });
}

template <std::floating_point T>
Vec3<T> PointMap<T>::localGradient(const Vec3<T>& p) const {
  return factor() * pulledBack(p, this->operand().gradient(mapped(p)));
}

template <std::floating_point T>
SurfaceOwner PointMap<T>::localOwner(const Vec3<T>& p) const {
  return this->operand().owner(mapped(p));
}

template <std::floating_point T>
Interval<T> PointMap<T>::localBounds(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto range = this->boundsOf(this->operand(), mapped(box));
  const T outward = 2 * std::numeric_limits<T>::epsilon();
  const auto scaled = [&](T bound, T side) {
    const T value = factor() * bound;
    return std::isfinite(value) ? value + side * outward * std::abs(value) : bound;
  };
  return detail::intersection(SignedDistanceFunction<T>::localBounds(box, hint),
                              {scaled(range.lower, -1), scaled(range.upper, 1)});
}

template <std::floating_point T>
BoxClass PointMap<T>::localClassify(const OrientedBox<T>& box, BoxHint* hint) const {
  const auto byValues = SignedDistanceFunction<T>::localClassify(box, hint);
  if (byValues != BoxClass::Unknown) return byValues;
  // The mapped box only encloses the image: its class is certain only if it is free of surface.
  const auto ofImage = this->classOf(this->operand(), mapped(box));
  return ofImage == BoxClass::Cut ? BoxClass::Unknown : ofImage;
}

template class PointMap<float>;
template class PointMap<double>;

}  // namespace cutwater
