#pragma once

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <cmath>

// [DOCS
/// All points common to two balls whose centres are `offset` above and below the origin.
///
///     f(p) = |p - the farther centre| - radius        where that meets the surface
///     f(p) = distance to the rim                      elsewhere: exact on both sides
///
/// @throws Error unless 0 < offset < radius < infinity.
class Lens final : public cutwater::SignedDistanceFunction<double> {
  using Point = cutwater::Vec3<double>;

 public:
  Lens(double radius, double offset) : radius_(radius), offset_(offset) {
    cutwater::require(0 < offset && offset < radius && std::isfinite(radius),
                      "Lens: need 0 < offset < radius < infinity",
                      cutwater::Named{"offset", offset}, cutwater::Named{"radius", radius});
    rim_ = std::sqrt((radius - offset) * (radius + offset));
  }

 private:
  double localSignedDistance(const Point& p) const override {
    return isBeyondRim(p) ? length(outward(p)) : length(outward(p)) - radius_;
  }
  Point localGradient(const Point& p) const override { return normalized(outward(p)); }
  cutwater::Guarantee<double> localGuarantee() const override {
    return cutwater::Guarantee<double>::exact(radius_ + offset_);
  }
  cutwater::Box<double> localBoundingBox() const override {
    const Point half{rim_, rim_, radius_ - offset_};
    return localGuarantee().grown({Point{} - half, half});
  }
  std::string localName() const override { return "Lens"; }

  static double radial(const Point& p) { return std::sqrt(p.x * p.x + p.y * p.y); }
  /// Beyond the cone of the farther sphere's normals along the rim.
  bool isBeyondRim(const Point& p) const {
    return (radial(p) - rim_) * offset_ > std::abs(p.z) * rim_;
  }
  /// To the point, from the rim or from the centre of the sphere whose surface is nearest.
  Point outward(const Point& p) const {
    if (!isBeyondRim(p)) return {p.x, p.y, p.z + std::copysign(offset_, p.z)};
    const double fromRim = (radial(p) - rim_) / radial(p);
    return {p.x * fromRim, p.y * fromRim, p.z};
  }

  double radius_;
  double offset_;
  double rim_;  // radius of the circle in which the spheres meet
};
// DOCS]
