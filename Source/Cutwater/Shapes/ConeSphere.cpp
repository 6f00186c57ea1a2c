#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/ConeSphere.hpp>
#include <Cutwater/Shapes/Direction.hpp>

#include <algorithm>

namespace cutwater {

template <std::floating_point T>
ConeSphere<T>::ConeSphere(const Vec3<T>& a, const Vec3<T>& b, T radiusA, T radiusB)
    : Axisymmetric<T>("ConeSphere", a, a == b ? Vec3<T>{0, 0, 1} : b - a),
      radiusA_(radiusA),
      radiusB_(radiusB),
      length_(detail::distanceBetween(a, b)),
      size_(detail::farther(a, b) + std::max(radiusA, radiusB)),
      isBall_(std::abs(radiusA - radiusB) >= length_) {
  require(radiusA >= 0 && radiusB >= 0 && radiusA + radiusB > 0 && std::isfinite(radiusA + radiusB),
          "ConeSphere: need finite radii, none negative and one positive",
          Named{"radiusA", radiusA}, Named{"radiusB", radiusB});
  if (isBall_) return;
  const T delta = radiusA - radiusB;
  sine_ = delta / length_;
  // In this form it keeps its digits where one ball nearly contains the other.
  cosine_ = std::sqrt((length_ - delta) / length_) * std::sqrt((length_ + delta) / length_);
}

template <std::floating_point T>
auto ConeSphere<T>::nearestPart(const ProfilePoint<T>& p) const -> Part {
  if (isBall_) return radiusA_ >= radiusB_ ? Part::BallA : Part::BallB;
  const T t = p.axial * cosine_ - p.radial * sine_;
  return t <= 0 ? Part::BallA : t >= length_ * cosine_ ? Part::BallB : Part::Cone;
}

template <std::floating_point T>
T ConeSphere<T>::profileDistance(const ProfilePoint<T>& p) const {
  switch (nearestPart(p)) {
    case Part::BallA:
      return length(p) - radiusA_;
    case Part::BallB:
      return length(ProfilePoint<T>{p.radial, p.axial - length_}) - radiusB_;
    default:
      return p.axial * sine_ + p.radial * cosine_ - radiusA_;
  }
}

template <std::floating_point T>
ProfilePoint<T> ConeSphere<T>::profileGradient(const ProfilePoint<T>& p) const {
  switch (nearestPart(p)) {
    case Part::BallA:
      return normalized(p);
    case Part::BallB:
      return normalized(ProfilePoint<T>{p.radial, p.axial - length_});
    default:
      return {cosine_, sine_};
  }
}

template <std::floating_point T>
Guarantee<T> ConeSphere<T>::localGuarantee() const {
  return Guarantee<T>::exact(size_);
}

template <std::floating_point T>
Box<T> ConeSphere<T>::localBoundingBox() const {
  const auto ballA = this->ballBox(0, radiusA_);
  const auto ballB = this->ballBox(length_, radiusB_);
  return localGuarantee().grown(Box<T>{ballA}.extend(ballB));
}

template class ConeSphere<float>;
template class ConeSphere<double>;

}  // namespace cutwater
