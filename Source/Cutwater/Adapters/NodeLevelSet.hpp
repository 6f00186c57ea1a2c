#pragma once

#include <Cutwater/Adapters/FluidDomain.hpp>
#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Core/Level.hpp>

namespace cutwater {

/// The edge from a node to the next one along an axis, with the level set at both.
template <std::floating_point T>
struct NodeEdge {
  Index3 node;
  int axis = 0;
  T atNode{};
  T atNext{};

  /// The node at the other end.
  [[nodiscard]] Index3 next() const {
    auto result = node;
    ++(axis == 0 ? result.i : axis == 1 ? result.j : result.k);
    return result;
  }
  /// Whether exactly one end is fluid.
  [[nodiscard]] bool isCut() const { return (atNode < 0) != (atNext < 0); }
};

/// The level set at the nodes of a block-structured mesh, as cut-cell generators query it.
///
/// Nodes outside the box `within` take the position of its nearest node, so that bodies that reach
/// the faces of the domain continue beyond them unchanged.
///
/// Values also follow the generators' rule that a node where the level set is 0 belongs to the
/// body, and that the surface passes through it.
template <std::floating_point T>
class NodeLevelSet {
 public:
  /// The domain must outlive this object. @throws Error if the level is not one of nodes, or
  /// `within` is empty.
  NodeLevelSet(const FluidDomain<T>& domain, const Level<T>& level,
               const IndexBox& within = everywhere());

  /// All possible indices: no node is outside.
  static constexpr IndexBox everywhere() {
    constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
    constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
    return {{kLeast, kLeast, kLeast}, {kMost, kMost, kMost}};
  }

  /// Classifies the closed box that the nodes span; its thickness is zero for one layer of nodes.
  [[nodiscard]] FluidClass classify(const IndexBox& nodes) const;

  /// Sets `values`, whose `data` points at the value of the lowest node. Where the level set is
  /// more than 1.25 times the longest spacing, which no end of a cut edge is, it becomes plus or
  /// minus that: such nodes are found by blocks. Runs in parallel, but serially inside an active
  /// parallel region.
  void fill(const IndexBox& nodes, const GridView<T>& values) const;

  /// The coordinate, on the axis of an edge, at which the surface cuts it. NaN unless the edge is
  /// cut; that of a node where the level set is 0. Otherwise that of the crossing nearest to the
  /// fluid's node, strictly between the nodes; that of the body's node if there is none because the
  /// application has changed the values.
  [[nodiscard]] T intercept(const NodeEdge<T>& edge) const;

  /// The same after the application has set some nodes to 0, which moves the surface there.
  /// `before`: the previous intercept; if it is NaN (not cut), the new one is at the body's node.
  [[nodiscard]] T intercept(const NodeEdge<T>& edge, T before) const;

 private:
  [[nodiscard]] Vec3<T> position(const Index3& node) const;  // of the nearest node within

  const FluidDomain<T>& domain_;
  Level<T> level_;
  IndexBox within_;
};

extern template class NodeLevelSet<float>;
extern template class NodeLevelSet<double>;

}  // namespace cutwater
