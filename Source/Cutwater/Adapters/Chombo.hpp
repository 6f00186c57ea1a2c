#pragma once

// For code that includes Chombo 3.2, in 3D or 2D and either precision.

#include <Cutwater/Adapters/FluidDomain.hpp>

#include <BaseIF.H>
#include <GeometryService.H>
#include <utility>

namespace cutwater {

/// A FluidDomain as Chombo's implicit function, negative in the fluid. In 2D it is evaluated in the
/// plane at z. Boxes are classified with certainty, which Chombo requests through
/// fastIntersection() and InsideOutside().
///
///     const ChomboIF function({hull, FluidSide::Outside, {0.1, 0.1, 0.1}});
///     GeometryShop shop(function, 0, dx * RealVect::Unit);
class ChomboIF final : public BaseIF {
 public:
  explicit ChomboIF(FluidDomain<Real> domain, Real z = 0) : domain_(std::move(domain)), z_(z) {}

  // Overloads that follow from those below.
  using BaseIF::fastIntersection;
  using BaseIF::InsideOutside;
  using BaseIF::value;

  Real value(const RealVect& point) const override { return domain_.levelSet(pointOf(point)); }

#ifndef USE_STCVECTOR  // otherwise it is the type above
  Real value(const IndexTM<Real, GLOBALDIM>& point) const override {
    return domain_.levelSet(pointOf(point));
  }
#endif

  /// The value, or a first derivative. Higher orders are left to Chombo, which ends the program: a
  /// signed distance need not have such derivatives.
  Real value(const IndexTM<int, GLOBALDIM>& derivative,
             const IndexTM<Real, GLOBALDIM>& point) const override {
    int order = 0;
    int axis = 0;
    for (int i = 0; i < GLOBALDIM; ++i) {
      order += derivative[i];
      if (derivative[i] > 0) axis = i;
    }
    if (order == 0) return domain_.levelSet(pointOf(point));
    if (order == 1) return domain_.gradient(pointOf(point))[axis];
    return BaseIF::value(derivative, point);
  }

  bool fastIntersection(const RealVect& /*low*/, const RealVect& /*high*/) const override {
    return true;
  }

  /// Returns Regular and Covered only if no surface touches the closed box.
  GeometryService::InOut InsideOutside(const RealVect& low, const RealVect& high) const override {
    switch (domain_.classify(Box<Real>{pointOf(low), pointOf(high)})) {
      case FluidClass::Fluid:
        return GeometryService::Regular;
      case FluidClass::Body:
        return GeometryService::Covered;
      default:
        return GeometryService::Irregular;
    }
  }

  /// A copy, which shares the solid. The caller deletes it.
  BaseIF* newImplicitFunction() const override {
    return new ChomboIF(*this);
  }

 private:
  template <typename Point>
  [[nodiscard]] Vec3<Real> pointOf(const Point& p) const {
    if constexpr (CH_SPACEDIM == 3) return {p[0], p[1], p[2]};
    return {p[0], p[1], z_};
  }

  FluidDomain<Real> domain_;
  Real z_;  // of the plane, in 2D
};

}  // namespace cutwater
