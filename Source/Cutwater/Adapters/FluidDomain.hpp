#pragma once

#include <Cutwater/Sdf/FluidSide.hpp>
#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// A solid and the side of it that is fluid, from which every adapter is constructed. Its level set
/// is negative in the fluid, as in AMReX, Chombo and deal.II, positive in the body and +0 on the
/// surface.
///
/// Copies share the solid. All queries are const and thread-safe.
template <std::floating_point T>
class FluidDomain {
 public:
  /// @throws Error unless `fluidPoint` certainly is fluid. With the wrong side, a solid in other
  /// units or a surface turned inside out, an application would merely find its domain covered.
  FluidDomain(Solid<T> solid, FluidSide side, const Vec3<T>& fluidPoint);

  [[nodiscard]] const Solid<T>& solid() const { return solid_; }
  [[nodiscard]] FluidSide side() const { return side_; }

  /// The solid's signed distance, or its negative; solid().guarantee() states what it means.
  [[nodiscard]] T levelSet(const Vec3<T>& point) const;

  /// The same for many points, in parallel; the results are the same to the bit.
  /// @throws Error if the spans differ in size.
  void levelSets(std::span<const Vec3<T>> points, std::span<T> values,
                 const ParallelOptions& options = {}) const;

  /// The level set for this signed distance from the solid. Subtracts it from 0 instead of negating
  /// it, so that the level set is +0 on the surface for either side.
  [[nodiscard]] T asLevelSet(T distance) const {
    return side_ == FluidSide::Inside ? distance : T(0) - distance;
  }

  /// Gradient of the level set, which points out of the fluid. Zero where it is not defined.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point) const;

  /// Whether the box is all fluid, all body or cut, with the certainty of
  /// SignedDistanceFunction::classify().
  [[nodiscard]] FluidClass classify(const Box<T>& box, BoxHint* hint = nullptr) const;

  /// The same for many boxes, in parallel. @throws Error if the spans differ in size.
  void classify(std::span<const Box<T>> boxes, std::span<FluidClass> classes,
                const ParallelOptions& options = {}) const;

 private:
  [[nodiscard]] FluidClass asFluid(BoxClass kind) const;

  Solid<T> solid_;
  FluidSide side_;
};

extern template class FluidDomain<float>;
extern template class FluidDomain<double>;

}  // namespace cutwater
