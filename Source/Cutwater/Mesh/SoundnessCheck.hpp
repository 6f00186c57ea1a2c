#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Mesh/SurfaceLocation.hpp>
#include <Cutwater/Mesh/TriangleSurfaceData.hpp>

namespace cutwater {

/// How many of some places of a closed surface bound a solid.
struct SoundnessProbes {
  std::size_t probes = 0;
  std::size_t unsound = 0;  ///< not with winding number 0 just before and 1 just behind
};

/// Looks at `count` places, spread evenly over the list of triangles and over their area, and at
/// the middles of those in `always`; triangles without area are left out. Just beside means 2^-40
/// of the surface's size away, so sheets closer together than that count as unsound. In parallel.
template <std::floating_point T>
[[nodiscard]] SoundnessProbes probeSoundness(const TriangleSurface<T>& surface,
                                             TrianglesAlong along, std::size_t count,
                                             std::span<const std::uint32_t> always);

/// What is known of the surface's signs, and the scheme that suits it or that the options demand.
template <std::floating_point T>
[[nodiscard]] SignReport checkSigns(const TriangleSurface<T>& surface,
                                    const TriangleSurfaceData<T>& data, TrianglesAlong along,
                                    const MeshSDFOptions& options);

#define CUTWATER_DECLARE(T)                                                                       \
  extern template SignReport checkSigns(const TriangleSurface<T>&, const TriangleSurfaceData<T>&, \
                                        TrianglesAlong, const MeshSDFOptions&);                   \
  extern template SoundnessProbes probeSoundness(const TriangleSurface<T>&, TrianglesAlong,       \
                                                 std::size_t, std::span<const std::uint32_t>);
CUTWATER_DECLARE(float)
CUTWATER_DECLARE(double)
#undef CUTWATER_DECLARE

}  // namespace cutwater
