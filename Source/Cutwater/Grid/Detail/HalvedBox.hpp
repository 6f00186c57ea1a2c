#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>

#include <array>

namespace cutwater::detail {

/// A box divided into equal cells, generation by generation. Each generation halves the cells along
/// their longest axes, so that they soon become nearly cubic and are divided into eight from then
/// on. The closed cells of a generation cover the box, and share no more than their faces, to the
/// bit.
template <std::floating_point T>
class HalvedBox {
 public:
  /// Starts with one cell.
  explicit HalvedBox(const Box<T>& box) : box_(box) {}

  /// Moves to the next generation. Returns false, and does nothing, if its indices would overflow.
  bool divide();
  /// Number of children that the last division gave each cell.
  [[nodiscard]] int children() const { return 1 << halved_; }
  [[nodiscard]] Index3 child(const Index3& parent, int number) const;
  [[nodiscard]] Box<T> cell(const Index3& index) const;

 private:
  [[nodiscard]] T face(int axis, std::int32_t index) const;

  Box<T> box_;
  std::array<int, 3> halvings_{};   // along each axis, since the first generation
  std::array<bool, 3> isHalved_{};  // in this generation
  int halved_ = 0;                  // axes
};

/// Relative error bound of the product of the sides of a cell or box.
inline constexpr double kVolumeError = 0x1p-50;

/// Volume of a box, rounded: see kVolumeError. `flat` is 1 along axes without extent, else 0: the
/// volume of a rectangle is its area, that of a segment its length.
template <std::floating_point T>
CUTWATER_INLINE inline double volumeOf(const Box<T>& box, const Vec3<double>& flat = {}) {
  const Vec3<double> size = Vec3<double>(box.upper) - Vec3<double>(box.lower) + flat;
  return size.x * size.y * size.z;
}

extern template class HalvedBox<float>;
extern template class HalvedBox<double>;

}  // namespace cutwater::detail
