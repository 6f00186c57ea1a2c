#pragma once

#include <Cutwater/Tpms/CellSizes.hpp>
#include <Cutwater/Tpms/DeformationField.hpp>

#include <array>
#include <optional>

namespace cutwater {

/// Cells around the z axis.
template <std::floating_point T>
struct CylindricalCells {
  /// Of a cell, in the direction of the radius.
  T radialSize;
  /// Whole cells, so that both ends of a turn join.
  int cellsPerTurn;
  T axialSize;
  /// By how much of a turn cells wind around the axis per length of it.
  T turnsPerLength = 0;
};

/// From places to coordinates in cells: how a pattern lies in space. A value.
template <std::floating_point T>
class TpmsMap {
 public:
  /// Cubic cells. @throws Error unless 0 < cellSize < infinity.
  TpmsMap(T cellSize);  // NOLINT(google-explicit-constructor): the plainest of all maps
  /// Cells of this size along each axis. @throws Error as above.
  explicit TpmsMap(const Vec3<T>& cellSize);
  /// Along each axis, sizes that depend on the place along it.
  explicit TpmsMap(std::array<CellSizes<T>, 3> sizes);
  /// (rho, phi, z) -> (rho / radialSize, n (phi + c z), z / axialSize), with phi in turns. The
  /// pattern is squeezed together at the axis, where values of solids are 0.
  /// @throws Error unless sizes are positive, there is a cell per turn, and all are finite.
  [[nodiscard]] static TpmsMap cylindrical(const CylindricalCells<T>& cells);

  /// The same with places shifted first, by p + v(p).
  /// @throws Error as DeformationField::check() does.
  [[nodiscard]] TpmsMap deformed(const DeformationField<T>& field) const;

  /// A place in cells: what the pattern is evaluated at, in turns.
  [[nodiscard]] Vec3<T> toCells(const Vec3<T>& p) const;

  /// A pattern as seen through the map, within a ball: how fast its value may change per length, if
  /// per radian it changes by no more than `lipschitz`, and along an axis by no more than `along`.
  /// Infinite where the ball holds a point of the axis of cylindrical cells.
  [[nodiscard]] T lipschitzWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const;

  /// Cells per length along each axis, if that is all there is to the map.
  [[nodiscard]] std::optional<Vec3<T>> constantRates() const;
  /// An upper bound of the rounding of toCells(), as that of the place: ulps() eps (|p| + size()).
  [[nodiscard]] T ulps() const;
  [[nodiscard]] T size() const;

 private:
  [[nodiscard]] Vec3<T> undeformed(const Vec3<T>& p) const;
  [[nodiscard]] T turnsWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const;

  std::array<CellSizes<T>, 3> along_;  // of cylindrical cells: rho, none, z
  int cellsPerTurn_ = 0;               // 0: they are not cylindrical
  T turnsPerLength_ = 0;
  std::optional<DeformationField<T>> deformation_;
};

extern template class TpmsMap<float>;
extern template class TpmsMap<double>;

}  // namespace cutwater
