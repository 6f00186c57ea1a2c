#include <Cutwater/Render/Detail/SolidTracer.hpp>

#include <algorithm>

namespace cutwater::detail {

namespace {

template <std::floating_point T>
const FacetRays* facetsOf(const SolidPart<T>& part) {
  return part.facets ? &*part.facets : nullptr;
}

}  // namespace

template <std::floating_point T>
SolidTracer<T>::SolidTracer(const SignedDistanceFunction<T>& solid,
                            std::span<const SolidPart<T>> parts, const KeptRegion& region,
                            const Camera& camera, TraceOptions options)
    : whole_(solid, region, camera, [&] {
        options.facets = parts.size() == 1 ? facetsOf(parts.front()) : nullptr;
        return options;
      }()) {
  for (const auto& part : parts) {
    options.facets = facetsOf(part);
    options.patches = part.patches;
    tracers_.emplace_back(*part.solid, region, camera, options);
  }
}

template <std::floating_point T>
void SolidTracer<T>::trace(std::span<const PicturePoint> points, const RaySpread& spread,
                           std::span<SurfaceSample> samples) const {
  std::ranges::fill(samples.first(points.size()), SurfaceSample{});
  for (const auto& tracer : tracers_) tracer.trace(points, spread, samples);
}

template class SolidTracer<float>;
template class SolidTracer<double>;

}  // namespace cutwater::detail
