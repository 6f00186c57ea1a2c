#include <Cutwater/Core/Detail/DomainUnder.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <array>

namespace cutwater::detail {

namespace {

/// Walks from a point to the surface, down (or up) the gradient.
template <std::floating_point T>
class Projection {
 public:
  Projection(const Field<T>& field, const Vec3<T>& p)
      : field_(field), point_(p), residual_(field.value(p)) {
    quality_ = field.guarantee.quality(residual_);
    start_ = p;
    startValue_ = residual_;
    reach_ = kFarthest * (length(p) + std::abs(residual_) + field.guarantee.size);
  }

  SurfacePoint<T> run() {
    constexpr int kMostSteps = 96;
    std::array<Vec3<T>, 4> trail;  // the previous points
    for (std::size_t step = 0; step < kMostSteps && !arrived(); ++step) {
      trail[step % 4] = point_;
      if (!moveTo(limited(point_ - (residual_ / lengthSquared(slope())) * slope_))) break;
      if (step % 4 == 3) leapAlong(trail[0], trail[2]);
    }
    if (normal_ == Vec3<T>{}) normal_ = normalized(slope());  // p was on the surface

    SurfacePoint<T> result;
    result.point = point_;
    result.distance = startValue_;
    result.owner = field_.owner(point_);
    result.normal = normal_;
    setTolerance(result, start_, residual_, field_.guarantee);
    return result;
  }

 private:
  /// In units of the sum of all known lengths. Where the gradient nearly vanishes, as it does if
  /// there is no surface at all, steps could end anywhere, and a value far away may take very long
  /// to compute.
  static constexpr T kFarthest = 64;

  /// `next`, or the point on the way to it at the greatest distance allowed.
  [[nodiscard]] Vec3<T> limited(const Vec3<T>& next) const {
    const T distance = length(next - start_);
    return distance > reach_ ? start_ + (reach_ / distance) * (next - start_) : next;
  }
  [[nodiscard]] T rounding() const { return field_.guarantee.error(length(point_)); }
  [[nodiscard]] bool arrived() const { return std::abs(residual_) <= rounding(); }

  /// The gradient of an exact distance is a unit vector; if a computed one is not (by differences
  /// across a kink), it is of no use.
  [[nodiscard]] bool isUseful(const Vec3<T>& gradient) const {
    const T squared = lengthSquared(gradient);
    return quality_ == Quality::Exact ? std::abs(squared - 1) < T(0.1) : squared > T(1e-12);
  }

  /// The gradient here or, where it is undefined because several surface points are equally near,
  /// just beside, where one of them is nearest. The first distances tried are of the size of
  /// rounding; the others are beyond the reach of centred differences.
  const Vec3<T>& slope() {
    slope_ = field_.gradient(point_);
    const T wide =
        4 * std::cbrt(std::numeric_limits<T>::epsilon()) * (length(point_) + field_.guarantee.size);
    for (const T distance : {rounding(), -rounding(), wide, -wide}) {
      if (isUseful(slope_)) return slope_;
      // Not in any plane of symmetry that a person is likely to choose.
      slope_ = field_.gradient(point_ + distance * Vec3<T>{T(0.48), T(0.64), T(0.6)});
    }
    if (!isUseful(slope_)) slope_ = steepest();
    return slope_;
  }

  /// Without a gradient: the one of six directions that leads nearest to the surface.
  [[nodiscard]] Vec3<T> steepest() const {
    Vec3<T> best{residual_ < 0 ? T(-1) : T(1), 0, 0};
    T bestValue = std::numeric_limits<T>::infinity();
    for (int side = 0; side < 6; ++side) {
      Vec3<T> direction;
      direction[side / 2] = side % 2 == 0 ? T(1) : T(-1);
      const T there = std::abs(field_.value(point_ - residual_ * direction));
      if (there < bestValue) best = direction, bestValue = there;
    }
    return best;
  }

  bool moveTo(const Vec3<T>& next) {
    if (next == point_ || !isFinite(next)) return false;
    // The gradient of an exact distance is constant along the step, so this is the normal where the
    // step ends, also at an edge; later steps only remove rounding from the point.
    const bool isFirst = normal_ == Vec3<T>{};
    if (isFirst || quality_ != Quality::Exact) normal_ = normalized(slope_);
    point_ = next;
    residual_ = field_.value(next);
    return true;
  }

  /// Where two surfaces meet at an edge, steps alternate between them and converge linearly. Sums
  /// the geometric series (Aitken's extrapolation) if that leads nearer.
  void leapAlong(const Vec3<T>& first, const Vec3<T>& second) {
    if (arrived()) return;
    const T before = length(second - first);
    const T ratio = length(point_ - second) / before;
    if (!(ratio < 1)) return;
    const Vec3<T> limit = limited(point_ + (ratio / (1 - ratio)) * (point_ - second));
    const T there = field_.value(limit);
    if (std::abs(there) < std::abs(residual_)) point_ = limit, residual_ = there;
  }

  const Field<T>& field_;
  Vec3<T> start_;
  T startValue_{};
  T reach_{};
  Vec3<T> point_;
  T residual_;
  Quality quality_{};
  Vec3<T> slope_;
  Vec3<T> normal_;
};

}  // namespace

template <std::floating_point T>
SurfacePoint<T> projectedPoint(const Field<T>& field, const Vec3<T>& p) {
  return Projection<T>(field, p).run();
}

template <std::floating_point T>
std::optional<SurfacePoint<T>> steppedPoint(FunctionRef<T(const Vec3<T>&)> value, const Vec3<T>& p,
                                            T atP, const Vec3<T>& gradient,
                                            const Guarantee<T>& guarantee) {
  if (gradient == Vec3<T>{}) return {};
  SurfacePoint<T> found;
  found.distance = atP;
  found.normal = gradient;
  found.point = p - atP * gradient;
  const T residual = value(found.point);
  const T allowed = guarantee.error(length(p) + length(found.point));
  if (!(std::abs(residual) <= allowed)) return {};
  setTolerance(found, p, residual, guarantee);
  return found;
}

template <std::floating_point T>
void setTolerance(SurfacePoint<T>& result, const Vec3<T>& p, T residual,
                  const Guarantee<T>& guarantee) {
  if (guarantee.quality(result.distance) == Quality::SignOnly) return;
  if (!guarantee.domain.contains(p)) return;
  // The surface is no nearer than |value|, and one of its points is this much farther away.
  const T gap = length(result.point - p) - std::abs(result.distance);
  const T rounding = guarantee.error(length(p) + length(result.point));
  result.exact = guarantee.domain.contains(result.point) && std::abs(residual) <= rounding &&
                 gap <= 2 * rounding;
  result.tolerance = std::max(gap, T(0)) + std::abs(residual) + rounding;
}

template <std::floating_point T>
Interval<T> boundsAround(T atCenter, const OrientedBox<T>& box, const Guarantee<T>& guarantee) {
  const T radius = box.radius();
  // Twice the rounding: that of this value, and that of the values in the box to be enclosed.
  const T margin = *guarantee.lipschitz * radius + 2 * guarantee.error(length(box.center) + radius);
  const T outward = 4 * std::numeric_limits<T>::epsilon() * (std::abs(atCenter) + margin);
  return Interval<T>{atCenter - margin, atCenter + margin}.grown(outward);
}

template <std::floating_point T>
Interval<T> boundsWithin(const Interval<T>& range, T atCenter, const OrientedBox<T>& box,
                         const Guarantee<T>& guarantee) {
  const auto around = boundsAround(atCenter, box, guarantee);
  const T margin = 2 * guarantee.error(length(box.center) + box.radius());
  return {std::max(around.lower, range.lower - margin),
          std::min(around.upper, range.upper + margin)};
}

template <std::floating_point T>
Interval<T> distanceRange(const Interval<T>& values, const Guarantee<T>& guarantee) {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  // The weaker quality of the sides that the values may be on.
  auto quality = Quality::Exact;
  if (values.lower < 0) quality = std::min(quality, guarantee.inside);
  if (values.upper >= 0) quality = std::min(quality, guarantee.outside);
  if (quality == Quality::SignOnly) return {0, kInf};
  return {std::max({T(0), values.lower, -values.upper}),
          quality == Quality::Exact ? std::max(-values.lower, values.upper) : kInf};
}

template <std::floating_point T>
Guarantee<T> placed(Guarantee<T> local, const RigidTransform<T>& placement) {
  if (placement.isIdentity()) return local;
  // The motion moves the point by up to one rounding error of the offset's size, and a
  // rotation by up to eight more; the value changes accordingly, by the Lipschitz constant.
  local.ulps += local.lipschitz.value_or(T(1)) * (placement.isRotated() ? T(9) : T(1));
  local.size += length(placement.offset());
  if (!placement.isRotated()) {
    local.domain.lower += placement.offset();
    local.domain.upper += placement.offset();
    return local;
  }
  AffineMap<T> map;
  AffineMap<T> inverse;
  map.offset = placement.offset();
  for (int i = 0; i < 3; ++i) {
    map.columns[static_cast<std::size_t>(i)] = placement.axis(i);
    for (int j = 0; j < 3; ++j) {
      inverse.columns[static_cast<std::size_t>(i)][j] = placement.axis(j)[i];
    }
  }
  local.domain = detail::domainUnder(map, inverse, local.domain);
  return local;
}

template SurfacePoint<float> projectedPoint(const Field<float>&, const Vec3<float>&);
template SurfacePoint<double> projectedPoint(const Field<double>&, const Vec3<double>&);
template std::optional<SurfacePoint<float>> steppedPoint(FunctionRef<float(const Vec3<float>&)>,
                                                         const Vec3<float>&, float,
                                                         const Vec3<float>&,
                                                         const Guarantee<float>&);
template std::optional<SurfacePoint<double>> steppedPoint(FunctionRef<double(const Vec3<double>&)>,
                                                          const Vec3<double>&, double,
                                                          const Vec3<double>&,
                                                          const Guarantee<double>&);
template void setTolerance(SurfacePoint<float>&, const Vec3<float>&, float,
                           const Guarantee<float>&);
template void setTolerance(SurfacePoint<double>&, const Vec3<double>&, double,
                           const Guarantee<double>&);
template Interval<float> boundsAround(float, const OrientedBox<float>&, const Guarantee<float>&);
template Interval<double> boundsAround(double, const OrientedBox<double>&,
                                       const Guarantee<double>&);
template Interval<float> boundsWithin(const Interval<float>&, float, const OrientedBox<float>&,
                                      const Guarantee<float>&);
template Interval<double> boundsWithin(const Interval<double>&, double, const OrientedBox<double>&,
                                       const Guarantee<double>&);
template Interval<float> distanceRange(const Interval<float>&, const Guarantee<float>&);
template Interval<double> distanceRange(const Interval<double>&, const Guarantee<double>&);
template Guarantee<float> placed(Guarantee<float>, const RigidTransform<float>&);
template Guarantee<double> placed(Guarantee<double>, const RigidTransform<double>&);

}  // namespace cutwater::detail
