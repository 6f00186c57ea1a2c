#include <Cutwater/Core/Detail/Epsilon.hpp>
#include <Cutwater/Operations/Detail/DerivedGuarantee.hpp>
#include <Cutwater/Operations/Detail/Images.hpp>
#include <Cutwater/Operations/Detail/Inversion.hpp>

#include <algorithm>
#include <array>

namespace cutwater {

namespace {

using detail::kEps;

/// Any nearer to the origin, squares of image points would overflow.
template <std::floating_point T>
constexpr T kNearest = sizeof(T) == sizeof(float) ? T(0x1p-60) : T(0x1p-500);

template <std::floating_point T>
Vec3<T> image(const Vec3<T>& p, T radius) {
  return (p / radius) / radius;
}

}  // namespace

template <std::floating_point T>
Inversion<T>::Inversion(Solid<T> operand) : UnaryOperation<T>(std::move(operand)) {
  const auto promise = this->operand().guarantee();
  const auto box = this->operand().boundingBox();
  const bool isBound = std::min(promise.outside, promise.inside) != Quality::SignOnly;
  const bool isExact = std::min(promise.outside, promise.inside) == Quality::Exact;
  if (isExact && promise.lipschitz && *promise.lipschitz <= 1 && isFinite(box) && !box.empty()) {
    surfaceRadius_ = length(max(abs(box.lower), abs(box.upper))) * (1 + 8 * kEps<T>);
  }
  if (!isBound && promise.lipschitz) divisor_ = std::max(*promise.lipschitz, T(1));
  if (promise.lipschitz && *promise.lipschitz <= divisor_) {
    const T rounding = promise.error(T(0));
    const T value = std::abs(this->operand().signedDistance({}));
    distanceAtOrigin_ = std::max((value - rounding) / divisor_, T(0));
  }
  deriveGuarantee();
  deriveBoundingBox();
}

template <std::floating_point T>
void Inversion<T>::deriveGuarantee() {
  const auto promise = this->operand().guarantee();
  const bool isBound = std::min(promise.outside, promise.inside) != Quality::SignOnly;
  guarantee_ = promise;
  const bool isBoundHere = isBound || (promise.lipschitz && promise.continuous);
  guarantee_.outside = guarantee_.inside = isBoundHere ? Quality::LowerBound : Quality::SignOnly;
  if (promise.lipschitz) {
    guarantee_.lipschitz = std::max(*promise.lipschitz / divisor_, T(1));
  }
  if (promise.domain != Box<T>::everywhere()) guarantee_.domain = {};
  // D has an error of u eps (1/r + size), which changes the value by 1 / (1/r + D)^2 times that,
  // which is at most min(r^2, 1/D(0)^2), or by r / R where R decides. With
  // min(r^2, 1/D(0)^2) <= r / D(0), the sum is u eps r (1 + size / D(0) + size / R) + u eps / R.
  constexpr T kMost = 64;
  T growth = promise.size > 0 ? promise.size / distanceAtOrigin_ : T(0);
  if (!(growth <= kMost)) {
    growth = kMost;
    const T half = kMost / (2 * promise.size);
    guarantee_.domain = guarantee_.domain.intersection({{-half, -half, -half}, {half, half, half}});
  }
  growth += 1 + promise.size / surfaceRadius_;
  guarantee_.ulps =
      (promise.ulps + 4 * std::max(promise.lipschitz.value_or(T(1)), T(1)) + 4) * growth;
  guarantee_.size = 1 / surfaceRadius_ + kNearest<T> / kEps<T>;
}

template <std::floating_point T>
void Inversion<T>::deriveBoundingBox() {
  // No part of the operand is nearer to the origin than this.
  const auto box = this->operand().boundingBox();
  T nearest = box.empty() ? Box<T>::kInf : length(max(Vec3<T>{}, max(box.lower, -box.upper)));
  if (this->operand().signedDistance({}) > 0) nearest = std::max(nearest, distanceAtOrigin_);
  boundingBox_ = Box<T>::everywhere();
  if (nearest == Box<T>::kInf) {
    boundingBox_ = {};
  } else if (nearest > 0 && std::isfinite(1 / nearest)) {
    boundingBox_ = guarantee_.grown(Box<T>{{}, {}}.grown((1 + 8 * kEps<T>) / nearest));
  }
}

template <std::floating_point T>
bool Inversion<T>::isOrigin(T radius) const {
  // Within eps / R, the value is 1 / R up to rounding.
  return !(radius > kNearest<T>) || radius * surfaceRadius_ < kEps<T>;
}

template <std::floating_point T>
T Inversion<T>::bound(T value, T radius) const {
  return std::max(std::abs(value) / divisor_, 1 / radius - surfaceRadius_);
}

template <std::floating_point T>
T Inversion<T>::valueFrom(T value, T radius) const {
  const T distance = bound(value, radius);
  if (distance == 0) return 0;
  const T ratio = distance * radius;
  const T byRatio = ratio < Box<T>::kMost ? radius * (ratio / (1 + ratio)) : radius;
  const T magnitude = std::max(byRatio, (distance / surfaceRadius_) * radius);
  return value < 0 ? -magnitude : magnitude;
}

template <std::floating_point T>
T Inversion<T>::localSignedDistance(const Vec3<T>& p) const {
  const T radius = length(p);
  if (isOrigin(radius)) return valueAtOrigin();
  return valueFrom(this->operand().signedDistance(image(p, radius)), radius);
}

template <std::floating_point T>
void Inversion<T>::localSignedDistances(std::span<const Vec3<T>> points,
                                        std::span<T> distances) const {
  const auto imageOf = [this](const Vec3<T>& p) {
    const T radius = length(p);
    return isOrigin(radius) ? Vec3<T>{} : image(p, radius);
  };
  detail::forImages(points, imageOf, [&](std::span<const Vec3<T>> images, std::size_t first) {
    const auto values = distances.subspan(first, images.size());
    this->operandValues(images, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const T radius = length(points[first + i]);
      values[i] = isOrigin(radius) ? valueAtOrigin() : valueFrom(values[i], radius);
    }
  });
}

template <std::floating_point T>
Vec3<T> Inversion<T>::localGradient(const Vec3<T>& p) const {
  const T radius = length(p);
  if (isOrigin(radius)) return {};
  const Vec3<T> outward = p / radius;
  const Vec3<T> q = image(p, radius);
  const T value = this->operand().signedDistance(q);
  const T side = value < 0 ? T(-1) : T(1);
  const T distance = bound(value, radius);

  // The gradient of D: the inversion mirrors directions and stretches by 1 / r^2.
  Vec3<T> slope = -outward;  // times r^2; here that of 1/r - R
  if (distance == std::abs(value) / divisor_) {
    const Vec3<T> there = (side / divisor_) * this->operand().gradient(q);
    slope = there - (2 * dot(there, outward)) * outward;
  }
  const T ratio = distance * radius;
  if (1 + ratio >= surfaceRadius_ * radius) {  // R decides
    return (side / surfaceRadius_) * (slope / radius + distance * outward);
  }
  const T weight = 1 / ((1 + ratio) * (1 + ratio));
  return side * (weight * slope + (1 - weight) * outward);
}

template <std::floating_point T>
SurfaceOwner Inversion<T>::localOwner(const Vec3<T>& p) const {
  const T radius = length(p);
  return isOrigin(radius) ? SurfaceOwner{} : this->operand().owner(image(p, radius));
}

template class Inversion<float>;
template class Inversion<double>;

}  // namespace cutwater
