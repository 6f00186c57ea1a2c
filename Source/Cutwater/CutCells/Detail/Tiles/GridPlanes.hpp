#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace cutwater {

/// An axis as the index of an array.
constexpr std::size_t asIndex(int axis) {
  return static_cast<std::size_t>(axis);
}

/// The component of an index along an axis.
inline std::int32_t& along(Index3& index, std::integral auto axis) {
  return axis == 0 ? index.i : axis == 1 ? index.j : index.k;
}
inline std::int32_t along(const Index3& index, std::integral auto axis) {
  return axis == 0 ? index.i : axis == 1 ? index.j : index.k;
}

/// The last of ascending planes for whose number `isBelow` is true; -1 if it is for none. It
/// changes at about x.
template <typename IsBelow>
[[nodiscard]] int lastPlane(std::span<const double> planes, double x, IsBelow&& isBelow) {
  // Nearly always right for grids of equal cells, and near for others.
  const double share = (x - planes.front()) / (planes.back() - planes.front());
  const int last = static_cast<int>(planes.size()) - 1;
  int plane = share >= 1 ? last : share <= 0 ? 0 : static_cast<int>(share * last);
  while (plane >= 0 && !isBelow(plane)) --plane;
  while (plane < last && isBelow(plane + 1)) ++plane;
  return plane;
}

/// The planes of a grid, across each axis, in ascending order: cell i lies between planes i and i
/// + 1. Cell -1 is below the first plane, and the last number stands for what is above the last
/// plane.
struct GridPlanes {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::array<std::span<const double>, 3> positions;
  /// Planes from here on are those a period below: what lies in them is computed there.
  Vec3<double> seam{kNever, kNever, kNever};
  Vec3<double> period = {};

  /// The number of cells between planes along an axis.
  [[nodiscard]] int cells(int axis) const {
    return static_cast<int>(positions[asIndex(axis)].size()) - 1;
  }
  /// Along all of them.
  [[nodiscard]] std::array<std::int32_t, 3> sizes() const { return {cells(0), cells(1), cells(2)}; }
  [[nodiscard]] double at(int axis, int plane) const {
    return positions[asIndex(axis)][static_cast<std::size_t>(plane)];
  }

  /// How far below a plane what lies in it is computed.
  [[nodiscard]] double shiftAt(int axis, int plane) const {
    return at(axis, plane) >= seam[axis] ? period[axis] : 0;
  }

  /// The cell along the axis that holds a point whose coordinate is known up to `error`.
  /// `isAbove(plane)` decides on planes that are no farther away than that.
  template <typename IsAbove>
  [[nodiscard]] int cellAt(int axis, double x, double error, IsAbove&& isAbove) const {
    return lastPlane(positions[asIndex(axis)], x, [&](int plane) {
      const double gap = x - at(axis, plane);
      return gap > error || (gap >= -error && isAbove(plane));
    });
  }
  [[nodiscard]] Box<double> boxOf(const std::array<std::int32_t, 3>& cell) const {
    Box<double> box;
    for (int axis = 0; axis < 3; ++axis) {
      box.lower[axis] = at(axis, cell[asIndex(axis)]);
      box.upper[axis] = at(axis, cell[asIndex(axis)] + 1);
    }
    return box;
  }
  /// The lengths of a cell's sides.
  [[nodiscard]] Vec3<double> sizeOf(const std::array<std::int32_t, 3>& cell) const {
    Vec3<double> size;
    for (int axis = 0; axis < 3; ++axis) {
      const int plane = cell[asIndex(axis)];
      size[axis] = at(axis, plane + 1) - at(axis, plane);
    }
    return size;
  }
};

}  // namespace cutwater
