#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/IndexBox.hpp>

namespace cutwater {

/// What indices refer to: the cells of a mesh, or the nodes at their corners.
enum class Centering : std::uint8_t { Cell, Node };

/// One refinement level of a mesh: maps the integer index (i, j, k) to a position in space.
///
/// Coordinates are always computed from the global index, so grid patches, octrees and ranks that
/// share a level agree on them to the bit.
template <std::floating_point T>
class Level {
 public:
  /// @throws Error unless the origin is finite and every spacing is positive and finite.
  Level(const Vec3<T>& origin, const Vec3<T>& spacing, Centering centering = Centering::Cell);

  /// origin + (i + 1/2) spacing for cells, origin + i spacing for nodes. Out of line, so its bits
  /// do not depend on the caller's compiler flags.
  [[nodiscard]] Vec3<T> position(const Index3& index) const;

  /// The closed box of a cell, or of the control volume around a node.
  [[nodiscard]] Box<T> cell(const Index3& index) const;

  [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
  [[nodiscard]] const Vec3<T>& spacing() const { return spacing_; }
  [[nodiscard]] Centering centering() const { return centering_; }
  /// The smallest of the three spacings, the unit in which bands are measured.
  [[nodiscard]] T smallestSpacing() const;

  bool operator==(const Level&) const = default;

 private:
  /// origin + (index + shift) spacing.
  [[nodiscard]] Vec3<T> at(const Index3& index, double shift) const;

  Vec3<T> origin_;
  Vec3<T> spacing_;
  Centering centering_;
};

/// A box of indices on a level, e.g. those owned by one rank, with or without ghost cells.
template <std::floating_point T>
struct GridPatch {
  Level<T> level;
  IndexBox indices;
};

extern template class Level<float>;
extern template class Level<double>;

}  // namespace cutwater
