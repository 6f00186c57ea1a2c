#include <Cutwater/Adapters/FluidDomain.hpp>
#include <Cutwater/Core/Error.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

template <std::floating_point T>
FluidDomain<T>::FluidDomain(Solid<T> solid, FluidSide side, const Vec3<T>& fluidPoint)
    : solid_(std::move(solid)), side_(side) {
  const T distance = solid_.signedDistance(fluidPoint);
  require(levelSet(fluidPoint) < 0,
          side == FluidSide::Outside
              ? "FluidDomain: with fluid outside of the solid, the point that must be fluid is not"
              : "FluidDomain: with fluid inside of the solid, the point that must be fluid is not",
          Named{"fluidPoint", fluidPoint}, Named{"signed distance", distance});
}

template <std::floating_point T>
T FluidDomain<T>::levelSet(const Vec3<T>& point) const {
  return asLevelSet(solid_.signedDistance(point));
}

template <std::floating_point T>
void FluidDomain<T>::levelSets(std::span<const Vec3<T>> points, std::span<T> values,
                               const ParallelOptions& options) const {
  solid_.signedDistances(points, values, options);
  for (T& value : values) value = asLevelSet(value);
}

template <std::floating_point T>
Vec3<T> FluidDomain<T>::gradient(const Vec3<T>& point) const {
  const Vec3<T> outward = solid_.gradient(point);
  return side_ == FluidSide::Inside ? outward : Vec3<T>{} - outward;
}

template <std::floating_point T>
FluidClass FluidDomain<T>::asFluid(BoxClass kind) const {
  const bool fluidInside = side_ == FluidSide::Inside;
  switch (kind) {
    case BoxClass::Inside:
      return fluidInside ? FluidClass::Fluid : FluidClass::Body;
    case BoxClass::Outside:
      return fluidInside ? FluidClass::Body : FluidClass::Fluid;
    case BoxClass::Cut:
      return FluidClass::Cut;
    default:
      return FluidClass::Unknown;
  }
}

template <std::floating_point T>
FluidClass FluidDomain<T>::classify(const Box<T>& box, BoxHint* hint) const {
  return asFluid(solid_.classify(box, hint));
}

template <std::floating_point T>
void FluidDomain<T>::classify(std::span<const Box<T>> boxes, std::span<FluidClass> classes,
                              const ParallelOptions& options) const {
  std::vector<BoxClass> kinds(classes.size());
  solid_.classify(boxes, kinds, {}, options);
  std::ranges::transform(kinds, classes.begin(), [&](BoxClass kind) { return asFluid(kind); });
}

template class FluidDomain<float>;
template class FluidDomain<double>;

}  // namespace cutwater
