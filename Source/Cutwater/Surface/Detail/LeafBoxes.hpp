#pragma once

#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// The bounding boxes of a leaf's triangles in whole numbers, rounded outward, for comparisons with
/// all of them at once. A unit is a millionth of the leaf, so small leaves keep their digits.
class LeafBoxes {
 public:
  static constexpr std::size_t kWidth = TriangleTree::kLeafWidth;

  /// `boxes`: of the leaf's slots, empty where there is no triangle or none that counts.
  explicit LeafBoxes(std::span<const Box<double>> boxes);

  /// Bit k: the box of slot k may meet the given one, which is not empty. Loses none that does.
  [[nodiscard]] std::uint32_t meeting(const Box<double>& box) const;
  /// The box of all; empty if there is none.
  [[nodiscard]] const Box<double>& all() const { return all_; }

 private:
  using Lanes = std::array<std::int32_t, kWidth>;

  static constexpr std::int32_t kNever = 0x3fffffff;  ///< beyond every box

  /// The sides of a box in the leaf's units.
  [[nodiscard]] std::int32_t first(const Box<double>& box, int axis) const;
  [[nodiscard]] std::int32_t last(const Box<double>& box, int axis) const;

  Box<double> all_;
  Vec3<double> center_;
  Vec3<double> scale_;  ///< units of the boxes below, per length
  std::array<Lanes, 3> lower_{};
  std::array<Lanes, 3> upper_{};
};

}  // namespace cutwater
