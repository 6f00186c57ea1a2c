#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

namespace cutwater {

/// A surface, and how the signs on its two sides are decided: what MeshIndex and DcelIndex share.
template <std::floating_point T>
class SignedSurface {
 public:
  /// The arrays, and the result of searching them.
  using Surface = TriangleSurface<T>;
  using Nearest = typename Surface::Nearest;

  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] const SignReport& signs() const { return signs_; }
  /// Whether signs change away from triangles: at the sheet of winding number 1/2 that closes a
  /// hole or, by the nearest feature, where an open surface or one that meets itself has another
  /// nearest triangle.
  [[nodiscard]] bool signJumps() const { return signJumps_; }
  /// Encloses the solid, in the mesh's own units.
  [[nodiscard]] const Box<T>& solidBox() const { return solidBox_; }
  /// Encloses the triangles, in the mesh's own units.
  [[nodiscard]] Box<T> surfaceBox() const;
  /// The corners of a triangle, in the mesh's own units.
  [[nodiscard]] std::array<Vec3<T>, 3> triangle(std::uint32_t id) const;

 protected:
  SignedSurface() = default;
  /// Called when the arrays are complete. The solid may reach beyond the triangles' box by
  /// `margin`, in scaled units.
  void setSurface(const Surface& surface, double margin = 0);
  /// Called last, when all else is known: chooses the scheme, unless one is requested.
  void setSigns(const SignReport& signs, SignScheme wanted);

 private:
  Surface surface_;
  SignReport signs_;
  bool signJumps_ = false;
  Box<T> solidBox_;
};

extern template class SignedSurface<float>;
extern template class SignedSurface<double>;

}  // namespace cutwater
