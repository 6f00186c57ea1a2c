#include <Cutwater/Shapes/Detail/Arguments.hpp>
#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater::detail {

template <std::floating_point T>
ConeSphereProfile<T>::ConeSphereProfile(const char* name, const Vec3<T>& a, const Vec3<T>& b,
                                        T radiusA, T radiusB)
    : radiusA_(radiusA),
      radiusB_(radiusB),
      length_(distanceBetween(a, b)),
      isBall_(std::abs(radiusA - radiusB) >= length_) {
  requireRadii(name, radiusA, radiusB);
  if (isBall_) return;
  const T delta = radiusA - radiusB;
  sine_ = delta / length_;
  // This form keeps its digits where one ball nearly contains the other.
  cosine_ = std::sqrt((length_ - delta) / length_) * std::sqrt((length_ + delta) / length_);
}

template <std::floating_point T>
auto ConeSphereProfile<T>::nearestPart(const ProfilePoint<T>& p) const -> Part {
  if (isBall_) return radiusA_ >= radiusB_ ? Part::BallA : Part::BallB;
  const T t = p.axial * cosine_ - p.radial * sine_;
  return t <= 0 ? Part::BallA : t >= length_ * cosine_ ? Part::BallB : Part::Cone;
}

template <std::floating_point T>
T ConeSphereProfile<T>::distance(const ProfilePoint<T>& p) const {
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
ProfilePoint<T> ConeSphereProfile<T>::gradient(const ProfilePoint<T>& p) const {
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
Box<T> ConeSphereProfile<T>::box(const RotationAxis<T>& axis) const {
  return axis.ballBox(0, radiusA_).extend(axis.ballBox(length_, radiusB_));
}

template <std::floating_point T>
auto ConeSphereProfile<T>::hull() const -> Hull {
  if (!isBall_) return {0, length_, radiusA_, sine_, cosine_};
  return {radiusA_ >= radiusB_ ? T(0) : length_, 0, largestRadius(), 0, 1};
}

template class ConeSphereProfile<float>;
template class ConeSphereProfile<double>;

}  // namespace cutwater::detail
