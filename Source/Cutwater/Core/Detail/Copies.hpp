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

  /// Whether all copies but the central one, which sees p at `local`, are certainly so far away
  /// that outwards() would stop before them if its isNear() compared with the square of `limit`.
  /// Costs much less.
  [[nodiscard]] bool isAloneWithin(T limit, const Vec3<T>& p, const Vec3<T>& local) const;

  /// Which copies besides the central one a search looks at, wherever the point is. Without such a
  /// limit, a point from where differences of distances are lost in rounding would see them all.
  struct Reach {
    Vec3<T> along;  ///< no box farther away along an axis, unless it is the central copy's there
    T squared;      ///< none whose squared distance exceeds that of the central copy's by more
  };
  /// Reaches a copy that has the nearest point of all copies, up to rounding. Of the copies of one
  /// point of the original, the nearest is within half a period along each axis, or the last one.
  [[nodiscard]] Reach ofNearest() const { return {T(0.5) * repeats_.period, Box<T>::kInf}; }
  /// Reaches all boxes whose squared distance exceeds that of the central copy's by at most the
  /// square of `radius`.
  [[nodiscard]] Reach ofBoxesWithin(T radius) const;
  /// About the most copies that this reaches, wherever the point is; for 0, the most boxes that
  /// overlap at a point.
  [[nodiscard]] double mostWithin(T radius) const;

  /// Calls visit(copy) for copies within reach from central(p) outwards, that one first. Stops in a
  /// direction where the boxes of all further copies are so far from p that isNear(square of the
  /// distance) is false.
  template <typename IsNear, typename Visit>
  void outwards(const Vec3<T>& p, const Reach& reach, IsNear&& isNear, Visit&& visit) const {
    outwards(p, central(p), reach, isNear, visit);
  }
  /// The same, given the central copy.
  template <typename IsNear, typename Visit>
  void outwards(const Vec3<T>& p, const Vec3<T>& start, const Reach& reach, IsNear&& isNear,
                Visit&& visit) const;

 private:
  /// Whether a copy with this index exists.
  [[nodiscard]] bool isWithin(int axis, T index) const {
    if (!isRepeated(axis)) return index == 0;
    const auto count = repeats_.count[static_cast<std::size_t>(axis)];
    return count == 0 || (index >= 0 && index < static_cast<T>(count));
  }
  [[nodiscard]] T gapAlong(const Vec3<T>& p, int axis, T index) const {
    const T local = p[axis] - index * repeats_.period[axis];
    return std::max({box_.lower[axis] - local, local - box_.upper[axis], T(0)});
  }
  /// Calls visit(index, gap, excess of its square over that of `start`) for `start`, then outwards
  /// in both directions, in each as long as it returns true and the gap is within `reach`.
  template <typename Visit>
  void alongAxis(const Vec3<T>& p, int axis, T start, T reach, Visit&& visit) const {
    const T least = gapAlong(p, axis, start);
    visit(start, least, T(0));
    for (const T step : {T(1), T(-1)}) {
      for (T index = start + step; isWithin(axis, index); index += step) {
        const T gap = gapAlong(p, axis, index);
        if (!(gap <= reach) || !visit(index, gap, (gap - least) * (gap + least))) break;
        if (index + step == index) break;
      }
    }
  }

  Repeats<T> repeats_;
  Box<T> box_;
};

template <std::floating_point T>
template <typename IsNear, typename Visit>
void Copies<T>::outwards(const Vec3<T>& p, const Vec3<T>& start, const Reach& reach,
                         IsNear&& isNear, Visit&& visit) const {
  const auto& along = reach.along;
  // The start is the nearest along each axis.
  const T nearestY = gapAlong(p, 1, start.y);
  const T nearestZ = gapAlong(p, 2, start.z);
  const T leastZ = nearestZ * nearestZ;
  const T leastYZ = nearestY * nearestY + leastZ;
  alongAxis(p, 0, start.x, along.x, [&](T x, T gapX, T excessX) {
    const T alongX = gapX * gapX;
    if (!(excessX <= reach.squared && isNear(alongX + leastYZ))) return false;
    alongAxis(p, 1, start.y, along.y, [&](T y, T gapY, T excessY) {
      const T alongXY = alongX + gapY * gapY;
      const T excessXY = excessX + excessY;
      if (!(excessXY <= reach.squared && isNear(alongXY + leastZ))) return false;
      alongAxis(p, 2, start.z, along.z, [&](T z, T gapZ, T excessZ) {
        if (!(excessXY + excessZ <= reach.squared && isNear(alongXY + gapZ * gapZ))) return false;
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
