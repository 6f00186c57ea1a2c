#pragma once

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>

namespace cutwater {

/// The connected parts of the fluid in a box, or in a rectangle across an axis, as far as points of
/// a grid in it tell: points next to each other are connected if the line between them meets no
/// wall. Grids of 1, 2, 4 and 8 cells along each side are tried until there is one part.
class FluidParts {
 public:
  FluidParts(const FluidField& field, const BoxView& view);

  /// 0 if no point of the grid is in the fluid.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// The part to which a point in the fluid belongs: that of the nearest point of the grid to which
  /// a straight line seems to meet no wall.
  [[nodiscard]] std::uint32_t at(const Vec3<double>& point) const;

 private:
  void connectCorners(const BoxView& view);
  void connect(int cells);
  void number(std::span<const Vec3<double>> points, std::span<const double> values,
              detail::DisjointSets& sets);
  [[nodiscard]] Vec3<double> pointOf(const std::array<int, 3>& place, int cells) const;
  [[nodiscard]] bool isClear(const Vec3<double>& from, const Vec3<double>& to) const;

  const FluidField* field_;
  Box<double> box_;
  std::array<bool, 3> isFlat_{};
  std::size_t count_ = 0;
  std::vector<Vec3<double>> points_;   // of the grid, in the fluid; only if there are several parts
  std::vector<std::uint32_t> partOf_;  // of each
};

}  // namespace cutwater
