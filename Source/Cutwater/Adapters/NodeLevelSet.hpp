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
  /// Just one end is fluid.
  [[nodiscard]] bool isCut() const { return (atNode < 0) != (atNext < 0); }
};

/// The level set at the nodes of a block-structured mesh: what cut-cell generators ask.
///
/// Nodes beyond the box `within` stand where its nearest node does, so that bodies which reach the
/// domain's faces go on behind them unchanged.
///
/// Values follow the generators' rule, too, that a node where the level set is 0 belongs to the
/// body and that the surface stands there.
template <std::floating_point T>
class NodeLevelSet {
 public:
  /// The domain must outlive it. @throws Error if the level is not one of nodes, or `within` is
  /// empty.
  NodeLevelSet(const FluidDomain<T>& domain, const Level<T>& level,
               const IndexBox& within = everywhere());

  /// Every index that there is: no node is beyond it.
  static constexpr IndexBox everywhere() {
    constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
    constexpr auto kMost = std::numeric_limits<std::int32_t>::max();
    return {{kLeast, kLeast, kLeast}, {kMost, kMost, kMost}};
  }

  /// Of the closed box that the nodes span; of one of zero thickness if there is one layer of them.
  [[nodiscard]] FluidClass classify(const IndexBox& nodes) const;

  /// Sets `values`, whose data is that of the lowest node. In parallel, but serial inside an active
  /// parallel region.
  void fill(const IndexBox& nodes, const GridView<T>& values) const;

  /// Where the surface cuts an edge: the coordinate on its axis. NaN unless it is cut; that of a
  /// node where the level set is 0. Else strictly between the nodes and, of several crossings, the
  /// one nearest to the fluid's node; the body's node if there is none, because the host has
  /// changed the values.
  [[nodiscard]] T intercept(const NodeEdge<T>& edge) const;

  /// The same once the host has set some nodes to 0, which moves the surface there. `before`: where
  /// the edge was cut; if it was not, which is NaN, it is now at the body's node.
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
