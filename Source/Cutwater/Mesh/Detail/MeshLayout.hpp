#pragma once

#include <Cutwater/Core/Block.hpp>
#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Mesh/Detail/TriangleSurfaceArrays.hpp>
#include <Cutwater/Triangles/Search/ChildHulls.hpp>

#include <type_traits>

namespace cutwater {

/// Where the arrays of a MeshIndex lie in its block, and values that belong to them.
template <std::floating_point T>
struct MeshLayout {
  typename TriangleSurfaceArrays<T>::Sections surface;
  Section nodes;
  Section slots;
  BvhFrame frame;
  int depth = 0;
  Section packets;
  Section hulls;
  Section hullsOfNode;                    ///< see HullArrays
  CappedWindingArrays::Sections winding;  ///< empty for a closed surface
  double reach = 0;                       ///< see CappedWindingArrays::reach()
  Section insideOut;                      ///< see ShellOrientation
  Section patchNames;                     ///< characters; each name is ended by a zero
  Section fronts;                         ///< see FrontWindings; empty if signs need none
  Section signCells;                      ///< see SignCells; empty if nothing is known

  /// A view of the tree that lies in a block.
  [[nodiscard]] TriangleTree tree(const Block& block) const {
    return {frame, block.array<BvhNode<TriangleTree::kArity>>(nodes),
            block.array<std::uint32_t>(slots), depth};
  }
};

/// Calls visit(type, section) for all arrays in their order in the block; `type` is a
/// std::type_identity of the element type.
template <std::floating_point T, typename Visit>
void visitArrays(MeshLayout<T>& layout, Visit visit) {
  constexpr std::type_identity<std::uint32_t> kIndices;
  constexpr std::type_identity<std::array<std::uint32_t, 3>> kTriples;
  constexpr std::type_identity<BvhNode<TriangleTree::kArity>> kNodes;
  static_assert(TriangleTree::kArity == WindingTree::kArity);
  auto& surface = layout.surface;
  auto& winding = layout.winding;
  visit(std::type_identity<Vec3<T>>(), surface.positions);
  visit(kTriples, surface.triangles);
  visit(kTriples, surface.neighbours);
  visit(kIndices, surface.slivers);
  visit(std::type_identity<Vec3<T>>(), surface.pseudonormals);
  visit(kIndices, surface.polygons);
  visit(kIndices, surface.patches);
  visit(kNodes, layout.nodes);
  visit(kIndices, layout.slots);
  visit(std::type_identity<TrianglePacket>(), layout.packets);
  visit(std::type_identity<ChildHulls>(), layout.hulls);
  visit(kIndices, layout.hullsOfNode);
  visit(std::type_identity<Vec3<double>>(), winding.positions);
  visit(kTriples, winding.triangles);
  visit(kNodes, winding.nodes);
  visit(kIndices, winding.slots);
  visit(std::type_identity<WindingMoments>(), winding.moments);
  visit(std::type_identity<WindingEdges>(), winding.edges);
  visit(std::type_identity<OpenEdge>(), winding.openEdges);
  visit(kIndices, layout.insideOut);
  visit(std::type_identity<char>(), layout.patchNames);
  visit(std::type_identity<std::uint8_t>(), layout.fronts);
  visit(std::type_identity<std::uint8_t>(), layout.signCells);
}

}  // namespace cutwater
