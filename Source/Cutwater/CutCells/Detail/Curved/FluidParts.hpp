#pragma once

#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/RulePoints.hpp>

#include <optional>

namespace cutwater {

/// The connected parts of the fluid in a box, or in a rectangle across an axis, as far as points of
/// a grid in it tell: points next to each other are connected if the line between them meets no
/// wall. Grids of 1, 2, 4 and 8 cells along each side are tried until there is one part. What none
/// of these points is connected with is a part of its own.
class FluidParts {
 public:
  /// `spans`: that make up the fluid.
  FluidParts(const FluidField& field, const BoxView& view, std::span<const FluidSpan> spans);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// The part to which a point in the fluid belongs: that of the nearest point known to which a
  /// straight line seems to meet no wall.
  [[nodiscard]] std::uint32_t at(const Vec3<double>& point) const;

 private:
  [[nodiscard]] std::optional<std::uint32_t> partReachedFrom(const Vec3<double>& point,
                                                             std::uint32_t part,
                                                             bool mayTurn) const;
  [[nodiscard]] std::size_t nearestTo(const Vec3<double>& point, std::uint32_t except) const;
  [[nodiscard]] std::optional<std::uint32_t> partSeenFrom(const Vec3<double>& point,
                                                          double value) const;
  void addUnseen(std::span<const FluidSpan> spans);
  void connectCorners(const BoxView& view);
  void connect(int cells);
  void number(std::span<const Vec3<double>> points, std::span<const double> values,
              detail::DisjointSets& sets);
  [[nodiscard]] Vec3<double> pointOf(const std::array<int, 3>& place, int cells) const;
  [[nodiscard]] std::optional<std::uint32_t> alongLines(
      const Vec3<double>& point, int places,
      FunctionRef<std::optional<std::uint32_t>(const Vec3<double>& place)> find) const;
  /// Whether a line from a point with a value to one of the grid meets no wall for certain, and
  /// whether it seems so.
  [[nodiscard]] bool isCertain(const Vec3<double>& from, double atFrom, std::size_t to) const;
  [[nodiscard]] bool isClear(const Vec3<double>& from, double atFrom, std::size_t to) const;

  const FluidField* field_;
  Box<double> box_;
  std::array<bool, 3> isFlat_{};
  std::size_t count_ = 0;
  std::vector<Vec3<double>> points_;   // in the fluid: of the grid, and those that none of it sees
  std::vector<double> values_;         // there
  std::vector<std::uint32_t> partOf_;  // of each
};

}  // namespace cutwater
