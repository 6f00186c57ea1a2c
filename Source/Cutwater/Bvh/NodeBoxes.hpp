#pragma once

#include <Cutwater/Bvh/BinaryBvh.hpp>
#include <Cutwater/Bvh/BvhBuilder.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater::detail {

/// The frame of a K-ary node and the boxes of its children in it; see BvhNode.
///
/// The frame is that of the tree, or one along the mean normal of the triangles and their longest
/// extent across it, where the summed area of the boxes is smaller there.
class NodeBoxes {
 public:
  /// `children`: nodes of the binary tree. `corners`: of triangles; null: only their boxes count.
  NodeBoxes(const BinaryBvh& tree, std::span<const std::uint32_t> children, const BvhFrame& frame,
            const BvhCorners* corners);

  [[nodiscard]] const Vec3<float>& center() const { return center_; }
  [[nodiscard]] const std::array<Vec3<float>, 3>& axes() const { return axes_; }
  /// Encloses the child, rounding included.
  [[nodiscard]] Box<float> box(std::size_t child) const;

 private:
  using Axes = std::array<Vec3<float>, 3>;

  using Corners = std::array<Vec3<double>, 3>;

  [[nodiscard]] Corners corners(std::uint32_t place) const;
  [[nodiscard]] Axes fittingAxes() const;
  [[nodiscard]] std::vector<Box<double>> boxesAlong(const Axes& axes, std::uint32_t stride) const;

  const BinaryBvh& tree_;
  std::span<const std::uint32_t> children_;
  const BvhFrame& frame_;
  const BvhCorners* corners_;
  Vec3<float> center_;
  Axes axes_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::vector<Box<double>> boxes_;
  std::uint32_t begin_ = 0;  // of the triangles of all children in BinaryBvh::order
  std::uint32_t end_ = 0;
  std::vector<Corners> local_;  // their corners relative to the centre, if they are few
  double rounding_ = 0;
};

}  // namespace cutwater::detail
