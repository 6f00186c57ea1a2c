#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/CutCells/Detail/Surface/MovedSurface.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// What a triangle is to the union of a surface's shells: all that has a winding number above 0.
enum class SheetKind : std::uint8_t {
  Wall,    ///< all of it separates the winding numbers 0 and 1
  Buried,  ///< all of it separates others: it is no wall
  /// It meets other triangles outside of corners and edges that they share, or lies at an edge of
  /// more than two triangles, or does the former once it is moved: any part of it may be either.
  Meeting,
  Baffle  ///< a sheet without thickness: a wall on both sides, in the fluid
};

/// Which triangles of a surface may meet others, outside of corners and edges that they share.
enum class MeetingsOf : std::uint8_t {
  None,
  Shells,  ///< those of different shells may touch, in points of their edges
  All
};

/// A surface, as findSheetKinds() needs it.
struct SheetInput {
  const MovedSurface& surface;
  /// Of the triangles of the mesh, and where these are: equal positions have equal numbers.
  std::span<const Vec3<double>> positions;
  std::span<const MovedSurface::Corners> corners;
  /// The triangles of the moved surface whose boxes meet a box.
  FunctionRef<std::vector<std::uint32_t>(const Box<double>&)> trianglesIn;
  int windingOutside = 0;
  MeetingsOf meetings = MeetingsOf::All;
  /// Where kinds are wanted.
  Box<double> where = Box<double>::everywhere();
};

/// The kinds of the triangles of a closed surface, without baffles, by exact predicates: of each
/// two triangles whose boxes meet, and the winding number at one triangle of each part that meets
/// no others. Triangles elsewhere than where they are wanted may be of any kind. Empty if all are
/// walls, where only those of different shells may touch.
[[nodiscard]] std::vector<SheetKind> findSheetKinds(const SheetInput& input);

}  // namespace cutwater
