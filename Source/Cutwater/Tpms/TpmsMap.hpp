#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Tpms/CellSizes.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace cutwater {

/// Random shifts v(p): one at each node of an endless grid, trilinear in between. They follow from
/// the node's index and the seed alone, so they are the same in every process.
template <std::floating_point T>
struct DeformationField {
  /// Components of shifts lie in [-amplitude, amplitude].
  T amplitude{};
  /// Spacing of the grid's nodes along each axis.
  Vec3<T> spacing;
  std::uint64_t seed = 1;

  /// @throws Error unless spacings are positive, the amplitude is not negative, and all are finite.
  void check() const;
  [[nodiscard]] Vec3<T> shiftAt(const Vec3<T>& p) const;
  /// |v(p) - v(q)| <= lipschitz() |p - q|. Along an axis, a component changes by at most
  /// 2 amplitude / spacing per length; lipschitz() is the norm of the matrix of these bounds.
  [[nodiscard]] T lipschitz() const;
};

/// Cells around the z axis.
template <std::floating_point T>
struct CylindricalCells {
  /// Size of a cell in the direction of the radius.
  T radialSize;
  /// Number of cells in a full turn.
  int cellsPerTurn;
  T axialSize;
  /// Twist: turns around the axis per length along it.
  T turnsPerLength = 0;
};

/// Maps points to coordinates in cells: how a pattern lies in space. A value type.
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
  /// @throws Error unless sizes are positive, there is at least one cell per turn, and all are
  /// finite.
  [[nodiscard]] static TpmsMap cylindrical(const CylindricalCells<T>& cells);

  /// The same map, applied to shifted points p + v(p).
  /// @throws Error as DeformationField::check() does.
  [[nodiscard]] TpmsMap deformed(const DeformationField<T>& field) const;

  /// The coordinates, in cells, at which the pattern is evaluated for a point.
  [[nodiscard]] Vec3<T> toCells(const Vec3<T>& p) const;

  /// An upper bound, within a ball, of the change per length of pattern(toCells(p)), for a pattern
  /// that changes by at most `lipschitz` per radian in any direction and `along` along an axis.
  /// Infinite if the ball contains a point of the axis of cylindrical cells.
  [[nodiscard]] T lipschitzWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const;

  /// Cells per length along each axis, if cells have one size along each axis and are not deformed;
  /// otherwise nothing.
  [[nodiscard]] std::optional<Vec3<T>> constantRates() const;
  /// An upper bound of the rounding of toCells(), as an error of the point:
  /// ulps() eps (|p| + size()).
  [[nodiscard]] T ulps() const;
  [[nodiscard]] T size() const;

 private:
  [[nodiscard]] Vec3<T> undeformed(const Vec3<T>& p) const;
  /// lipschitzWithin() of the map without its deformation, over 2 pi.
  [[nodiscard]] T undeformedRateWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const;

  std::array<CellSizes<T>, 3> along_;  // of cylindrical cells: rho, none, z
  int cellsPerTurn_ = 0;               // 0: they are not cylindrical
  T turnsPerLength_ = 0;
  std::optional<DeformationField<T>> deformation_;
};

extern template struct DeformationField<float>;
extern template struct DeformationField<double>;
extern template class TpmsMap<float>;
extern template class TpmsMap<double>;

}  // namespace cutwater
