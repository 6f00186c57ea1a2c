#include <Cutwater/Render/Detail/Sighting.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// A ray whose direction has a smaller component towards the surface runs along it.
constexpr double kSlowest = 0.02;

SurfaceSample sampleOf(const Ray& ray, double along, Vec3<double> normal, std::uint32_t surface) {
  if (dot(normal, ray.direction) > 0) normal = -normal;
  if (!(lengthSquared(normal) > 0.5)) normal = -ray.direction;  // none is known
  SurfaceSample sample;
  sample.along = along;
  sample.normal = Vec3<float>(normal);
  sample.surface = surface;
  return sample;
}

}  // namespace

template <std::floating_point T>
SurfaceSample Sighting<T>::atCut(const RayRange& range) const {
  SurfaceSample sample;
  sample.along = range.begin;
  sample.normal = Vec3<float>(region_.normal(range.cut));
  sample.surface = SurfaceSample::kCutFace + range.cut;
  return sample;
}

template <std::floating_point T>
SurfaceSample Sighting<T>::atCrossing(const Ray& ray, double along,
                                      const Crossing<T>& crossing) const {
  const Vec3<double> normal(crossing.normal);
  return sampleOf(ray, along, normal,
                  patchAt(crossing.point, normal, crossing.owner.patch, ray, along));
}

template <std::floating_point T>
SurfaceSample Sighting<T>::atFacet(const Ray& ray, const FacetHit& hit) {
  return sampleOf(ray, hit.along, hit.normal, hit.patch);
}

template <std::floating_point T>
SurfaceSample Sighting<T>::near(const Ray& ray, const RayRange& range, double along,
                                const SurfacePoint<T>& nearest) const {
  const Vec3<double> normal(nearest.normal);
  // Towards the tangent plane, unless the ray runs along it.
  const double speed = dot(normal, ray.direction);
  const double further = dot(normal, Vec3<double>(nearest.point) - ray.at(along)) / speed;
  const double most = camera_.pixelSize(along);
  if (std::abs(speed) > kSlowest && std::abs(further) < most) along += further;
  along = std::clamp(along, range.begin, range.end);
  return sampleOf(ray, along, normal,
                  patchAt(nearest.point, normal, nearest.owner.patch, ray, along));
}

/// The patch to show where sheets coincide, up to rounding of their closest points: the first of
/// those that face the viewer, or of all if none does. The surface of a solid faces the viewer
/// unless another sheet, turned against it, is at the same place.
template <std::floating_point T>
std::uint32_t Sighting<T>::patchAt(const Vec3<T>& foot, const Vec3<double>& normal,
                                   std::uint32_t patch, const Ray& ray, double along) const {
  if (!sheets_ && dot(normal, ray.direction) < 0) return patch;
  const T reach = static_cast<T>(kSamePlace * camera_.pixelSize(along));
  const Vec3<T> toViewer = -Vec3<T>(ray.direction);
  bool found = false;
  bool faces = false;
  solid_.facetsIn(Box<T>{foot, foot}.grown(reach), [&](const SurfaceFacet<T>& facet) {
    const bool isThere = std::abs(dot(facet.corners[0] - foot, facet.normal)) <= reach;
    const bool looks = dot(facet.normal, toViewer) > 0;
    if (!isThere || (faces && !looks)) return true;
    patch = found && faces == looks ? std::min(patch, facet.owner.patch) : facet.owner.patch;
    found = true;
    faces = looks;
    return true;
  });
  return patch;
}

template <std::floating_point T>
SurfaceSample Sighting<T>::passing(const Ray& ray, const FacetPass& nearest, double reach) const {
  const auto away = ray.at(nearest.along) - nearest.point;
  const double pixel = camera_.pixelSize(nearest.along);
  const double removed = region_.clearance(nearest.point);
  SurfaceSample sample;
  if (!(length(away) < reach * pixel && removed < kSamePlace * pixel)) return sample;
  sample.along = nearest.along;
  sample.normal = Vec3<float>(normalized(away));
  sample.passed = nearest.patch;
  return sample;
}

template class Sighting<float>;
template class Sighting<double>;

}  // namespace cutwater::detail
