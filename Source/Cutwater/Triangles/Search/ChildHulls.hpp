#pragma once

#include <Cutwater/Triangles/Search/TrianglePacket.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// Enclosures of a node's children besides their boxes: for each, a triangle and everything within
/// some distance of it.
///
/// Boxes are a poor fit around slivers that share a vertex: in the node's frame they all begin at
/// that vertex and widen outward, so a point beside it lies in the boxes of about half of a node's
/// children, whereas the triangles meet only at the vertex. Lengths are in the node's frame.
struct alignas(64) ChildHulls {
  TrianglePacket triangles;  ///< by lane
  TrianglePacket::Lanes thickness;
};
static_assert(sizeof(ChildHulls) == sizeof(TrianglePacket) + sizeof(TrianglePacket::Lanes),
              "no byte of it is left undefined");

/// The hulls of a tree's nodes. Most trees have none.
struct HullArrays {
  std::vector<ChildHulls> hulls;
  std::vector<std::uint32_t> ofNode;  ///< index of its hulls, or kNone; empty if there are none
};

/// Finds hulls for the nodes where they enclose the children much more tightly than boxes do,
/// measured by summed area, as for boxes.
template <std::floating_point T>
[[nodiscard]] HullArrays buildHulls(std::span<const Vec3<T>> positions,
                                    std::span<const std::array<std::uint32_t, 3>> triangles,
                                    const TriangleTree& tree);

}  // namespace cutwater
