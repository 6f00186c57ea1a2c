#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>

#include <array>

namespace cutwater::detail {

/// A box divided into equal cells, generation by generation: each halves them along the axes that
/// they are longest along, so that they are about cubes before long, and divided by eight from then
/// on. The closed cells of a generation cover the box, and share no more than their faces, to the
/// bit.
template <std::floating_point T>
class HalvedBox {
 public:
  /// One cell.
  explicit HalvedBox(const Box<T>& box) : box_(box) {}

  /// The next generation. False, and nothing done, if indices have no room for it.
  bool divide();
  /// Of one cell of the generation before, by the last division.
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

/// Of the product of the cell's or box's sides, relative to their exact product.
inline constexpr double kVolumeError = 0x1p-50;

/// Rounded: see kVolumeError.
template <std::floating_point T>
CUTWATER_INLINE inline double volumeOf(const Box<T>& box) {
  const Vec3<double> size = Vec3<double>(box.upper) - Vec3<double>(box.lower);
  return size.x * size.y * size.z;
}

extern template class HalvedBox<float>;
extern template class HalvedBox<double>;

}  // namespace cutwater::detail
