#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>

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

extern template struct DeformationField<float>;
extern template struct DeformationField<double>;

}  // namespace cutwater
