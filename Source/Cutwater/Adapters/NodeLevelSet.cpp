#include <Cutwater/Adapters/NodeLevelSet.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Fill.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cutwater {

namespace {

using Triple = std::array<std::int64_t, 3>;

Triple triple(const Index3& index) {
  return {index.i, index.j, index.k};
}

Index3 clamped(const Index3& index, const IndexBox& within) {
  return {std::clamp(index.i, within.lo.i, within.hi.i),
          std::clamp(index.j, within.lo.j, within.hi.j),
          std::clamp(index.k, within.lo.k, within.hi.k)};
}

/// The part of a box of nodes that lies within another box or, if none does, the layer nearest to
/// it. It also stands for the other nodes. Indices are relative to the lowest node.
struct InnerNodes {
  IndexBox nodes;  ///< the nodes whose positions the part has
  Triple first{};
  Triple last{};
  Triple size{};  ///< of the whole box

  InnerNodes(const IndexBox& all, const IndexBox& within)
      : nodes{clamped(all.lo, within), clamped(all.hi, within)} {
    const auto lo = triple(all.lo);
    const auto from = triple(nodes.lo);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      size[axis] = static_cast<std::int64_t>(all.length(static_cast<int>(axis)));
      const auto count = static_cast<std::int64_t>(nodes.length(static_cast<int>(axis)));
      first[axis] = std::clamp<std::int64_t>(from[axis] - lo[axis], 0, size[axis] - count);
      last[axis] = first[axis] + count - 1;
    }
  }

  [[nodiscard]] std::int64_t source(std::size_t axis, std::int64_t i) const {
    return std::clamp(i, first[axis], last[axis]);
  }
};

template <std::floating_point T>
T& valueAt(const GridView<T>& view, std::int64_t i, std::int64_t j, std::int64_t k) {
  return view.data[i * view.stride[0] + j * view.stride[1] + k * view.stride[2]];
}

/// The band of distances that node signs and cut edges depend on, in cells of the smallest spacing.
/// Both ends of a cut edge are no farther from the surface than the edge is long; a quarter more
/// keeps rounding out of it. 0, which is no band, if the spacings have no ratio.
template <std::floating_point T>
double bandOf(const Level<T>& level) {
  constexpr double kEdges = 1.25;
  const T longest = maxComponent(level.spacing());
  const double band = kEdges * double{longest} / double{level.smallestSpacing()};
  return std::isfinite(static_cast<T>(band)) ? band : 0;
}

/// Turns the distances of the inner part into the level set, then copies that outwards.
template <std::floating_point T>
void makeLevelSet(const FluidDomain<T>& domain, const InnerNodes& inner,
                  const GridView<T>& values) {
  for (auto k = inner.first[2]; k <= inner.last[2]; ++k) {
    for (auto j = inner.first[1]; j <= inner.last[1]; ++j) {
      for (auto i = inner.first[0]; i <= inner.last[0]; ++i) {
        T& value = valueAt(values, i, j, k);
        value = domain.asLevelSet(value);
      }
    }
  }
  for (std::int64_t k = 0; k < inner.size[2]; ++k) {
    for (std::int64_t j = 0; j < inner.size[1]; ++j) {
      for (std::int64_t i = 0; i < inner.size[0]; ++i) {
        valueAt(values, i, j, k) =
            valueAt(values, inner.source(0, i), inner.source(1, j), inner.source(2, k));
      }
    }
  }
}

}  // namespace

template <std::floating_point T>
NodeLevelSet<T>::NodeLevelSet(const FluidDomain<T>& domain, const Level<T>& level,
                              const IndexBox& within)
    : domain_(domain), level_(level), within_(within) {
  require(level.centering() == Centering::Node, "NodeLevelSet: need a level of nodes");
  for (int axis = 0; axis < 3; ++axis) {
    require(within.length(axis) > 0, "NodeLevelSet: need nodes within", Named{"axis", axis});
  }
}

template <std::floating_point T>
FluidClass NodeLevelSet<T>::classify(const IndexBox& nodes) const {
  return domain_.classify(Box<T>{position(nodes.lo), position(nodes.hi)});
}

template <std::floating_point T>
void NodeLevelSet<T>::fill(const IndexBox& nodes, const GridView<T>& values) const {
  if (nodes.empty()) return;
  const InnerNodes inner(nodes, within_);
  const GridView<T> part{&valueAt(values, inner.first[0], inner.first[1], inner.first[2]),
                         values.stride};
  cutwater::fill(domain_.solid(), GridPatch<T>{level_, inner.nodes}, part,
                 {.band = bandOf(level_)});
  makeLevelSet(domain_, inner, values);
}

template <std::floating_point T>
T NodeLevelSet<T>::intercept(const NodeEdge<T>& edge) const {
  const auto axis = edge.axis;
  const T atNode = level_.position(edge.node)[axis];
  const T atNext = level_.position(edge.next())[axis];
  if (!edge.isCut()) return std::numeric_limits<T>::quiet_NaN();
  if (edge.atNode == 0) return atNode;
  if (edge.atNext == 0) return atNext;

  // From the lower to the upper node, as in edgeCrossings(), so that digits agree.
  Segment<T> segment{position(edge.node), position(edge.node)};
  segment.start[axis] = atNode;
  segment.end[axis] = atNext;
  const bool isFluidFirst = edge.atNode < 0;
  std::optional<T> found;
  domain_.solid().crossings(segment, [&](const Crossing<T>& crossing) {
    found = crossing.point[axis];
    return !isFluidFirst;  // goes on to the last one if that is nearest to the fluid
  });
  if (!found) return isFluidFirst ? atNext : atNode;
  return std::min(std::max(*found, std::nextafter(atNode, atNext)), std::nextafter(atNext, atNode));
}

template <std::floating_point T>
T NodeLevelSet<T>::intercept(const NodeEdge<T>& edge, T before) const {
  const bool wasCut = !std::isnan(before);
  const auto isMovedTo = [&](T value) { return value == 0 || (value > 0 && !wasCut); };
  if (isMovedTo(edge.atNode)) return level_.position(edge.node)[edge.axis];
  if (isMovedTo(edge.atNext)) return level_.position(edge.next())[edge.axis];
  return before;
}

template <std::floating_point T>
Vec3<T> NodeLevelSet<T>::position(const Index3& node) const {
  return level_.position(clamped(node, within_));
}

template class NodeLevelSet<float>;
template class NodeLevelSet<double>;

}  // namespace cutwater
