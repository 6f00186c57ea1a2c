#pragma once

#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>

namespace cutwater {

/// How many of the probed places of a closed surface bound a solid.
struct SoundnessProbes {
  std::size_t probes = 0;
  std::size_t unsound = 0;  ///< winding number not 0 just in front or not 1 just behind
};

/// Point i of a sequence that fills the unit cube evenly, however many are taken: multiples of
/// powers of a relative of the plastic number (M. Roberts 2018, "The unreasonable effectiveness of
/// quasirandom sequences").
[[nodiscard]] Vec3<double> evenlySpread(std::size_t i);

/// Calls probe(i, along) for i = 0, 1, ..., in parallel, `count` times or until so many triangles
/// have been visited that this takes longer than the rest of the construction, as where thousands
/// of triangles lie on top of one another or meet in one vertex. Returns the number of calls, which
/// does not depend on the number of threads.
std::size_t runProbes(std::size_t count, std::size_t triangles, TrianglesAlong along,
                      FunctionRef<void(std::size_t, TrianglesAlong)> probe);

/// Probes `count` places, spread evenly over the list of triangles and over their area, and the
/// centroids of the triangles in `always`, at most as many of these; triangles without area are
/// left out. Just in front and behind mean 2^-40 of the surface's size away, so sheets closer
/// together than that count as unsound. See runProbes().
template <std::floating_point T>
[[nodiscard]] SoundnessProbes probeSoundness(const TriangleSurface<T>& surface,
                                             TrianglesAlong along, std::size_t count,
                                             std::span<const std::uint32_t> always);

/// Reports what the surface's signs are based on, except the scheme. On a closed surface without
/// overlaps, which are looked for if the options say so, it examines one place on each part; if
/// that does not prove the surface sound, as many as the options say.
template <std::floating_point T>
[[nodiscard]] SignReport checkSigns(const TriangleSurface<T>& surface,
                                    const TriangleSurfaceArrays<T>& data, TrianglesAlong along,
                                    const MeshSDFOptions& options,
                                    FunctionRef<SurfaceContacts()> findContacts);

#define CUTWATER_DECLARE(T)                                                                     \
  extern template SignReport checkSigns(const TriangleSurface<T>&,                              \
                                        const TriangleSurfaceArrays<T>&, TrianglesAlong,        \
                                        const MeshSDFOptions&, FunctionRef<SurfaceContacts()>); \
  extern template SoundnessProbes probeSoundness(const TriangleSurface<T>&, TrianglesAlong,     \
                                                 std::size_t, std::span<const std::uint32_t>);
CUTWATER_DECLARE(float)
CUTWATER_DECLARE(double)
#undef CUTWATER_DECLARE

}  // namespace cutwater
