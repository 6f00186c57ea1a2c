#pragma once

#include <Cutwater/Bvh/BvhBuilder.hpp>

#include <array>
#include <span>
#include <vector>

namespace cutwater::detail {

/// A child of a K-ary node: the box of its primitives, and their range in an order of all.
struct NodeChild {
  Box<double> box;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// What the boxes of a tree are fitted to.
struct NodeContents {
  std::span<const std::uint32_t> order;  ///< ids, those of each child in a row
  std::span<const Box<double>> boxes;    ///< by id
  const BvhCorners* corners = nullptr;   ///< of triangles; null: only their boxes count
  BvhFrame frame;
};

/// The frame of a tree over primitives in this box. It depends on nothing else.
[[nodiscard]] BvhFrame frameOf(const Box<double>& box);

/// The frame of a K-ary node and the boxes of its children in it; see BvhNode.
class NodeBoxes {
 public:
  using Axes = std::array<Vec3<float>, 3>;

  /// In the frame of the tree, or in one along the mean normal of the triangles and their longest
  /// extent across it, where the summed area of the boxes is smaller there. The children come in
  /// order, and leave nothing out.
  NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children);
  /// In a frame with these axes: fitted to corners of triangles or, if only boxes are known, to
  /// theirs.
  NodeBoxes(const NodeContents& contents, std::span<const NodeChild> children, const Axes& axes);

  /// Moves the node's frame and its children's boxes; the lanes beyond stay as they are.
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

  static constexpr Axes kAligned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// Encloses the child, rounding included.
  [[nodiscard]] Box<float> box(std::size_t child) const;
  void fitAligned();
  void turnIfSmaller();
  [[nodiscard]] Vec3<double> toNode(const Vec3<double>& p) const;
  [[nodiscard]] Corners corners(std::uint32_t place) const;
  [[nodiscard]] Axes fittingAxes() const;
  [[nodiscard]] std::vector<Box<double>> boxesAlong(const Axes& axes, std::uint32_t stride) const;

  const NodeContents& contents_;
  std::span<const NodeChild> children_;
  std::uint32_t begin_;  // of the primitives of all children
  std::uint32_t end_;
  Vec3<float> center_;
  Axes axes_ = kAligned;
  std::vector<Box<double>> boxes_;
  std::vector<Corners> local_;  // corners relative to the centre, if they are few
  double rounding_ = 0;
};

}  // namespace cutwater::detail
