#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace cutwater {

/// A box, a rectangle or a segment in 2^n parts along each axis that it extends along, each of
/// which is certainly body, certainly fluid, or neither is certain.
class CertainParts {
 public:
  enum class Part : std::uint8_t { Body, Fluid, Open };
  using Place = std::array<std::size_t, 3>;

  /// One part. Views the field.
  CertainParts(const FluidField& field, const Box<double>& box) : field_(field), box_(box) {
    for (int axis = 0; axis < 3; ++axis) isFlat_[place(axis)] = box.size()[axis] == 0;
  }

  /// Divides each part in two along each axis.
  void halve();
  /// How many boxes that takes to look at.
  [[nodiscard]] std::size_t costOfHalving() const {
    std::size_t cost = open_;
    for (const bool isFlat : isFlat_) cost *= isFlat ? 1 : 2;
    return cost;
  }
  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  /// The share of the parts of which nothing is certain.
  [[nodiscard]] double openShare() const {
    return static_cast<double>(open_) / static_cast<double>(parts_.size());
  }
  [[nodiscard]] std::size_t side() const { return side_; }

  /// Calls visit(number of the part, place); x fastest.
  template <typename Visit>
  void forEach(const Visit& visit) const {
    std::uint32_t number = 0;
    Place at{};
    for (at[2] = 0; at[2] < sideAlong(2); ++at[2]) {
      for (at[1] = 0; at[1] < sideAlong(1); ++at[1]) {
        for (at[0] = 0; at[0] < sideAlong(0); ++at[0]) visit(number++, at);
      }
    }
  }
  /// Calls visit(one, other) with the numbers of parts that share a face.
  template <typename Visit>
  void forNeighbours(const Visit& visit) const {
    forEach([&](std::uint32_t number, const Place& at) {
      std::size_t step = 1;
      for (std::size_t a = 0; a < 3; ++a) {
        if (at[a] > 0) visit(static_cast<std::uint32_t>(number - step), number);
        step *= sideAlong(a);
      }
    });
  }

 private:
  static constexpr std::size_t place(int axis) { return static_cast<std::size_t>(axis); }
  [[nodiscard]] std::size_t sideAlong(std::size_t a) const { return isFlat_[a] ? 1 : side_; }
  [[nodiscard]] Part classOf(const Place& at) const;

  const FluidField& field_;
  Box<double> box_;
  std::array<bool, 3> isFlat_{};
  std::size_t side_ = 1;
  std::vector<Part> parts_{Part::Open};
  std::size_t open_ = 1;  // number of such parts
};

}  // namespace cutwater
