#pragma once

#include <Cutwater/CutCells/CutCells.hpp>

#include <cstdint>
#include <vector>

/// An open part of a face, from the volume below it to the one above.
struct OpenPart {
  std::uint32_t below;  ///< ControlVolumes::kNone beyond the box
  std::uint32_t above;
  double area;
  cutwater::Vec3<double> centroid;
  int axis;  ///< across the face
};

/// What a patch has of the wall of a volume.
struct WallPart {
  std::uint32_t patch;
  double area;                    ///< of its vector
  cutwater::Vec3<double> normal;  ///< unit, out of the fluid
  cutwater::Vec3<double> centroid;
};

/// The fluid as volumes between which it flows: the pieces of cut cells, and the cells that are all
/// fluid. A piece with less than a quarter of its cell is joined to what is across its largest open
/// part, so that no value hangs on a sliver; a plate keeps its two sides apart.
class ControlVolumes {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// @param cells  of a box of equal cubes.
  explicit ControlVolumes(const cutwater::CutCells& cells);

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(volumes_.size()); }
  [[nodiscard]] double volume(std::uint32_t n) const { return volumes_[n]; }
  [[nodiscard]] const cutwater::Vec3<double>& centroid(std::uint32_t n) const {
    return centroids_[n];
  }
  /// Whether it is a cell that is all fluid, and nothing else.
  [[nodiscard]] bool isCell(std::uint32_t n) const { return isCell_[n]; }
  [[nodiscard]] const std::vector<WallPart>& walls(std::uint32_t n) const { return walls_[n]; }
  [[nodiscard]] const std::vector<OpenPart>& openParts() const { return openParts_; }
  /// The numbers of its open parts.
  [[nodiscard]] const std::vector<std::uint32_t>& openPartsOf(std::uint32_t n) const {
    return openPartsOf_[n];
  }
  /// That of the cell that a point lies in, the nearest if it has several; kNone in the body.
  [[nodiscard]] std::uint32_t at(const cutwater::Vec3<double>& point) const;
  [[nodiscard]] double width() const { return width_; }  ///< of a cell

 private:
  void addCells(const cutwater::CutCells& cells);
  void addOpenParts(const cutwater::CutCells& cells);
  void addWholeFaces(const cutwater::CutCells& cells, const cutwater::Index3& cell);
  /// The volume that each one becomes a part of.
  [[nodiscard]] std::vector<std::uint32_t> joined(const cutwater::CutCells& cells) const;
  void renumber(const std::vector<std::uint32_t>& into);

  cutwater::IndexBox box_;
  cutwater::Vec3<double> origin_;
  double width_;
  std::vector<cutwater::Vec3<double>> centroids_;
  std::vector<double> volumes_;
  std::vector<bool> isCell_;
  std::vector<std::vector<WallPart>> walls_;
  std::vector<OpenPart> openParts_;
  std::vector<std::vector<std::uint32_t>> openPartsOf_;
  std::vector<std::vector<std::uint32_t>> ofCell_;  // through the box, x fastest
};
