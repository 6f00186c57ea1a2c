#pragma once

#include <Cutwater/Mesh/TrianglePackets.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// What the children of a node lie in besides their boxes: triangles, each with all that is within
/// some distance of it.
///
/// Boxes are no good around slivers that share a vertex: those of the node's frame all begin at
/// that vertex and widen outward, so that a point beside it lies in the boxes of about half of a
/// node's children; triangles meet at the vertex only. Lengths are those of the node's frame.
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

/// Finds hulls for the nodes where they enclose the children much more tightly than boxes do: by
/// their summed area, as boxes are judged.
template <std::floating_point T>
[[nodiscard]] HullArrays buildHulls(std::span<const Vec3<T>> positions,
                                    std::span<const std::array<std::uint32_t, 3>> triangles,
                                    const TriangleTree& tree);

}  // namespace cutwater
