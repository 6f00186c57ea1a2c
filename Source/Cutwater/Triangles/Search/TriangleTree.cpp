#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

namespace cutwater {

template <std::floating_point T>
TriangleTreeArrays buildTriangleTree(std::span<const Vec3<T>> positions,
                                     std::span<const std::array<std::uint32_t, 3>> triangles) {
  const auto corners = [&](std::uint32_t id) { return cornersOf(positions, triangles[id]); };
  return buildTurnedBvh<TriangleTree::kArity, TriangleTree::kLeafWidth>(
      triangleBoxes(positions, triangles), corners);
}

template <std::floating_point T>
TriangleTreeArrays refittedTriangleTree(const TriangleTree& tree,
                                        std::span<const Vec3<T>> positions,
                                        std::span<const std::array<std::uint32_t, 3>> triangles) {
  const auto corners = [&](std::uint32_t id) { return cornersOf(positions, triangles[id]); };
  TriangleTreeArrays result{.frame = tree.frame(),
                            .nodes = {tree.nodes().begin(), tree.nodes().end()},
                            .slots = {tree.slots().begin(), tree.slots().end()},
                            .depth = tree.depth()};
  refitTurnedBvh(result, triangleBoxes(positions, triangles), corners);
  return result;
}

template TriangleTreeArrays buildTriangleTree(std::span<const Vec3<float>>,
                                              std::span<const std::array<std::uint32_t, 3>>);
template TriangleTreeArrays buildTriangleTree(std::span<const Vec3<double>>,
                                              std::span<const std::array<std::uint32_t, 3>>);
template TriangleTreeArrays refittedTriangleTree(const TriangleTree&, std::span<const Vec3<float>>,
                                                 std::span<const std::array<std::uint32_t, 3>>);
template TriangleTreeArrays refittedTriangleTree(const TriangleTree&, std::span<const Vec3<double>>,
                                                 std::span<const std::array<std::uint32_t, 3>>);

}  // namespace cutwater
