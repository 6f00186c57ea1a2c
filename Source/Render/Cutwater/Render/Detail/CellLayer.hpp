#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Render/Detail/CellRows.hpp>
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

/// A cell that the plane passes through, cut or not.
struct ShownCell {
  SliceWindow<double> rectangle;
  std::uint32_t row = CutCells::kNoRow;  ///< kNoRow if it is not cut
  bool isFluid = false;                  ///< all of it; of cells that are not cut
};

/// One layer of cut cells and the plane through its middle, or the leaves that a plane meets.
class CellLayer {
 public:
  /// @param index  that of its cells along the axis.
  /// @throws Error(Argument) unless the box has such cells, and their polygons are kept.
  CellLayer(const CutCells& cells, int axis, std::int32_t index);
  /// @param at  the plane's coordinate; of leaves on both sides of it, those above are shown.
  /// @throws Error(Argument) unless there are leaves, of this octree, and their polygons are kept.
  template <std::floating_point T>
  CellLayer(const CutLeaves& leaves, const OctreeCells<T>& mesh, int axis, double at);

  /// The plane's coordinate.
  [[nodiscard]] double middle() const { return middle_; }
  [[nodiscard]] const CellRows& rows() const { return rows_; }
  /// All cells that are shown, and the rectangle around them.
  void eachCell(FunctionRef<void(const ShownCell&)> use) const;
  [[nodiscard]] const SliceWindow<double>& window() const { return window_; }
  /// The rectangle of a cell that is cut.
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

  CellRows rows_;
  const CutCells* grid_ = nullptr;  // of cells; null for leaves
  std::vector<ShownCell> leaves_;
  int axis_;
  std::int32_t index_ = 0;
  int right_;
  int up_;
  double middle_ = 0;
  SliceWindow<double> window_{};
  std::vector<SectionedCell> sections_;
};

extern template CellLayer::CellLayer(const CutLeaves&, const OctreeCells<float>&, int, double);
extern template CellLayer::CellLayer(const CutLeaves&, const OctreeCells<double>&, int, double);

}  // namespace cutwater::detail
