#pragma once

#include <Cutwater/Mesh/TriangleSurface.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// What all mesh functions share: the answers that follow once the nearest triangle is known. How
/// it is found is the subclass' business, and changes no bit.
template <std::floating_point T>
class TriangleSurfaceSDF : public SignedDistanceFunction<T> {
 public:
  [[nodiscard]] std::size_t triangleCount() const { return surface_.triangles.size(); }
  /// Corners of a triangle as closestPoint() counts them, in the mesh's own frame.
  /// @throws Error if there is no such triangle.
  [[nodiscard]] std::array<Vec3<T>, 3> triangle(std::uint32_t id) const;
  /// Shells that were inside out, and have been turned: see findInsideOutShells().
  [[nodiscard]] std::size_t turnedShells() const { return turnedShells_; }

 protected:
  using Surface = TriangleSurface<T>;
  using Nearest = typename Surface::Nearest;

  TriangleSurfaceSDF() = default;

  /// The triangle nearest to `p`, of equals the one with the lowest id; `p` is in the surface's
  /// scaled units.
  [[nodiscard]] virtual Nearest nearest(const Vec3<T>& p) const = 0;

  /// Called once by the subclass' constructor, when the block is complete.
  void setSurface(const Surface& surface, std::size_t turnedShells);
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& point) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& point) const final;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& point) const final;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& point) const final;
  [[nodiscard]] Guarantee<T> localGuarantee() const final;
  [[nodiscard]] Box<T> localBoundingBox() const final { return box_; }

  Surface surface_;
  Box<T> box_;
  std::size_t turnedShells_ = 0;
};

extern template class TriangleSurfaceSDF<float>;
extern template class TriangleSurfaceSDF<double>;

}  // namespace cutwater
