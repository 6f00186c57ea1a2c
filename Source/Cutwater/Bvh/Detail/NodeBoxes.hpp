#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Bvh/Detail/FittingAxes.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A child of a K-ary node: the box of its primitives, and their range in NodeContents::order.
struct NodeChild {
  Box<double> box;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The primitives to which the boxes of a tree are fitted.
struct NodeContents {
  std::span<const std::uint32_t> order;  ///< ids, contiguous for each child
  std::span<const Box<double>> boxes;    ///< by id
  const BvhCorners* corners = nullptr;   ///< of triangles; null: only boxes are known
  BvhFrame frame;
};

/// The frame of a tree over primitives in this box. It depends only on the box.
[[nodiscard]] BvhFrame frameOf(const Box<double>& box);

/// The frame of a K-ary node and the boxes of its children in it; see BvhNode.
class NodeBoxes {
 public:
  /// Uses the frame of the tree, or that of fittingAxes() of the triangles, if the summed area of
  /// the boxes is smaller there. The ranges of the children must be in order and without gaps.
  NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children);
  /// Uses a frame with these axes. The boxes are fitted to the corners of the triangles or, if only
  /// boxes are known, to the corners of those.
  NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children, const BoxAxes& axes);

  /// Writes the node's frame and its children's boxes; unused lanes are left unchanged.
  template <int K>
  void write(BvhNode<K>& node) const {
    node.center = center_;
    node.axes = axes_;
    for (std::size_t lane = 0; lane < boxes_.size(); ++lane) {
      const Box<float> child = box(lane);
      for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        node.lower[i][lane] = child.lower[axis];
        node.upper[i][lane] = child.upper[axis];
      }
    }
  }

 private:
  using Corners = std::array<Vec3<double>, 3>;

  static constexpr BoxAxes kAligned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// The child's box, rounded outward.
  [[nodiscard]] Box<float> box(std::size_t child) const;
  void fitAligned();
  void turnIfSmaller();
  [[nodiscard]] Vec3<double> toNode(const Vec3<double>& p) const;
  [[nodiscard]] Corners corners(std::uint32_t place) const;
  [[nodiscard]] BoxAxes axesOfTriangles() const;
  [[nodiscard]] std::vector<Box<double>> boxesAlong(const BoxAxes& axes,
                                                    std::uint32_t stride) const;

  const NodeContents& contents_;
  std::span<const NodeChild> children_;
  std::uint32_t begin_;  // of the primitives of all children
  std::uint32_t end_;
  Vec3<float> center_;
  BoxAxes axes_ = kAligned;
  std::vector<Box<double>> boxes_;
  std::vector<Corners> local_;  // corners relative to the centre, if few
  double rounding_ = 0;
};

}  // namespace cutwater::detail
