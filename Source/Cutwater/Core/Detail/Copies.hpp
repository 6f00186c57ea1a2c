#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Repeats.hpp>

#include <algorithm>
#include <array>
#include <cstdint>

namespace cutwater::detail {

/// Positions of copies, and which of them may be nearest to a point. Each copy lies in the
/// original's box moved by multiples of the period; these multiples identify it.
template <std::floating_point T>
class Copies {
 public:
  /// `box`: that of the original. If it is empty, none of the following gives anything sensible.
  Copies(const Repeats<T>& repeats, const Box<T>& box) : repeats_(repeats), box_(box) {}

  [[nodiscard]] const Repeats<T>& repeats() const { return repeats_; }
  [[nodiscard]] const Box<T>& box() const { return box_; }
  [[nodiscard]] bool isRepeated(int axis) const { return repeats_.period[axis] > 0; }
  /// Box around all copies; infinite where they are endless.
  [[nodiscard]] Box<T> boxOfAll() const;

  /// Position of p in the frame of a copy.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> seenFrom(const Vec3<T>& copy, const Vec3<T>& p) const {
    return p - placeOf(copy);
  }
  /// Displacement of a copy from the original.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> placeOf(const Vec3<T>& copy) const {
    const auto& d = repeats_.period;
    return {copy.x * d.x, copy.y * d.y, copy.z * d.z};
  }
  /// Distance from the original's box along each axis; 0 inside.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> gaps(const Vec3<T>& local) const {
    return max(max(box_.lower - local, local - box_.upper), Vec3<T>{});
  }
  /// The copy whose box is centred nearest to p.
  [[nodiscard]] Vec3<T> central(const Vec3<T>& p) const;

  /// Calls visit(copy) for copies from central(p) outwards, that one first. Stops in a direction
  /// where the boxes of all further copies are so far from p that isNear(square of the distance) is
  /// false.
  template <typename IsNear, typename Visit>
  void outwards(const Vec3<T>& p, IsNear&& isNear, Visit&& visit) const {
    outwards(p, central(p), isNear, visit);
  }
  /// The same, given the central copy.
  template <typename IsNear, typename Visit>
  void outwards(const Vec3<T>& p, const Vec3<T>& start, IsNear&& isNear, Visit&& visit) const;

 private:
  /// Whether a copy with this index exists.
  [[nodiscard]] bool isWithin(int axis, T index) const {
    if (!isRepeated(axis)) return index == 0;
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    return count == 0 || (index >= 0 && index < static_cast<T>(count));
  }
  [[nodiscard]] T gapSquared(const Vec3<T>& p, int axis, T index) const {
    const T local = p[axis] - index * repeats_.period[axis];
    const T gap = std::max({box_.lower[axis] - local, local - box_.upper[axis], T(0)});
    return gap * gap;
  }
  /// Calls visit(index) for `start`, then outwards in both directions, in each as long as it
  /// returns true.
  template <typename Visit>
  void alongAxis(int axis, T start, Visit&& visit) const {
    visit(start);
    for (const T step : {T(1), T(-1)}) {
      for (T index = start + step; isWithin(axis, index); index += step) {
        if (!visit(index) || index + step == index) break;
      }
    }
  }

  Repeats<T> repeats_;
  Box<T> box_;
};

template <std::floating_point T>
template <typename IsNear, typename Visit>
void Copies<T>::outwards(const Vec3<T>& p, const Vec3<T>& start, IsNear&& isNear,
                         Visit&& visit) const {
  // The start is the nearest along each axis.
  const T leastZ = gapSquared(p, 2, start.z);
  const T leastYZ = gapSquared(p, 1, start.y) + leastZ;
  alongAxis(0, start.x, [&](T x) {
    const T alongX = gapSquared(p, 0, x);
    if (!isNear(alongX + leastYZ)) return false;
    alongAxis(1, start.y, [&](T y) {
      const T alongXY = alongX + gapSquared(p, 1, y);
      if (!isNear(alongXY + leastZ)) return false;
      alongAxis(2, start.z, [&](T z) {
        if (!isNear(alongXY + gapSquared(p, 2, z))) return false;
        visit(Vec3<T>{x, y, z});
        return true;
      });
      return true;
    });
    return true;
  });
}

extern template class Copies<float>;
extern template class Copies<double>;

}  // namespace cutwater::detail
