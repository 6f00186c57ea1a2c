#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace cutwater {

/// The unit of a noise amplitude.
enum class NoiseUnit : std::uint8_t {
  Length,        ///< the unit of the corners' coordinates
  ShortestEdge,  ///< the shortest of the edges at the corner
};

/// Random displacement of cell corners: each moves to a point of a ball about its place, uniformly
/// distributed.
struct NodeNoise {
  double amplitude;  ///< the ball's radius
  std::uint64_t seed = 0;
  NoiseUnit unit = NoiseUnit::Length;
  bool keepsBoundary = false;  ///< corners at the ends of rows stay in place
};

/// A mapping of the unit cube that states along which axes it closes on itself.
template <typename M>
concept ClosingMapping = requires(const M& mapping) {
  { mapping.closedAxes() } -> std::same_as<std::array<bool, 3>>;
};

/// An array of hexahedral cells that fits a shape. [0, 1]^3 is divided into small cubes; a mapping
/// gives the images of their corners, and cells are trilinear in between. Neighbours share their
/// corners.
///
///     const HexahedralCells cells({4, 24, 10}, PipeMapping({.innerRadius = 2, .outerRadius = 3,
///                                                           .length = 5}));
///
/// No cell is flat or inverted anywhere inside: the determinant of the Jacobian has one sign,
/// certified by its Bernstein coefficients. (Cells may still overlap if a mapping covers a place
/// twice.)
class HexahedralCells {
 public:
  /// Number of cells along each axis, and the mapping of the unit cube: see CellMappings.hpp.
  using Counts = std::array<std::uint32_t, 3>;
  using Mapping = FunctionRef<Vec3<double>(const Vec3<double>&)>;

  /// `closed`: axes along which 0 and 1 have the same image, as around a pipe.
  /// @throws Error unless there is at least one cell along each axis, and 3 along a closed one;
  /// images are finite, and the same at 0 and 1 of closed axes; and no cell is flat or inverted.
  /// Error of kind Limit beyond 2^31 corners.
  HexahedralCells(const Counts& count, Mapping mapping, const std::array<bool, 3>& closed = {});
  /// With one of the mappings of CellMappings.hpp, closed along the axes that it states.
  template <ClosingMapping M>
  HexahedralCells(const Counts& count, const M& mapping)
      : HexahedralCells(count, Mapping(mapping), mapping.closedAxes()) {}

  /// The same cells with corners moved, each by a hash of its indices and the seed: the result is
  /// the same in every process and for any number of threads. A cube of edge 1 tolerates an
  /// amplitude of up to 1 / (2 sqrt(3)) whatever the seed: each edge changes by less than twice the
  /// amplitude, so no three edges become coplanar.
  /// @throws Error unless the amplitude is finite and not negative, and no cell becomes flat or
  /// inverted.
  [[nodiscard]] HexahedralCells withNoise(const NodeNoise& noise) const;

  [[nodiscard]] const Counts& count() const { return count_; }
  [[nodiscard]] const std::array<bool, 3>& closed() const { return closed_; }
  /// The corner i, j, k, with indices in 0 .. count along each axis; along closed axes, indices
  /// beyond the ends wrap around.
  [[nodiscard]] const Vec3<double>& corner(std::int64_t i, std::int64_t j, std::int64_t k) const;
  /// The image of a point given in units of cells. Beyond the ends of rows, the trilinear function
  /// of the last cell applies.
  [[nodiscard]] Vec3<double> at(const Vec3<double>& inCells) const;

 private:
  using Corner = std::array<std::int64_t, 3>;

  [[nodiscard]] std::int64_t cornersAlong(std::size_t axis) const {
    return std::int64_t{count_[axis]} + (closed_[axis] ? 0 : 1);
  }
  /// Calls visit(indices, coordinates) for each corner, in the order of storage.
  template <typename Visit>
  void forEachCorner(Visit&& visit);
  void requireClosed(Mapping mapping) const;
  void requireNotTurned() const;
  [[nodiscard]] std::array<Vec3<double>, 8> cornersOf(const Corner& cell) const;
  [[nodiscard]] double shortestEdgeAt(const Corner& corner) const;
  [[nodiscard]] bool isOnBoundary(const Corner& corner) const;

  Counts count_;
  std::array<bool, 3> closed_;
  std::vector<Vec3<double>> corners_;
};

namespace detail {

/// Whether the determinant of the Jacobian of a trilinear hexahedron, times `sign`, is positive
/// everywhere in it: certified by Bernstein coefficients, on halves where those of the whole are
/// inconclusive (Johnen, Weill and Remacle 2017, "Robust and efficient validation of the linear
/// hexahedral element"). Corner i is at (bit 0, bit 1, bit 2) of i.
[[nodiscard]] bool hasPositiveJacobian(const std::array<Vec3<double>, 8>& corners, double sign);

/// The determinant of the Jacobian at the first corner.
[[nodiscard]] double firstJacobian(const std::array<Vec3<double>, 8>& corners);

}  // namespace detail

}  // namespace cutwater
