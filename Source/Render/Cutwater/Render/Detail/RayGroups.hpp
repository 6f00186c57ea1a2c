#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Render/CutPlane.hpp>

#include <span>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// A ray, and how far along it nothing is visible.
struct GroupedRay {
  const Ray* ray;
  double end;  ///< of its range
  double along;
};

/// Advances rays together: at equal distances along, those of a group are all within some radius
/// of the first of them, and what is known to be free about that one is known for all. Groups of
/// all rays are followed by groups of a quarter of them, and so on; neighbours in the span should
/// be close to each other. No ray is advanced past a place that is within `reach`, in pixels, of
/// the surface.
///
/// `freeAbout(points, radii)` computes lower bounds on the distances of points to the surface; not
/// positive where none is known.
///
/// J. Amanatides 1984, "Ray tracing with cones"; here only to skip what is empty.
using FreeRadii = FunctionRef<void(std::span<const Vec3<double>> points, std::span<double> radii)>;
void advanceTogether(std::span<GroupedRay> rays, const Camera& camera, double reach,
                     FreeRadii freeAbout);

}  // namespace cutwater::detail
