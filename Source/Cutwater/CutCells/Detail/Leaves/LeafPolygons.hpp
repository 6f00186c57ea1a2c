#pragma once

#include <Cutwater/CutCells/Detail/Leaves/LeafSources.hpp>

#include <array>
#include <vector>

namespace cutwater {

/// The polygons of leaves, in the coordinates of the world.
///
/// Where finer leaves are across a face of a leaf, the outlines of their open parts bound its
/// pieces, too. A part of its wall, or of an open patch, that ends in that face then goes along the
/// traces of its triangle on theirs, so that pieces close to the bit. Points that both levels
/// compute may differ by rounding, as each puts them in its own cells: the wall goes to and fro
/// between the two.
class LeafPolygons {
 public:
  using Polygon = std::vector<Vec3<double>>;

  /// Views its arguments. Tiles must have their polygons.
  LeafPolygons(const CutFrame& frame, const LeafGrid& grid, const LeafSources& sources)
      : frame_(frame), grid_(grid), sources_(sources) {}

  /// The outline of an arc of a source's tile; empty if that is a point.
  [[nodiscard]] Polygon outlineOf(std::uint32_t source, std::uint32_t arc);
  /// That of all of a leaf's face.
  [[nodiscard]] Polygon outlineOfFace(std::uint32_t leaf, int axis, bool isHigh) const;
  /// Appends what a patch has of the wall of a piece, by the numbers of the source's tile.
  void addWall(std::uint32_t source, std::uint32_t piece, std::uint32_t patch,
               CutCells::Polygons& to);

 private:
  using Trace = std::array<Vec3<double>, 2>;  // from the one to the other

  [[nodiscard]] Vec3<double> inWorldOf(const LeafTile& tile, const TilePlace& within,
                                       const Vec3<double>& point) const;
  [[nodiscard]] Polygon wallPolygon(std::uint32_t source, std::uint32_t number);
  [[nodiscard]] std::vector<Trace> finerTraces(std::uint32_t source,
                                               const LeafRims::WallEdge& edge);
  [[nodiscard]] std::span<const std::uint32_t> finerAcross(std::uint32_t source, int axis,
                                                           bool isHigh);

  const CutFrame& frame_;
  const LeafGrid& grid_;
  const LeafSources& sources_;
  // Of the source at hand, across each face: sources of finer leaves.
  std::uint32_t source_ = kNone;
  std::array<std::vector<std::uint32_t>, 6> finer_;
};

}  // namespace cutwater
