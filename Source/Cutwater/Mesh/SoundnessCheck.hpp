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

/// Point i of a sequence that fills the unit cube evenly, however many are taken: multiples of
/// powers of the plastic number's kin (M. Roberts 2018, "The unreasonable effectiveness of
/// quasirandom sequences").
[[nodiscard]] Vec3<double> evenlySpread(std::size_t i);

/// Calls probe(i, along) for i = 0, 1, ..., in parallel, `count` times or until so many triangles
/// have been shown to them that this takes longer than the rest of the construction: where
/// thousands of triangles lie on one another, or all meet in one vertex. Returns how often: the
/// same whatever the number of threads.
std::size_t runProbes(std::size_t count, std::size_t triangles, TrianglesAlong along,
                      FunctionRef<void(std::size_t, TrianglesAlong)> probe);

/// Looks at `count` places, spread evenly over the list of triangles and over their area, and at
/// the middles of those in `always`, as many of them at most; triangles without area are left out.
/// Just beside means 2^-40 of the surface's size away, so sheets closer together than that count as
/// unsound. See runProbes().
template <std::floating_point T>
[[nodiscard]] SoundnessProbes probeSoundness(const TriangleSurface<T>& surface,
                                             TrianglesAlong along, std::size_t count,
                                             std::span<const std::uint32_t> always);

/// What the surface's signs rest on, but for the scheme; `probes` as for probeSoundness().
template <std::floating_point T>
[[nodiscard]] SignReport checkSigns(const TriangleSurface<T>& surface,
                                    const TriangleSurfaceData<T>& data, TrianglesAlong along,
                                    std::size_t probes);

#define CUTWATER_DECLARE(T)                                                                       \
  extern template SignReport checkSigns(const TriangleSurface<T>&, const TriangleSurfaceData<T>&, \
                                        TrianglesAlong, std::size_t);                             \
  extern template SoundnessProbes probeSoundness(const TriangleSurface<T>&, TrianglesAlong,       \
                                                 std::size_t, std::span<const std::uint32_t>);
CUTWATER_DECLARE(float)
CUTWATER_DECLARE(double)
#undef CUTWATER_DECLARE

}  // namespace cutwater
