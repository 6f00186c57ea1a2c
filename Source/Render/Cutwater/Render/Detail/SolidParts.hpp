#pragma once

#include <Cutwater/Render/Detail/FacetRays.hpp>

#include <memory>

/// Internals of render(), for its own parts only.
namespace cutwater::detail {

/// A part of a solid that rays look for by itself.
template <std::floating_point T>
struct SolidPart {
  std::shared_ptr<const SignedDistanceFunction<T>> solid;
  /// What the solid's patches are in the whole; empty if they are the same.
  std::vector<std::uint32_t> patches;
  /// All of the surface in the box, if it consists of flat pieces and values are distances.
  std::optional<FacetRays> facets;
};

/// The parts that a solid is the union of, by how rays find them: those whose surface consists of
/// flat pieces, those with bounds on the distance, and those that only know signs. The last two are
/// searched step by step, which takes much longer where the values of a mesh are among them.
///
/// A ray that begins outside the union sees the first that it meets of any part: up to there it is
/// outside all of them. One that begins inside the union begins inside a part.
///
/// Anything but a union, through placements and names, is one part: the solid itself, which must
/// outlive it. So is all of the solid if `sheets` are shown, which bound nothing. `threads`: see
/// ParallelOptions.
template <std::floating_point T>
[[nodiscard]] std::vector<SolidPart<T>> partsOf(const SignedDistanceFunction<T>& solid,
                                                const Box<double>& box, bool sheets, int threads);

extern template std::vector<SolidPart<float>> partsOf(const SignedDistanceFunction<float>&,
                                                      const Box<double>&, bool, int);
extern template std::vector<SolidPart<double>> partsOf(const SignedDistanceFunction<double>&,
                                                       const Box<double>&, bool, int);

}  // namespace cutwater::detail
