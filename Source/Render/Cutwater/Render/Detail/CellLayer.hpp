#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Render/Slice.hpp>

#include <array>
#include <vector>

/// Internals of renderCells(), for its own parts only.
namespace cutwater::detail {

/// A point of the plane in its two coordinates, see SlicePlane::across().
using PlanePoint = std::array<double, 2>;

/// A part of the section of the wall with the plane.
struct WallSegment {
  PlanePoint from, to;
  PlanePoint normal;  ///< into the fluid, of any length
  std::uint32_t piece = CutCells::kNoRow;
};

/// What is at a point of a cut cell.
struct CellSide {
  bool isFluid = false;
  std::uint32_t piece = CutCells::kNoRow;  ///< that of the fluid, or of the wall beside it
};

/// A cut cell and how it meets the plane.
struct SectionedCell {
  std::uint32_t row = CutCells::kNoRow;
  std::vector<WallSegment> segments;
  CellSide side;  ///< all of it in the plane, where there are no segments

  /// Follows a line from a point to the wall. Of points on the wall, either side.
  [[nodiscard]] CellSide at(const PlanePoint& p) const;
};

/// One layer of cut cells, and the plane through its middle.
class CellLayer {
 public:
  /// @param index  that of its cells along the axis.
  /// @throws Error(Argument) unless the box has such cells, and their polygons are kept.
  CellLayer(const CutCells& cells, int axis, std::int32_t index);

  /// The plane's coordinate, and the layer's two ends.
  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] const Interval<double>& extent() const { return extent_; }
  /// The planes across one of the plane's coordinates, from one end of the box to the other.
  [[nodiscard]] std::span<const double> planes(std::size_t i) const;
  /// The cell at these places between planes.
  [[nodiscard]] Index3 cellAt(std::size_t right, std::size_t up) const;
  /// Its rectangle.
  [[nodiscard]] SliceWindow<double> rectangle(std::uint32_t row) const;

  /// Those that are cut, in the order of their rows.
  [[nodiscard]] const std::vector<SectionedCell>& cells() const { return sections_; }
  /// Of a row of the layer.
  [[nodiscard]] const SectionedCell& section(std::uint32_t row) const;

 private:
  void addSection(std::uint32_t row);
  void addSegment(std::span<const Vec3<double>> polygon, std::uint32_t piece, SectionedCell& to);
  [[nodiscard]] CellSide sideOf(const SectionedCell& cell) const;
  [[nodiscard]] PlanePoint inPlane(const Vec3<double>& p) const { return {p[right_], p[up_]}; }

  const CutCells& all_;
  int axis_;
  std::int32_t index_;
  int right_;
  int up_;
  double middle_ = 0;
  Interval<double> extent_;
  std::vector<SectionedCell> sections_;
};

}  // namespace cutwater::detail
