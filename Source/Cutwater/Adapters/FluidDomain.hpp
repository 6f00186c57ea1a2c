#pragma once

#include <Cutwater/Sdf/Solid.hpp>

namespace cutwater {

/// Which side of a solid's surface a host code computes its flow on.
enum class FluidSide : std::uint8_t {
  Outside,  ///< around the solid: a hull, a wing
  Inside,   ///< within it: the solid is the shape of a room, a pipe's bore
};

/// Where a closed box lies, as a flow code sees it.
enum class FluidClass : std::uint8_t {
  Fluid,    ///< certainly no surface in the box, and it is fluid
  Body,     ///< certainly no surface in the box, and there is no fluid
  Cut,      ///< certainly some surface in the box
  Unknown,  ///< neither proven: to be treated as Cut
};

/// A solid and the side of it that is fluid: what every adapter is made from. Its level set is
/// negative in the fluid, as AMReX, Chombo and deal.II have it, positive in the body and +0 on the
/// surface.
///
/// Copies share the solid. All queries are const and thread-safe.
template <std::floating_point T>
class FluidDomain {
 public:
  /// @throws Error unless `fluidPoint` certainly is fluid: with the wrong side, a solid in other
  /// units or a surface turned inside out, a host would only find its domain covered.
  FluidDomain(Solid<T> solid, FluidSide side, const Vec3<T>& fluidPoint);

  [[nodiscard]] const Solid<T>& solid() const { return solid_; }
  [[nodiscard]] FluidSide side() const { return side_; }

  /// The solid's signed distance, or its negative. What it means is told by solid().guarantee().
  [[nodiscard]] T levelSet(const Vec3<T>& point) const;

  /// The same for many points, in parallel; the same bits as one by one.
  /// @throws Error if the spans differ in size.
  void levelSets(std::span<const Vec3<T>> points, std::span<T> values,
                 const ParallelOptions& options = {}) const;

  /// The level set where the solid's signed distance is this. From 0, so that it is +0 on the
  /// surface for either side.
  [[nodiscard]] T asLevelSet(T distance) const {
    return side_ == FluidSide::Inside ? distance : T(0) - distance;
  }

  /// Gradient of the level set: out of the fluid. Zero where it is not defined.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point) const;

  /// Whether the box is all fluid, all body or cut; as certain as
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
