#pragma once

#include <Cutwater/Core/Vec3.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// A straight strut between two points, in units of the unit cell.
struct CellStrut {
  Vec3<double> a, b;

  /// The point half-way between its ends.
  [[nodiscard]] Vec3<double> middle() const { return 0.5 * (a + b); }
};

/// Mirrors that a lattice may have, given as a rule that folds points into one chamber between
/// them. A fold never moves two points apart, so the strut nearest to a folded point has an image
/// in the chamber: what is there determines the distance to the whole endless lattice.
enum class CellFold : std::uint8_t {
  None,
  Octant,  ///< planes through faces and middles of cells: x, y, z in [0, 1/2]
  SortXY,  ///< and x = y: y <= x
  Sort,    ///< and y = z: z <= y <= x
  /// The planes x +- y = n / 2 and so on, of the diamond, whose points repeat on a face-centred
  /// lattice: |z| <= y <= x, x + y <= 1/2 (the alcove of the affine Weyl group A3).
  Fcc,
};

/// A pattern of straight struts that repeats with period 1 along each axis, without a size or
/// thickness of its own.
///
/// A strut belongs to the cell [0, 1)^3 that its midpoint lies in, and may reach beyond it. A strut
/// in a face or edge of the cell is shared with neighbours, and occurs once per period.
///
/// The mirrors of the pattern are detected: they determine how fast distances to the endless
/// lattice are. Mirror images must agree to rounding: write 1.0 / 3, not 0.333.
class UnitCell {
 public:
  /// A custom pattern. Struts that are copies of others, reversed or moved by whole periods, count
  /// once; those that overlap in part count twice in lengthPerCell().
  /// @throws Error unless there is at least one strut, and all have finite ends in [-1, 2]^3 that
  /// are more than 1e-6 apart.
  UnitCell(std::string name, std::span<const CellStrut> struts);
  /// The same, given by nodes and the two nodes of each strut.
  /// @throws Error also if a strut refers to a node that does not exist.
  UnitCell(std::string name, std::span<const Vec3<double>> nodes,
           std::span<const std::array<std::uint32_t, 2>> struts);

  // Common patterns. C are the corners of the cube, B its centre, F the centres of its faces.
  static UnitCell simpleCubic();          ///< the edges
  static UnitCell bcc();                  ///< C-B
  static UnitCell fcc();                  ///< C-F, the diagonals of faces
  static UnitCell bccz();                 ///< bcc, and edges along z
  static UnitCell fccz();                 ///< fcc, and edges along z
  static UnitCell cubicBcc();             ///< simpleCubic and bcc
  static UnitCell fbcc();                 ///< fcc and bcc
  static UnitCell cubicFcc();             ///< simpleCubic and fcc
  static UnitCell octahedron();           ///< F-F
  static UnitCell octet();                ///< fcc and octahedron: the octet truss
  static UnitCell cuboctahedron();        ///< middles of edges, joined across faces
  static UnitCell kelvin();               ///< edges of truncated octahedra
  static UnitCell rhombicDodecahedron();  ///< edges of rhombic dodecahedra
  static UnitCell truncatedCube();        ///< edges of truncated cubes
  static UnitCell diamond();              ///< bonds of the diamond
  /// Re-entrant honeycomb in 3D (auxetic): struts of this height along z at edges and centre of the
  /// cell, joined obliquely. @throws Error unless 1/2 < height < 1.
  static UnitCell reentrant(double height);
  static UnitCell srs();           ///< the labyrinth of a gyroid; it has no mirrors
  static UnitCell weairePhelan();  ///< edges of the foam of Weaire and Phelan
  /// All of them, with reentrant(0.7).
  static std::vector<UnitCell> all();

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The struts that repeat: none is a copy of another.
  [[nodiscard]] std::span<const CellStrut> struts() const { return struts_; }
  /// All struts of the lattice whose midpoints lie in the closed cube [0, 1]^3.
  [[nodiscard]] std::vector<CellStrut> closedStruts() const;
  /// Total length of struts(), in units of the cell.
  [[nodiscard]] double lengthPerCell() const;

  /// Whether the fold maps the lattice into itself, in cubic cells.
  [[nodiscard]] bool has(CellFold fold) const;
  /// Of the folds that the lattice has if cells are stretched to this size, that with the smallest
  /// chamber.
  [[nodiscard]] CellFold foldAt(const Vec3<double>& size) const;

  /// Midpoints of struts within this distance of a face of the cell count as lying in it.
  static constexpr double kSame = 1e-9;

 private:
  void add(const CellStrut& strut);
  /// Whether a copy of it is in the list, with ends at most this far away along each axis.
  [[nodiscard]] bool contains(const CellStrut& strut, double tolerance) const;
  void findMirrors();

  std::string name_;
  std::vector<CellStrut> struts_;
  std::uint32_t folds_ = 0;  // a bit for each that it has
};

}  // namespace cutwater
