#pragma once

#include <Cutwater/Core/Level.hpp>

namespace cutwater {

/// The domain of an octree mesh: a box of cubic cells, the roots of one octree each. The roots are
/// level 0; cells of each further level are half as wide.
template <std::floating_point T>
class OctreeDomain {
 public:
  /// @throws Error unless the origin is finite, the spacing positive and finite, and there is at
  /// least one root and fewer than 2^21 along each axis.
  OctreeDomain(const Vec3<T>& origin, T spacing, const Index3& roots);

  /// The grid of a level. The bits of a cell's coordinates depend on its global index alone.
  [[nodiscard]] Level<T> level(int level) const;
  [[nodiscard]] IndexBox indices(int level) const;
  /// The finest level that any cell can have.
  [[nodiscard]] int deepest() const;
  [[nodiscard]] Box<T> box() const;

  [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
  [[nodiscard]] T spacing() const { return spacing_; }  ///< of the roots
  [[nodiscard]] const Index3& roots() const { return roots_; }

 private:
  Vec3<T> origin_;
  T spacing_;
  Index3 roots_;
};

extern template class OctreeDomain<float>;
extern template class OctreeDomain<double>;

}  // namespace cutwater
